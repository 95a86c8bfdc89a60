#include "engine/demonstration/curves.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

#include "engine/core/check.h"
#include "engine/demonstration/motion.h"

namespace trocar::demonstration {
namespace {

constexpr std::array<std::string_view, kCurveKindCount> kCurveNames{"x",    "y",   "z",        "speed", "acceleration",
                                                                    "jerk", "jaw", "clearance"};
constexpr std::array<std::string_view, kCurveKindCount> kCurveUnits{"m", "m", "m", "m/s", "m/s^2", "m/s^3", "rad", "m"};

class CurveWriter {
 public:
  explicit CurveWriter(double apart_s) : apart_s_(apart_s) {}
  void add(double t_s, double value) {
    if (!curve_.t_s.empty() && t_s - curve_.t_s.back() > apart_s_) {
      push(0.5 * (curve_.t_s.back() + t_s), std::numeric_limits<double>::quiet_NaN());
    }
    push(t_s, value);
  }
  MotionCurve take() { return std::move(curve_); }
  void reserve(std::size_t count) {
    curve_.t_s.reserve(count);
    curve_.values.reserve(count);
  }

 private:
  void push(double t_s, double value) {
    curve_.t_s.push_back(t_s);
    curve_.values.push_back(value);
  }
  double apart_s_;
  MotionCurve curve_;
};

double value_of(const Sample& sample, CurveKind kind, std::size_t arm) {
  const ArmSample& one = sample.arms[arm];
  return static_cast<double>(kind == CurveKind::kJaw ? one.jaw_rad : one.measured.p[static_cast<std::size_t>(kind)]);
}

double value_of(const MotionPoint& point, CurveKind kind) {
  if (kind == CurveKind::kSpeed) return point.speed_m_s;
  return kind == CurveKind::kAcceleration ? point.acceleration_m_s2 : point.jerk_m_s3;
}

bool is_motion(CurveKind kind) {
  return kind == CurveKind::kSpeed || kind == CurveKind::kAcceleration || kind == CurveKind::kJerk;
}

}  // namespace

std::string_view to_string(CurveKind kind) {
  return kCurveNames[static_cast<std::size_t>(kind)];
}

std::string_view si_unit(CurveKind kind) {
  return kCurveUnits[static_cast<std::size_t>(kind)];
}

Result<CurveKind> curve_kind_from(std::string_view text) {
  const auto* found = std::find(kCurveNames.begin(), kCurveNames.end(), text);
  if (found != kCurveNames.end()) return static_cast<CurveKind>(found - kCurveNames.begin());
  std::string names;
  for (const std::string_view name : kCurveNames) names += fmt::format("{}{}", names.empty() ? "" : ", ", name);
  return fail(ErrorCode::kInvalidArgument, fmt::format("there is no curve '{}'; there are {}", text, names));
}

MotionCurve curve_of(const SampleTrack& samples, std::int64_t first_tick, CurveKind kind, std::size_t arm) {
  TROCAR_CHECK(kind != CurveKind::kClearance);
  CurveWriter writer(motion_gap_s(samples));
  if (is_motion(kind)) {
    for (const MotionPoint& point : motion_of(samples, first_tick, arm)) writer.add(point.t_s, value_of(point, kind));
    return writer.take();
  }
  writer.reserve(samples.size());
  for (const Sample& sample : samples) {
    writer.add(Tick{sample.tick - first_tick}.seconds(), value_of(sample, kind, arm));
  }
  return writer.take();
}

}  // namespace trocar::demonstration
