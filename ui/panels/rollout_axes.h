/// Parallel coordinates: every measure of the listed rollouts on an axis of its own, each rollout a line across them.
#pragma once

#include "ui/panel.h"
#include "ui/panels/rollout_brush.h"

namespace trocar::ui {

/// A drag along an axis keeps the rollouts in that range, a click on it lets go of it.
class RolloutAxes {
 public:
  void draw(Ui& ui, const WorkbenchState& state, RolloutBrush& brush);

 private:
  struct Ends {
    double low = 0.0;
    double high = 0.0;
  };
  void axis(Ui& ui, RolloutBrush& brush, std::size_t place, ImVec2 size);
  void take_mouse(Ui& ui, RolloutBrush& brush, learning::RolloutMeasure measure, const Ends& ends, const Rect& line);
  void draw_all(Ui& ui, const WorkbenchState& state, RolloutBrush& brush, ImVec2 each);
  void draw_lines(Ui& ui, const WorkbenchState& state, const RolloutBrush& brush) const;
  void draw_axes(Ui& ui, const RolloutBrush& brush) const;

  std::vector<Rect> lines_;  ///< Where each axis runs, from top to bottom, in this frame.
  std::vector<Ends> ends_;
  float pressed_y_ = 0.0F;
};

/// How many rollouts are brushed, and a button that lets go of all ranges; nothing without a range.
void draw_brushed(Ui& ui, RolloutBrush& brush);

}  // namespace trocar::ui
