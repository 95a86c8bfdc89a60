/// A small picture of a demonstration's paths on the board, drawn in place.
#pragma once

#include <map>
#include <memory>

#include "engine/workbench/path_sketch.h"
#include "ui/widgets/ui.h"

namespace trocar::ui {

/// Both arms' paths over the pegs, each part in the colour of its segment; the left arm's end is a dot, the right one's
/// a square, so that they are told apart without colour. `place` should be as 3 to 2. No item of its own.
void draw_sketch(const Ui& ui, const workbench::PathSketch& sketch, const Rect& place);

/// Sketches of demonstrations, made when first asked for. Threads: that of the window.
class SketchCache {
 public:
  const workbench::PathSketch& of(const std::shared_ptr<const demonstration::Demonstration>& document);

 private:
  struct Kept {
    std::shared_ptr<const demonstration::Demonstration> of;
    workbench::PathSketch sketch;
  };
  std::map<demonstration::DemonstrationId, Kept> kept_;
};

}  // namespace trocar::ui
