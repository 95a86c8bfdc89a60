#include "engine/demonstration/edits/time_course.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/demonstration/demonstration.h"
#include "engine/demonstration/edits/stretch.h"
#include "engine/demonstration/motion.h"
#include "engine/demonstration/time_warp.h"

namespace trocar::demonstration {
namespace {

constexpr auto kPerSecond = static_cast<double>(Tick::kPerSecond);
/// An hour; more is a slip of the keyboard.
constexpr double kLongest_s = 3600.0;

/// How far the faster tool goes from one sample to the next.
double step_m(const Sample& a, const Sample& b) {
  return std::max((measured_tip(b, 0) - measured_tip(a, 0)).norm(), (measured_tip(b, 1) - measured_tip(a, 1)).norm());
}

/// Sample i of `samples` comes at `ticks[i]` from the first; straight in between.
TimeCourse through(const SampleTrack& samples, std::vector<double> ticks) {
  const double length = ticks.back();
  std::vector<std::int64_t> old;
  old.reserve(samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i) old.push_back(samples.tick(i));
  const auto old_at = [old = std::move(old), ticks = std::move(ticks)](double wanted) {
    const auto after = std::upper_bound(ticks.begin() + 1, ticks.end() - 1, wanted);
    const auto piece = static_cast<std::size_t>(after - ticks.begin()) - 1;
    const double width = ticks[piece + 1] - ticks[piece];
    const double share = width > 0.0 ? std::clamp((wanted - ticks[piece]) / width, 0.0, 1.0) : 0.0;
    return static_cast<double>(old[piece]) + share * static_cast<double>(old[piece + 1] - old[piece]);
  };
  return {length, old_at, false};
}

Result<TimeCourse> by_speed(const SampleTrack& samples, const Retime& edit) {
  TROCAR_RETURN_IF_ERROR(check_positive(edit.speed_m_s, "the speed"));
  const double per_tick_m = edit.speed_m_s / kPerSecond;
  double path_m = 0.0;
  std::vector<double> ticks{0.0};
  Sample before = samples.front();
  for (const Sample& sample : samples.slice(1, samples.size())) {
    const double way_m = step_m(before, sample);
    const auto was = static_cast<double>(sample.tick - before.tick);
    before = sample;
    const double needed = way_m / per_tick_m;
    ticks.push_back(ticks.back() + (edit.mode == RetimeTo::kSpeedCap ? std::max(was, needed) : needed));
    path_m += way_m;
  }
  if (edit.mode == RetimeTo::kConstantSpeed && path_m <= 0.0) {
    return fail(ErrorCode::kInvalidArgument, "no tool moves in that span");
  }
  return through(samples, std::move(ticks));
}

TimeCourse even(const SampleTrack& samples, double factor) {
  std::vector<double> ticks{0.0};
  for (std::size_t i = 1; i < samples.size(); ++i) {
    ticks.push_back(ticks.back() + factor * static_cast<double>(samples.tick(i) - samples.tick(i - 1)));
  }
  TimeCourse course = through(samples, std::move(ticks));
  course.even = true;
  return course;
}

Result<TimeCourse> warped(const SampleTrack& samples, const Retime& edit, std::int64_t first_tick) {
  const double begin_s = Tick{samples.front().tick - first_tick}.seconds();
  const double end_s = Tick{samples.back().tick - first_tick}.seconds();
  TROCAR_ASSIGN_OR_RETURN(const std::vector<Eigen::Vector2d> knots, warp_knots(edit.knots_s, begin_s, end_s));
  std::vector<Eigen::Vector2d> points;
  points.reserve(knots.size());
  for (const Eigen::Vector2d& knot : knots) {
    points.emplace_back(kPerSecond * (knot.y() - begin_s), kPerSecond * knot.x() + static_cast<double>(first_tick));
  }
  const double length = points.back().x();
  return TimeCourse{length, [curve = MonotoneCurve(std::move(points))](double tick) { return curve.at(tick); }, false};
}

Result<TimeCourse> without_ease(const SampleTrack& samples, const Retime& edit, std::int64_t first_tick) {
  switch (edit.mode) {
    case RetimeTo::kScale:
      TROCAR_RETURN_IF_ERROR(check_positive(edit.scale, "the scale"));
      return even(samples, edit.scale);
    case RetimeTo::kDuration:
      TROCAR_RETURN_IF_ERROR(check_positive(edit.duration_s, "the duration"));
      return even(samples,
                  edit.duration_s * kPerSecond / static_cast<double>(samples.back().tick - samples.front().tick));
    case RetimeTo::kSpeedCap:
    case RetimeTo::kConstantSpeed:
      return by_speed(samples, edit);
    case RetimeTo::kWarp:
      return warped(samples, edit, first_tick);
  }
  return fail(ErrorCode::kInvalidArgument, "retime knows no such mode");
}

/// The integral of 3x² − 2x³: how far a motion has come that gets going from rest to the speed 1.
double got_going(double x) {
  return x * x * x * (1.0 - 0.5 * x);
}

Result<TimeCourse> with_ease(TimeCourse course, const Retime& edit) {
  const double in = edit.ease_in_s * kPerSecond;
  const double out = edit.ease_out_s * kPerSecond;
  if (!(in >= 0.0 && out >= 0.0 && std::isfinite(in + out))) {
    return fail(ErrorCode::kInvalidArgument, "an ease must be a number from 0");
  }
  if (in + out == 0.0) return course;
  const bool keeps_length = edit.mode == RetimeTo::kDuration || edit.mode == RetimeTo::kWarp;
  const double length = keeps_length ? course.length : course.length + 0.5 * (in + out);
  if (in + out > length) {
    return fail(ErrorCode::kInvalidArgument,
                fmt::format("easing in and out takes {:.2f} s, and the span would last {:.2f} s",
                            (in + out) / kPerSecond, length / kPerSecond));
  }
  const double way = length - 0.5 * (in + out);  // At the speed 1 of the middle.
  const double factor = course.length / way;
  const auto old_at = [old_at = std::move(course.old_at), in, out, length, way, factor](double tick) {
    double gone = tick - 0.5 * in;
    if (tick < in) gone = in * got_going(tick / in);
    if (tick > length - out) gone = way - out * got_going(std::max(length - tick, 0.0) / out);
    return old_at(factor * gone);
  };
  return TimeCourse{length, old_at, false};
}

}  // namespace

double TimeCourse::share_at(double share) const {
  const double begin = old_at(0.0);
  const double wanted = begin + share * (old_at(length) - begin);
  double low = 0.0;
  double high = length;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (old_at(middle) < wanted ? low : high) = middle;
  }
  return 0.5 * (low + high) / length;
}

Result<TimeCourse> time_course(const SampleTrack& samples, const Retime& edit, std::int64_t first_tick) {
  TROCAR_ASSIGN_OR_RETURN(TimeCourse plain, without_ease(samples, edit, first_tick));
  TROCAR_ASSIGN_OR_RETURN(TimeCourse course, with_ease(std::move(plain), edit));
  if (course.length > kLongest_s * kPerSecond) {
    return fail(ErrorCode::kInvalidArgument, "the span would last for more than an hour");
  }
  if (course.length >= 1.0) return course;
  return fail(ErrorCode::kInvalidArgument, "the span would have no duration");
}

TimeCourse fitted(TimeCourse course, double ticks) {
  const double factor = course.length / ticks;
  const double was = course.length;
  return {
      ticks,
      [old_at = std::move(course.old_at), factor, was](double tick) { return old_at(std::min(tick * factor, was)); },
      course.even};
}

}  // namespace trocar::demonstration
