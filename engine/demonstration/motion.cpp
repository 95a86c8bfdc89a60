#include "engine/demonstration/motion.h"

#include <algorithm>
#include <cmath>

#include "engine/demonstration/sampling_rate.h"

namespace trocar::demonstration {
namespace {

constexpr double kKnotDistance_s = 0.020;

struct Knot {
  double t_s = 0.0;
  Eigen::Vector3d p_WT{0.0, 0.0, 0.0};
};

/// Samples at least 20 ms apart.
std::vector<Knot> knots_of(const SampleTrack& samples, std::int64_t first_tick, std::size_t arm) {
  std::vector<Knot> knots;
  const auto begin = samples.begin();
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double t_s = Tick{samples.tick(i) - first_tick}.seconds();
    if (!knots.empty() && t_s - knots.back().t_s < kKnotDistance_s - 1e-9) continue;
    knots.push_back({t_s, measured_tip(begin[static_cast<std::ptrdiff_t>(i)], arm)});
  }
  return knots;
}

/// Third-order divided differences of four neighbours, each lower order from the newest of them.
MotionPoint point_at(std::span<const Knot, 4> knots) {
  std::array<Eigen::Vector3d, 3> velocity;
  std::array<double, 3> middle_s{};
  for (std::size_t i = 0; i < 3; ++i) {
    velocity[i] = (knots[i + 1].p_WT - knots[i].p_WT) / (knots[i + 1].t_s - knots[i].t_s);
    middle_s[i] = 0.5 * (knots[i + 1].t_s + knots[i].t_s);
  }
  const Eigen::Vector3d early = (velocity[1] - velocity[0]) / (middle_s[1] - middle_s[0]);
  const Eigen::Vector3d late = (velocity[2] - velocity[1]) / (middle_s[2] - middle_s[1]);
  const Eigen::Vector3d jerk = (late - early) / (0.5 * (middle_s[2] - middle_s[0]));
  return {middle_s[1], velocity[1].norm(), (0.5 * (early + late)).norm(), jerk.norm()};
}

}  // namespace

Eigen::Vector3d measured_tip(const Sample& sample, std::size_t arm) {
  const std::array<float, 3>& p = sample.arms[arm].measured.p;
  return {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])};
}

std::vector<MotionPoint> motion_of(const Demonstration& document, std::size_t arm) {
  return motion_of(document.gated(), document.first_tick(), arm);
}

namespace {

constexpr double kTremorFilter_s = 0.050;

/// The mean of a knot and those within 0.15 s of it, weighed by how near they are in time. The weights are the same on
/// both sides, so that what moves evenly stays as it is. Nothing where an end or a gap is nearer than that.
std::optional<Eigen::Vector3d> smoothed_at(const std::vector<Knot>& knots, std::size_t i, double gap_s) {
  Eigen::Vector3d sum = knots[i].p_WT;
  double weights = 1.0;
  for (std::size_t by = 1;; ++by) {
    if (by > i || i + by >= knots.size()) return std::nullopt;
    const Knot& before = knots[i - by];
    const Knot& after = knots[i + by];
    if (after.t_s - before.t_s > 6.0 * kTremorFilter_s) break;
    const bool gap = knots[i - by + 1].t_s - before.t_s > gap_s || after.t_s - knots[i + by - 1].t_s > gap_s;
    if (gap) return std::nullopt;
    const double away = 0.5 * (after.t_s - before.t_s) / kTremorFilter_s;
    const double weight = std::exp(-0.5 * away * away);
    sum += weight * (before.p_WT + after.p_WT);
    weights += 2.0 * weight;
  }
  return sum / weights;
}

std::vector<Knot> without_tremor(const std::vector<Knot>& knots, double gap_s) {
  std::vector<Knot> smooth;
  for (std::size_t i = 0; i < knots.size(); ++i) {
    if (const auto p_WT = smoothed_at(knots, i, gap_s)) smooth.push_back({knots[i].t_s, *p_WT});
  }
  return smooth;
}

std::vector<MotionPoint> points_of(const std::vector<Knot>& knots, double gap_s) {
  std::vector<MotionPoint> points;
  for (std::size_t i = 0; i + 4 <= knots.size(); ++i) {
    const std::span<const Knot, 4> four(&knots[i], 4);
    const bool whole = std::adjacent_find(four.begin(), four.end(), [gap_s](const Knot& a, const Knot& b) {
                         return b.t_s - a.t_s > gap_s;
                       }) == four.end();
    if (whole) points.push_back(point_at(four));
  }
  return points;
}

}  // namespace

std::vector<MotionPoint> motion_of(const SampleTrack& samples, std::int64_t first_tick, std::size_t arm) {
  return points_of(knots_of(samples, first_tick, arm), motion_gap_s(samples));
}

std::optional<JerkSummary> jerk_without_tremor(const Demonstration& document, std::size_t arm) {
  const SampleTrack samples = document.gated();
  if (Tick{usual_step(samples)}.seconds() > kRarestForJerk_s) return std::nullopt;
  const double gap_s = motion_gap_s(samples);
  const std::vector<MotionPoint> points =
      points_of(without_tremor(knots_of(samples, document.first_tick(), arm), gap_s), gap_s);
  if (points.empty()) return std::nullopt;
  JerkSummary summary;
  for (const MotionPoint& point : points) {
    summary.mean_m_s3 += point.jerk_m_s3 / static_cast<double>(points.size());
    summary.peak_m_s3 = std::max(summary.peak_m_s3, point.jerk_m_s3);
  }
  return summary;
}

double motion_gap_s(const SampleTrack& samples) {
  constexpr double kSteps = 2.5;
  return std::max(kMotionGap_s, kSteps * Tick{usual_step(samples)}.seconds());
}

double path_length_m(const Demonstration& document, std::size_t arm) {
  const SampleTrack samples = document.gated();
  double length_m = 0.0;
  std::optional<Eigen::Vector3d> before;
  for (const Sample& sample : samples) {
    const Eigen::Vector3d p_WT = measured_tip(sample, arm);
    if (before) length_m += (p_WT - *before).norm();
    before = p_WT;
  }
  return length_m;
}

}  // namespace trocar::demonstration
