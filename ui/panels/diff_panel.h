/// The selected demonstration against its original, its past or another one: numbers, deviation over time, and what is
/// drawn of it in the 3-D view.
#pragma once

#include <memory>
#include <optional>
#include <utility>

#include "ui/panel.h"

namespace trocar::ui {

/// What is compared with what is the workbench's; the panel keeps but its cursor.
class DiffPanel final : public Panel {
 public:
  explicit DiffPanel(std::shared_ptr<SharedTime> time) : time_(std::move(time)) {}
  Requests draw(Ui& ui, const WorkbenchState& state) override;

 private:
  void draw_choice(Ui& ui, const WorkbenchState& state, const workbench::ComparisonSettings& settings,
                   Requests& requests) const;
  void draw_result(Ui& ui, const WorkbenchState& state, const workbench::ComparisonView& view, Requests& requests);
  void draw_deviation(Ui& ui, const WorkbenchState& state, const workbench::ComparisonView& view, Requests& requests);

  std::shared_ptr<SharedTime> time_;
  std::optional<double> cursor_s_;  ///< Under the pointer in the last frame.
};

}  // namespace trocar::ui
