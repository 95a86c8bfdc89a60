#include "engine/demonstration/problems.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "engine/demonstration/jaw_problems.h"
#include "engine/demonstration/motion.h"
#include "engine/demonstration/problem_spans.h"
#include "engine/demonstration/quality.h"
#include "engine/demonstration/sampling_rate.h"
#include "engine/demonstration/setpoint_problems.h"

namespace trocar::demonstration {
namespace {

using Problems = std::vector<Problem>;

/// Longer than this, and than twice what is usual there, is an error: a whole chunk of the recording is missing.
constexpr double kLongGap_s = 0.25;
constexpr double kUnitTolerance = 1e-3;
constexpr double kUnlabelled_s = 0.02;

template <std::size_t N, typename Number>
double distance_from_unit(const std::array<Number, N>& q) {
  double square = 0.0;
  for (const Number part : q) square += static_cast<double>(part) * static_cast<double>(part);
  return std::abs(std::sqrt(square) - 1.0);
}

/// Goes through the gated samples, once.
class NumberChecks {
 public:
  void add(const Sample& sample, double t_s) {
    if (!is_finite(sample)) return not_finite_.add(t_s, 0.0);
    double worst = 0.0;
    for (const ArmSample& arm : sample.arms) {
      worst = std::max({worst, distance_from_unit(arm.setpoint_q_wxyz), distance_from_unit(arm.measured.q_wxyz)});
    }
    for (const CompactPose& block : sample.blocks) worst = std::max(worst, distance_from_unit(block.q_wxyz));
    if (worst > kUnitTolerance) not_unit_.add(t_s, worst);
  }
  bool finite() const { return not_finite_.spans().empty(); }
  void report(Problems& found) const {
    for (const ProblemSpan& span : not_finite_.spans()) {
      found.push_back({ProblemKind::kNotFinite, Severity::kError, span.begin_s, span.end_s,
                       fmt::format("{} samples have a number that is not finite", span.count), ""});
    }
    for (const ProblemSpan& span : not_unit_.spans()) {
      found.push_back({ProblemKind::kQuaternion, Severity::kError, span.begin_s, span.end_s,
                       fmt::format("{} samples have a rotation that is not of unit length, off by up to {:.3g}",
                                   span.count, span.worst),
                       ""});
    }
  }

