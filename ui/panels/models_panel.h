/// Two models beside each other: one slice with one scale for both, their difference, where the policy changed, and
/// what they measure in a table.
#pragma once

#include <array>

#include "ui/panel.h"
#include "ui/panels/field_shading.h"
#include "ui/panels/seed_page.h"

namespace trocar::ui {

class ModelsPanel final : public Panel {
 public:
  Requests draw(Ui& ui, const WorkbenchState& state) override;

 private:
  /// What the pictures show.
  enum class Mode { kSideBySide, kSwipe, kBlink, kDifference, kPolicy, kOutcomes };
  void draw_choice(Ui& ui, const WorkbenchState& state, Requests& requests);
  void draw_pictures(Ui& ui, const WorkbenchState& state, Requests& requests);
  void draw_axis(Ui& ui, const WorkbenchState& state, Requests& requests);
  /// A and B in one square, the border between them dragged with the mouse.
  void draw_swipe(Ui& ui, const WorkbenchState& state, float side);
  void draw_shared_legend(Ui& ui, const WorkbenchState& state, Requests& requests);

  Mode mode_ = Mode::kSideBySide;
  int axis_ = 2;
  float swipe_ = 0.5F;
  bool b_in_front_ = false;
  double blinked_s_ = 0.0;
  SeedPage seed_page_;
  std::array<FieldShading, 3> shadings_;  ///< A, B, and what compares them.
};

}  // namespace trocar::ui
