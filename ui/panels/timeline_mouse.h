/// What the mouse does over the timeline: scrub, select, trim by the gates, pan and zoom.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "ui/panel.h"
#include "ui/panels/timeline_lanes.h"

namespace trocar::ui {

/// What the mouse works on, for one frame.
struct TimelineGround {
  const WorkbenchState& state;
  const demonstration::Demonstration& shown;
  const LaneLayout& layout;
  std::vector<double> places;  ///< What is dragged snaps to them.
  double length_s = 0.0;
};

/// A left drag on the ruler moves the playhead, on the lanes selects time, on a gate trims; the middle button zooms to
/// what is dragged over, the right one pans. A drag is previewed each frame and commits once, when released; Esc takes
/// it back.
class TimelineMouse {
 public:
  enum class Drag : std::uint8_t { kNone, kScrub, kSelect, kGateIn, kGateOut, kPan, kZoom };

  /// Call after the area's widget was drawn. Moves `range` at once.
  void take(Ui& ui, const TimelineGround& ground, bool hovered, TimeRange& range, Requests& requests);
  /// Ends what is under way without a trace.
  void reset() { drag_ = Drag::kNone; }

  Drag drag() const { return drag_; }
  bool trims() const { return drag_ == Drag::kGateIn || drag_ == Drag::kGateOut; }
  /// As shown: they follow the mouse while dragged.
  double gate_in_s(const demonstration::Demonstration& shown) const;
  double gate_out_s(const demonstration::Demonstration& shown) const;
  /// The place that the drag has gone to by itself.
  std::optional<double> snapped_s() const { return snapped_s_; }
  /// What a drag of the middle button is over.
  std::optional<workbench::TimeSpan> zoomed() const;

 private:
  /// What is to be seen side by side: the gates while one is dragged, the ends of the selection while one is.
  std::optional<workbench::TimeSpan> edges(const TimelineGround& ground) const;
  Drag what_is_at(const Ui& ui, const TimelineGround& ground, ImVec2 mouse) const;
  void show_what_is_under(Ui& ui, Drag under) const;
  void press(const Ui& ui, const TimelineGround& ground, Drag under);
  void move(const Ui& ui, const TimelineGround& ground, TimeRange& range, Requests& requests);
  void release(const TimelineGround& ground, TimeRange& range, Requests& requests);
  void cancel(Requests& requests);
  void double_click(const TimelineGround& ground, Requests& requests);
  void take_drag(Ui& ui, const TimelineGround& ground, bool hovered, TimeRange& range, Requests& requests);
  void take_wheel(const TimelineGround& ground, TimeRange& range) const;
  double time_of_mouse(const Ui& ui, const TimelineGround& ground);

  Drag drag_ = Drag::kNone;
  bool moved_ = false;  ///< Far enough to be no click.
  bool edge_ = false;   ///< An end of the selection is dragged.
  float pressed_x_ = 0.0F;
  double anchor_s_ = 0.0;   ///< The end of the selection or zoom that stays.
  double current_s_ = 0.0;  ///< Where the mouse is in time.
  std::optional<double> snapped_s_;
  std::optional<workbench::TimeSpan> selection_before_;
};

}  // namespace trocar::ui
