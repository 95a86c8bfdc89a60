/// The selected demonstration's curves over time: position, speed, acceleration, jerk and jaw of both arms, stacked.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "ui/panel.h"
#include "ui/widgets/plot.h"

namespace trocar::ui {

class CurvesPanel final : public Panel {
 public:
  explicit CurvesPanel(std::shared_ptr<SharedTime> time) : time_(std::move(time)) {}
  Requests draw(Ui& ui, const WorkbenchState& state) override;

 private:
  void draw_choice(Ui& ui, const WorkbenchState& state, const demonstration::Demonstration& shown);
  void draw_plots(Ui& ui, const WorkbenchState& state, const demonstration::Demonstration& shown, Requests& requests);
  void draw_plot(Ui& ui, const WorkbenchState& state, const demonstration::Demonstration& shown,
                 workbench::CurveKind kind, float height, bool time_axis, Requests& requests);

  std::shared_ptr<SharedTime> time_;
  workbench::CurveKinds kinds_ =
      workbench::bit(workbench::CurveKind::kSpeed) | workbench::bit(workbench::CurveKind::kJerk);
  bool before_ = true;              ///< Show what was before the edits.
  std::optional<double> cursor_s_;  ///< Under the pointer in the last frame, in whichever plot.
  std::optional<double> next_cursor_s_;
};

}  // namespace trocar::ui
