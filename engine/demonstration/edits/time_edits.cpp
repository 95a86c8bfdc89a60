// Other times for the same motion: Resample, Retime.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "engine/demonstration/edits/edit_functions.h"
#include "engine/demonstration/edits/stretch.h"
#include "engine/demonstration/edits/time_course.h"

namespace trocar::demonstration {
namespace {

/// Over half a day at 200 Hz.
constexpr double kMostSamples = 1e7;

/// The value at `share` of the way from b to c of the cubic with the mean slopes of the neighbours there; times are
/// ticks.
Eigen::Vector3d cubic(const std::array<Eigen::Vector3d, 4>& p, const std::array<double, 4>& at, double share) {
  const double width = at[2] - at[1];
  const auto slope = [&](std::size_t low, std::size_t high) -> Eigen::Vector3d {
    return width / std::max(at[high] - at[low], 1.0) * (p[high] - p[low]);
  };
  const Eigen::Vector3d from = at[1] > at[0] ? slope(0, 2) : slope(1, 2);
  const Eigen::Vector3d to = at[3] > at[2] ? slope(1, 3) : slope(1, 2);
  const double t = share;
  const double rise = t * t * (3.0 - 2.0 * t);
  return (1.0 - rise) * p[1] + rise * p[2] + t * (1.0 - t) * ((1.0 - t) * from - t * to);
}

Eigen::Vector3d point_of(const CompactPose& pose) {
  return {static_cast<double>(pose.p[0]), static_cast<double>(pose.p[1]), static_cast<double>(pose.p[2])};
}

void put_at(CompactPose& pose, const Eigen::Vector3d& p) {
  for (std::size_t axis = 0; axis < 3; ++axis) pose.p[axis] = static_cast<float>(p[static_cast<Eigen::Index>(axis)]);
}

/// A sample and its next one, with a further neighbour on either side; at an end it is its own neighbour.
using Neighbours = std::array<Sample, 4>;

Neighbours neighbours_of(const SampleTrack& samples, std::size_t before) {
  const std::size_t last = samples.size() - 1;
  return {samples[before == 0 ? 0 : before - 1], samples[before], samples[std::min(before + 1, last)],
          samples[std::min(before + 2, last)]};
}

/// Puts the positions of `sample`, which lies at `share` of the way between the inner two, onto cubics.
void bend(Sample& sample, const Neighbours& near, double share) {
  std::array<double, 4> at{};
  for (std::size_t i = 0; i < near.size(); ++i) at[i] = static_cast<double>(near[i].tick);
  const auto through = [&](const auto& where) {
    std::array<Eigen::Vector3d, 4> points;
    for (std::size_t i = 0; i < near.size(); ++i) points[i] = where(near[i]);
    return cubic(points, at, share);
  };
  for (std::size_t arm = 0; arm < 2; ++arm) {
    ArmSample& moved = sample.arms[arm];
    put_at(moved.measured, through([&](const Sample& each) { return point_of(each.arms[arm].measured); }));
    const Eigen::Vector3d setpoint = through([&](const Sample& each) { return each.arms[arm].setpoint().p; });
    moved.set_setpoint({setpoint, moved.setpoint().q}, moved.setpoint_jaw_rad);
  }
  for (std::size_t block = 0; block < sample.blocks.size(); ++block) {
    put_at(sample.blocks[block], through([&](const Sample& each) { return point_of(each.blocks[block]); }));
  }
}

/// Up to the last of `samples`, each at the tick nearest to its time, so that no rate drifts.
SampleTrack resampled(const SampleTrack& samples, double rate_hz, ResampleBy method) {
  BlockBuilder result;
  TrackReader reader(samples);
  std::size_t before = 0;
  Neighbours near = neighbours_of(samples, before);
  const std::int64_t last = samples.tick(samples.size() - 1);
  const std::int64_t first = samples.tick(0);
  const auto tick_of = [&](std::int64_t i) {
    return first + std::llround(static_cast<double>(i) * static_cast<double>(Tick::kPerSecond) / rate_hz);
  };
  for (std::int64_t i = 0, tick = first; tick <= last; tick = tick_of(++i)) {
    const std::size_t was = before;
    while (before + 2 < samples.size() && samples.tick(before + 1) <= tick) ++before;
    if (before != was) near = neighbours_of(samples, before);
    const Sample& low = near[1];
    const Sample& high = near[2];
    const double share =
        high.tick > low.tick
            ? std::clamp(static_cast<double>(tick - low.tick) / static_cast<double>(high.tick - low.tick), 0.0, 1.0)
            : 0.0;
    Sample sample = method == ResampleBy::kNearest ? (share < 0.5 ? low : high) : reader.at(static_cast<double>(tick));
    if (method == ResampleBy::kCubic && share > 0.0 && share < 1.0) bend(sample, near, share);
    sample.tick = tick;
    result.add(sample);
  }
  return SampleTrack(result.take());
}

}  // namespace

Result<Demonstration> made_by(const Demonstration& document, const Resample& edit) {
  TROCAR_RETURN_IF_ERROR(check_positive(edit.rate_hz, "the rate"));
  if (edit.rate_hz < 1.0 || edit.rate_hz > static_cast<double>(Tick::kPerSecond)) {
    return fail(ErrorCode::kInvalidArgument, fmt::format("a rate must be from 1 to {} Hz", Tick::kPerSecond));
  }
  if (document.full_duration_s() * edit.rate_hz > kMostSamples) {
    return fail(ErrorCode::kInvalidArgument, "that would make more than ten million samples");
  }
  Demonstration edited = document;
  edited.samples = resampled(document.samples, edit.rate_hz, edit.method);
  edited.end_s = std::min(edited.end_s, edited.full_duration_s());
  if (edited.samples.size() >= 2 && edited.gated().size() >= 2) return edited;
  return fail(ErrorCode::kInvalidArgument, "fewer than 2 samples would stay");
}

Result<Demonstration> made_by(const Demonstration& document, const Retime& edit) {
  TROCAR_ASSIGN_OR_RETURN(const TrackPart part, part_of(document, edit.from_s, edit.to_s, 2));
  const SampleTrack& samples = part.samples;
  TROCAR_ASSIGN_OR_RETURN(TimeCourse wanted, time_course(samples, edit, document.first_tick()));
  // The grid of the samples goes on behind the span, so that its length is a whole number of steps.
  constexpr std::int64_t kStep = kTicksPerSample;
  const auto length = std::max<std::int64_t>(std::llround(wanted.length / static_cast<double>(kStep)), 1) * kStep;
  const TimeCourse course = fitted(std::move(wanted), static_cast<double>(length));
  const std::int64_t first_tick = samples.tick(0);
  const std::int64_t old_length = samples.tick(samples.size() - 1) - first_tick;
  BlockBuilder retimed;
  TrackReader reader(samples);
  for (std::int64_t tick = 0; tick <= length; tick += kStep) {
    Sample sample = reader.at(course.old_at(static_cast<double>(tick)));
    sample.tick = first_tick + tick;
    retimed.add(sample);
  }
  const double old_s = Tick{old_length}.seconds();
  const double new_s = Tick{length}.seconds();
  const auto moved_s = [&](double t_s) {
    return t_s < old_s ? course.share_at(t_s / old_s) * new_s : t_s + new_s - old_s;
  };
  return with_other_length(document, part.first, samples.size(), SampleTrack(retimed.take()), length - old_length,
                           course.even ? std::function<double(double)>() : moved_s);
}

}  // namespace trocar::demonstration
