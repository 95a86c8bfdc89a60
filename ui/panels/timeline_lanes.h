/// Draws the timeline's ruler and lanes; knows nothing of the mouse.
#pragma once

#include <bitset>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>

#include "engine/review/review.h"
#include "engine/workbench/curves.h"
#include "engine/workbench/filmstrip.h"
#include "ui/panels/lane_data.h"
#include "ui/panels/time_range.h"
#include "ui/widgets/widgets.h"

namespace trocar::ui {

/// From top to bottom.
enum class Lane : std::uint8_t {
  kPictures,
  kSegments,
  kAuthority,
  kJawLeft,
  kJawRight,
  kHolds,
  kPedals,
  kNotes,
  kProblems,
  kEdits,
  kOriginal,
  kX,
  kY,
  kZ,
  kSpeed,
  kAcceleration,
  kJerk,
  kClearance
};
constexpr std::size_t kLaneCount = 18;
using LaneSet = std::bitset<kLaneCount>;
constexpr bool has(const LaneSet& lanes, Lane lane) {
  return lanes[static_cast<std::size_t>(lane)];
}
/// "Jaw L", and a sentence about what it shows.
std::string_view name_of(Lane lane);
std::string_view help_of(Lane lane);
/// The curve that a lane shows, if it shows one.
std::optional<workbench::CurveKind> curve_of(Lane lane);
/// The curves that the lanes need.
workbench::CurveKinds curves_of(const LaneSet& lanes);

struct LaneLayout {
  Rect names;  ///< Column of the lanes' names.
  Rect ruler;
  Rect gates;  ///< Between ruler and lanes: what is used, from gate to gate.
  Rect lanes;  ///< Times run from `lanes.x0` to `lanes.x1`.
  TimeRange range;
  float scroll = 0.0F;  ///< How far the lanes are scrolled up, pixels.
  double gate_in_s = 0.0;
  double gate_out_s = 0.0;

  float x_of(double t_s) const { return range.x_of(t_s, lanes.x0, lanes.width()); }
  double time_at(float x) const { return range.time_at(x, lanes.x0, lanes.width()); }
};

LaneLayout lay_out(const Ui& ui, const Rect& area, const TimeRange& range, float scroll = 0.0F);
/// What ruler and gates take, and what the shown lanes take, pixels.
float lanes_head(const Ui& ui);
float lanes_height(const Ui& ui, const LaneSet& shown);
/// `step_times`: where the left tool goes on by a cell of the lattice, for a ruler in grid steps.
void draw_ruler(Ui& ui, const LaneLayout& layout, RulerUnit unit, std::span<const double> step_times);

/// What the lanes show, for one frame.
struct LaneGround {
  const demonstration::Demonstration& shown;
  const LaneData& data;
  std::span<const review::Problem> problems;
  const workbench::CurveSet* curves = nullptr;  ///< Null until they are worked out.
  std::shared_ptr<const workbench::Filmstrip> pictures;
};
/// The shown lanes from the top. Words stand between the gates, and times of segments are cut to them.
void draw_lanes(Ui& ui, const LaneLayout& layout, const LaneSet& lanes, const LaneGround& ground);
/// Those that a recording has while it goes on.
LaneSet live_lanes();
void draw_live_lanes(Ui& ui, const LaneLayout& layout, const LaneData& data);

/// The pictures that fit the lane at this zoom.
workbench::ShowFilmstrip pictures_for(const Ui& ui, const LaneLayout& layout);

}  // namespace trocar::ui
