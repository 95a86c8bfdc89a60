/// Draws the timeline's ruler and lanes; knows nothing of the mouse.
#pragma once

#include <bitset>
#include <cstdint>
#include <span>
#include <string_view>

#include "engine/review/review.h"
#include "ui/panels/lane_data.h"
#include "ui/panels/time_range.h"
#include "ui/widgets/widgets.h"

namespace trocar::ui {

/// From top to bottom.
enum class Lane : std::uint8_t {
  kSegments,
  kAuthority,
  kJawLeft,
  kJawRight,
  kHolds,
  kPedals,
  kNotes,
  kProblems,
  kEdits,
  kOriginal
};
constexpr std::size_t kLaneCount = 10;
using LaneSet = std::bitset<kLaneCount>;
constexpr bool has(const LaneSet& lanes, Lane lane) {
  return lanes[static_cast<std::size_t>(lane)];
}
/// "Jaw L", and a sentence about what it shows.
std::string_view name_of(Lane lane);
std::string_view help_of(Lane lane);

struct LaneLayout {
  Rect names;  ///< Column of the lanes' names.
  Rect ruler;
  Rect gates;  ///< Between ruler and lanes: what is used, from gate to gate.
  Rect lanes;  ///< Times run from `lanes.x0` to `lanes.x1`.
  TimeRange range;
  double gate_in_s = 0.0;
  double gate_out_s = 0.0;

  float x_of(double t_s) const { return range.x_of(t_s, lanes.x0, lanes.width()); }
  double time_at(float x) const { return range.time_at(x, lanes.x0, lanes.width()); }
};

LaneLayout lay_out(const Ui& ui, const Rect& area, const TimeRange& range);
/// What ruler, gates and the shown lanes take, pixels.
float lanes_height(const Ui& ui, const LaneSet& shown);
void draw_ruler(Ui& ui, const LaneLayout& layout);
/// The shown lanes from the top. Words stand between the gates, and times of segments are cut to them.
void draw_lanes(Ui& ui, const LaneLayout& layout, const LaneSet& lanes, const demonstration::Demonstration& shown,
                const LaneData& data, std::span<const review::Problem> problems);

}  // namespace trocar::ui