 private:
  SpanCollector not_finite_;
  SpanCollector not_unit_;
};

void check_time(const Demonstration& document, Problems& found) {
  const SampleTrack samples = document.gated();
  const auto time_s = [&](std::size_t i) { return Tick{samples.tick(i) - document.first_tick()}.seconds(); };
  for (const SampleGap& gap : sample_gaps(samples)) {
    const double begin_s = time_s(gap.after - 1);
    const double end_s = time_s(gap.after);
    const bool long_gap = end_s - begin_s > std::max(kLongGap_s, 2.0 * Tick{gap.usual}.seconds());
    found.push_back({ProblemKind::kTime, long_gap ? Severity::kError : Severity::kWarning, begin_s, end_s,
                     fmt::format("no sample for {:.0f} ms where one comes every {:.0f} ms", 1e3 * (end_s - begin_s),
                                 1e3 * Tick{gap.usual}.seconds()),
                     ""});
  }
  for (std::size_t i = 1; i < samples.size(); ++i) {
    if (samples.tick(i) > samples.tick(i - 1)) continue;
    found.push_back({ProblemKind::kTime, Severity::kError, time_s(i - 1), time_s(i - 1), "time does not go on", ""});
  }
}

double distance_outside_m(const spatial::Grid& grid, const Eigen::Vector3d& p_WT) {
  const Eigen::Vector3d low = grid.p_WGo;
  const Eigen::Vector3d high = (low.array() + grid.cell_m * grid.n).matrix();
  return (p_WT - p_WT.cwiseMax(low).cwiseMin(high)).norm();
}

void check_lattice(const Demonstration& document, const spatial::Grid& grid, Problems& found) {
  for (const Segment label : {Segment::kA, Segment::kC}) {
    const std::optional<SegmentSpan> span = document.segment(label);
    if (!span) continue;
    SpanCollector outside;
    for (const Sample& sample : document.samples_in(*span)) {
      const Eigen::Vector3d p_WT = measured_tip(sample, 0);
      if (!grid.cell_at(p_WT)) outside.add(document.time_of(sample), distance_outside_m(grid, p_WT));
    }
    for (const ProblemSpan& each : outside.spans()) {
      found.push_back({ProblemKind::kLattice, Severity::kWarning, each.begin_s, each.end_s,
                       fmt::format("{} samples of segment {} lie outside of the learning cube, by up to {:.1f} mm",
                                   each.count, letter(label), 1e3 * each.worst),
                       "", 0});
    }
  }
}

void check_motion(const Demonstration& document, const MotionBounds& bounds, Problems& found) {
  struct Measure {
    ProblemKind kind;
    double MotionPoint::*value;
    double bound;
    double scale;
    const char* unit;
  };
  const std::array<Measure, 3> measures{
      Measure{ProblemKind::kSpeed, &MotionPoint::speed_m_s, bounds.speed_m_s, 1e3, "mm/s"},
      Measure{ProblemKind::kAcceleration, &MotionPoint::acceleration_m_s2, bounds.acceleration_m_s2, 1.0, "m/s²"},
      Measure{ProblemKind::kJerk, &MotionPoint::jerk_m_s3, bounds.jerk_m_s3, 1.0, "m/s³"}};
  for (std::size_t arm = 0; arm < 2; ++arm) {
    const std::vector<MotionPoint> points = motion_of(document, arm);
    for (const Measure& measure : measures) {
      SpanCollector over;
      for (const MotionPoint& point : points) {
        if (point.*measure.value > measure.bound) over.add(point.t_s, point.*measure.value);
      }
      for (const ProblemSpan& span : over.spans()) {
        found.push_back(
            {measure.kind, Severity::kWarning, span.begin_s, span.end_s,
             fmt::format("{} of the {} tool reaches {:.0f} {}, more than {:.0f}", to_string(measure.kind), kTools[arm],
                         measure.scale * span.worst, measure.unit, measure.scale * measure.bound),
             "", static_cast<int>(arm)});
      }
    }
  }
}

/// More of it than rounding lies between the gates.
bool is_shown(const SegmentSpan& span, const Demonstration& document) {
  return span.end_s > document.begin_s + kTimeTolerance_s && span.begin_s < document.end_s - kTimeTolerance_s;
}

/// A transfer goes from A to E once.
void check_order(const Demonstration& document, Problems& found) {
  std::array<bool, kSegmentCount> seen{};
  std::optional<Segment> before;
  for (const SegmentSpan& span : document.segments) {
    if (!is_shown(span, document)) continue;
    const auto report = [&](Severity severity, std::string message) {
      found.push_back({ProblemKind::kSegments, severity, span.begin_s, span.end_s, std::move(message), ""});
    };
    if (before && span.label < *before) {
      report(Severity::kError, fmt::format("segment {} comes before segment {}", letter(*before), letter(span.label)));
    }
    bool& again = seen[static_cast<std::size_t>(span.label)];
    if (again) {
      report(Severity::kWarning,
             fmt::format("segment {} comes again; only its first stretch counts", letter(span.label)));
    }
    again = true;
    before = span.label;
  }
}

void check_segments(const Demonstration& document, Problems& found) {
  for (int i = 0; i < kSegmentCount; ++i) {
    const auto label = static_cast<Segment>(i);
    if (document.segment(label)) continue;
    found.push_back({ProblemKind::kSegments, Severity::kWarning, document.begin_s, document.end_s,
                     fmt::format("segment {} is missing", letter(label)), ""});
  }
  check_order(document, found);
  double covered_s = document.begin_s;
  const auto report_until = [&](double t_s) {
    if (t_s - covered_s < kUnlabelled_s) return;
    found.push_back({ProblemKind::kSegments, Severity::kInfo, covered_s, t_s,
                     fmt::format("{:.2f} s belong to no segment", t_s - covered_s), ""});
  };
  for (const SegmentSpan& span : document.segments) {
    if (!is_shown(span, document)) continue;
    report_until(span.begin_s);
    covered_s = std::max(covered_s, span.end_s);
  }
  report_until(document.end_s);
}

void check_idle(const Demonstration& document, Problems& found) {
  const std::optional<Trim> trim = idle_ends(document);
  if (!trim) return;
  // Rounded outwards, so that the fix as it is printed cuts nothing that moves.
  const std::string fix = fmt::format("trim --from {:.2f} --to {:.2f}", std::floor(trim->from_s * 100.0) / 100.0,
                                      std::ceil(trim->to_s * 100.0) / 100.0);
  const auto report = [&](double begin_s, double end_s) {
    if (begin_s >= end_s) return;
    found.push_back({ProblemKind::kIdle, Severity::kInfo, begin_s, end_s,
                     fmt::format("neither tool moves for {:.2f} s", end_s - begin_s), fix});
  };
  report(document.begin_s, trim->from_s);
  report(trim->to_s, document.end_s);
}

}  // namespace

std::string_view to_string(ProblemKind kind) {
  switch (kind) {
    case ProblemKind::kNotFinite:
      return "not-finite";
    case ProblemKind::kTime:
      return "time";
    case ProblemKind::kQuaternion:
      return "quaternion";
    case ProblemKind::kLattice:
      return "lattice";
    case ProblemKind::kWorkspace:
      return "workspace";
    case ProblemKind::kSpeed:
      return "speed";
    case ProblemKind::kAcceleration:
      return "acceleration";
    case ProblemKind::kJerk:
      return "jerk";
    case ProblemKind::kSegments:
      return "segments";
    case ProblemKind::kIdle:
      return "idle";
    case ProblemKind::kJaw:
      return "jaw";
    case ProblemKind::kCollision:
      return "collision";
    case ProblemKind::kClearance:
      return "clearance";
    case ProblemKind::kJoint:
      return "joint";
    case ProblemKind::kSafeSet:
      return "safe-set";
    case ProblemKind::kEnds:
      return "ends";
  }
  return "unknown";
}

std::string_view to_string(Severity severity) {
  switch (severity) {
    case Severity::kInfo:
      return "info";
    case Severity::kWarning:
      return "warning";
    case Severity::kError:
      return "error";
  }
  return "unknown";
}

Problems problems(const Demonstration& document, const spatial::Grid& grid, const MotionBounds& bounds) {
  // Together, as a long demonstration costs by how often it is gone through.
  NumberChecks numbers;
  SetpointChecks setpoints(bounds);
  JawChecks jaws;
  for (const Sample& sample : document.gated()) {
    const double t_s = document.time_of(sample);
    numbers.add(sample, t_s);
    if (!numbers.finite()) continue;
    setpoints.add(sample, t_s);
    jaws.add(sample, t_s);
  }
  Problems found;
  numbers.report(found);
  check_time(document, found);
  check_segments(document, found);
  if (numbers.finite()) {
    check_lattice(document, grid, found);
    check_motion(document, bounds, found);
    check_idle(document, found);
    setpoints.report(found);
    jaws.report(found);
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const Problem& a, const Problem& b) { return a.begin_s < b.begin_s; });
  return found;
}

}  // namespace trocar::demonstration
