/// The selected demonstration over time: play, scrub, select, see what happens in its lanes, and trim by
/// dragging the gates.
#pragma once

#include <memory>
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
  bool escapes(const Ui& ui) const;

  std::shared_ptr<SharedTime> time_;
  TimeRange& range_ = time_->range;
  LaneData data_;
  LaneSet lanes_ = LaneSet().set();
  TimelineMouse mouse_;
  TimelineTools tools_;
  workbench::DemonstrationId fitted_;
};

}  // namespace trocar::ui
