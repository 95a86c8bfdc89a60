/// Parallel coordinates: every measure of the listed rollouts on an axis of its own, each rollout a line across them.
#pragma once

#include <optional>
#include <vector>

#include "ui/panel.h"
#include "ui/panels/rollout_brush.h"

namespace trocar::ui {

/// A drag along an axis keeps the rollouts in that range, a click on what is kept lets go of it. A click on a line
/// makes its rollout stand out, as one on a row of the table.
class RolloutAxes {
 public:
  void draw(Ui& ui, const WorkbenchState& state, RolloutBrush& brush, Requests& requests);

 private:
  struct Ends {
    double low = 0.0;
    double high = 0.0;
  };
  void axis(Ui& ui, RolloutBrush& brush, std::size_t place, ImVec2 size);
  using Line = std::vector<ImVec2>;
  /// Those that are drawn; above 300, evenly.
  std::vector<std::size_t> drawn_of(const WorkbenchState& state) const;
  Line line_of(const RolloutBrush& brush, std::size_t place) const;
  /// The one under the mouse, by its place among the listed; brushed ones before others.
  std::optional<std::size_t> pointed(const Ui& ui, const WorkbenchState& state, const RolloutBrush& brush) const;
  void take_click(Ui& ui, const WorkbenchState& state, RolloutBrush& brush, Requests& requests);
  void take_mouse(Ui& ui, RolloutBrush& brush, learning::RolloutMeasure measure, const Ends& ends, const Rect& line);
  void draw_all(Ui& ui, const WorkbenchState& state, RolloutBrush& brush, ImVec2 each, Requests& requests);
  void draw_lines(Ui& ui, const WorkbenchState& state, const RolloutBrush& brush) const;
  void draw_axes(Ui& ui, const RolloutBrush& brush) const;

  std::vector<Rect> lines_;  ///< Where each axis runs, from top to bottom, in this frame.
  std::vector<Ends> ends_;
  float pressed_y_ = 0.0F;
  std::optional<learning::RolloutMeasure> clicked_;  ///< On whose axis, in this frame.
};

/// How many rollouts are brushed, and a button that lets go of all ranges; nothing without a range.
void draw_brushed(Ui& ui, RolloutBrush& brush);

}  // namespace trocar::ui
