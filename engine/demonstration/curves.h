/// A demonstration over time as curves: where each tool is, how fast it moves, how far its jaws are open.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "engine/core/result.h"
#include "engine/demonstration/sample_track.h"

namespace trocar::demonstration {

/// The clearance is one of geometry: `review` works it out, not `curve_of`.
enum class CurveKind : std::uint8_t { kX, kY, kZ, kSpeed, kAcceleration, kJerk, kJaw, kClearance };
constexpr std::size_t kCurveKindCount = 8;
constexpr std::array<CurveKind, kCurveKindCount> kCurveKinds{
    CurveKind::kX,    CurveKind::kY,   CurveKind::kZ,        CurveKind::kSpeed, CurveKind::kAcceleration,
    CurveKind::kJerk, CurveKind::kJaw, CurveKind::kClearance};
/// "x", "y", "z", "speed", "acceleration", "jerk", "jaw", "clearance".
std::string_view to_string(CurveKind kind);
/// Errors: kInvalidArgument with the names that there are.
Result<CurveKind> curve_kind_from(std::string_view text);
/// "m", "m/s", "m/s^2", "m/s^3", "rad", "m".
std::string_view si_unit(CurveKind kind);

/// Values in SI at times of the demonstration; NaN between neighbours that are apart (`motion_gap_s`).
struct MotionCurve {
  std::vector<double> t_s;
  std::vector<double> values;
};

/// Of one arm (0 left, 1 right) as measured, gates or not: x, y, z of p_WT and the jaw at every sample; speed,
/// acceleration and jerk at every `MotionPoint`. Precondition: not of the clearance. A pure function of its arguments;
/// times count from `first_tick`.
MotionCurve curve_of(const SampleTrack& samples, std::int64_t first_tick, CurveKind kind, std::size_t arm);

}  // namespace trocar::demonstration
