/// The selected demonstration over time: play, scrub, select, see what happens in its lanes, and trim by
/// dragging the gates.
#pragma once

#include <memory>
#include <optional>
#include <utility>

#include "ui/panel.h"
#include "ui/panels/lane_data.h"
#include "ui/panels/timeline_mouse.h"
#include "ui/panels/timeline_tools.h"

namespace trocar::ui {

class TimelinePanel final : public Panel {
 public:
  explicit TimelinePanel(std::shared_ptr<SharedTime> time) : time_(std::move(time)) {}
  Requests draw(Ui& ui, const WorkbenchState& state) override;

 private:
  void fit(const WorkbenchState& state, const demonstration::Demonstration& shown);
  void draw_transport(Ui& ui, const WorkbenchState& state, const demonstration::Demonstration& shown,
                      Requests& requests);
  void draw_time(Ui& ui, const WorkbenchState& state, const demonstration::Demonstration& shown) const;
  void draw_speed(Ui& ui, const WorkbenchState& state, const demonstration::Demonstration& shown, Requests& requests);
  void draw_lane_area(Ui& ui, const WorkbenchState& state, const demonstration::Demonstration& shown,
                      Requests& requests);
  /// Lanes that are higher than their room are scrolled by the bar at their right, or by the wheel over their names.
  void scroll_lanes(Ui& ui, const LaneLayout& layout, float content, bool hovered);
  /// What the ruler counts, beside it: a click goes on to the next unit. True while it has the mouse.
  bool take_ruler_unit(Ui& ui, const LaneLayout& layout, bool hovered);
  void draw_live(Ui& ui, const WorkbenchState& state);
  /// What the lanes show that is worked out behind the window.
  void ask(const Ui& ui, const LaneLayout& layout, Requests& requests);
  bool escapes(const Ui& ui) const;

  std::shared_ptr<SharedTime> time_;
  TimeRange& range_ = time_->range;
  LaneData data_;
  LaneData live_;
  LaneSet lanes_;
  float scroll_ = 0.0F;           ///< How far the lanes are scrolled up, pixels.
  std::optional<float> grabbed_;  ///< Where in the bar's thumb the mouse holds it.
  bool unit_held_ = false;        ///< The mouse went down on the ruler's unit.
  workbench::ShowFilmstrip asked_;
  TimelineMouse mouse_;
  TimelineTools tools_;
  workbench::DemonstrationId fitted_;
};

}  // namespace trocar::ui
