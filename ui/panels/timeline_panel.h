/// The selected demonstration over time: play, scrub, see segments and jaws, and trim by dragging the gates.
#pragma once

#include <optional>

#include "ui/panel.h"
#include "ui/panels/lane_data.h"
#include "ui/panels/timeline_lanes.h"

namespace trocar::ui {

class TimelinePanel final : public Panel {
 public:
  Requests draw(Ui& ui, const WorkbenchState& state) override;

 private:
  enum class Drag { kNone, kScrub, kGateIn, kGateOut, kPan };

  void fit(const WorkbenchState& state, const demonstration::Demonstration& shown);
  void draw_transport(Ui& ui, const WorkbenchState& state, const demonstration::Demonstration& shown,
                      Requests& requests);
  void draw_time(Ui& ui, const WorkbenchState& state, const demonstration::Demonstration& shown) const;
  void draw_speed(Ui& ui, const WorkbenchState& state, const demonstration::Demonstration& shown, Requests& requests);
  void draw_lane_area(Ui& ui, const WorkbenchState& state, const demonstration::Demonstration& shown,
                      Requests& requests);
  void take_mouse(Ui& ui, const LaneLayout& layout, bool hovered, const WorkbenchState& state,
                  const demonstration::Demonstration& shown, Requests& requests);
  Drag what_is_at(const Ui& ui, const LaneLayout& layout, ImVec2 mouse) const;
  void finish_drag(const WorkbenchState& state, const demonstration::Demonstration& shown, Requests& requests);
  void draw_gates(Ui& ui, const LaneLayout& layout) const;
  void draw_playhead(Ui& ui, const LaneLayout& layout, double t_s) const;
  void take_wheel(const LaneLayout& layout, double length_s);

  TimeRange range_;
  LaneData data_;
  workbench::DemonstrationId fitted_;
  Drag drag_ = Drag::kNone;
  double gate_in_s_ = 0.0;  ///< Shown; follows the mouse while dragged.
  double gate_out_s_ = 0.0;
};

}  // namespace trocar::ui
