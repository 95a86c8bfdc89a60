#include "engine/demonstration/time_warp.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace trocar::demonstration {
namespace {

/// Typed times are decimals, and those of samples whole milliseconds.
constexpr double kSameKnot_s = 1e-6;

}  // namespace

Result<std::vector<Eigen::Vector2d>> warp_knots(const std::vector<Eigen::Vector2d>& knots, double begin_s,
                                                double end_s) {
  if (knots.empty()) {
    return fail(ErrorCode::kInvalidArgument, "a time warp needs a knot, old time to new time, such as --knots 1.5:2");
  }
  std::vector<Eigen::Vector2d> all{{begin_s, begin_s}};
  for (const Eigen::Vector2d& knot : knots) {
    if (!knot.allFinite()) return fail(ErrorCode::kInvalidArgument, "the times of a knot must be finite numbers");
    if (knot.x() < begin_s - kSameKnot_s || (all.size() > 1 && all.back().x() >= end_s)) {
      return fail(ErrorCode::kInvalidArgument,
                  fmt::format("the knot {:g}:{:g} is not within {:.3f}–{:.3f} s", knot.x(), knot.y(), begin_s, end_s));
    }
    if ((knot - all.front()).cwiseAbs().maxCoeff() <= kSameKnot_s) continue;
    const Eigen::Vector2d next(std::min(knot.x(), end_s), knot.y());
    if (next.x() <= all.back().x() || next.y() <= all.back().y()) {
      return fail(ErrorCode::kInvalidArgument,
                  fmt::format("old and new times must increase from knot to knot: {:g}:{:g} comes after {:g}:{:g}",
                              knot.x(), knot.y(), all.back().x(), all.back().y()));
    }
    all.push_back(next);
  }
  const Eigen::Vector2d last = all.back();
  if (last.x() < end_s - kSameKnot_s) all.emplace_back(end_s, last.y() + end_s - last.x());
  return all;
}

MonotoneCurve::MonotoneCurve(std::vector<Eigen::Vector2d> points)
    : points_(std::move(points)), slopes_(points_.size(), 0.0) {
  const auto secant = [&](std::size_t i) {
    const Eigen::Vector2d step = points_[i + 1] - points_[i];
    return step.y() / step.x();
  };
  const std::size_t last = points_.size() - 1;
  slopes_.front() = secant(0);
  slopes_.back() = secant(last - 1);
  for (std::size_t i = 1; i < last; ++i) {
    const double before = points_[i].x() - points_[i - 1].x();
    const double after = points_[i + 1].x() - points_[i].x();
    // The weighted harmonic mean is never more than three times the flatter one, which keeps the curve from turning.
    slopes_[i] = 3.0 * (before + after) / ((2.0 * after + before) / secant(i - 1) + (after + 2.0 * before) / secant(i));
  }
}

double MonotoneCurve::at(double x) const {
  if (x <= points_.front().x()) return points_.front().y();
  if (x >= points_.back().x()) return points_.back().y();
  const auto after = std::upper_bound(points_.begin(), points_.end(), x,
                                      [](double value, const Eigen::Vector2d& point) { return value < point.x(); });
  const auto i = static_cast<std::size_t>(after - points_.begin()) - 1;
  const double width = points_[i + 1].x() - points_[i].x();
  const double t = (x - points_[i].x()) / width;
  const double rise = t * t * (3.0 - 2.0 * t);
  return points_[i].y() * (1.0 - rise) + points_[i + 1].y() * rise +
         width * t * (1.0 - t) * ((1.0 - t) * slopes_[i] - t * slopes_[i + 1]);
}

}  // namespace trocar::demonstration
