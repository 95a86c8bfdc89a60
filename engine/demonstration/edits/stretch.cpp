#include "engine/demonstration/edits/stretch.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace trocar::demonstration {
namespace {

CompactPose mixed(const CompactPose& a, const CompactPose& b, double share) {
  return CompactPose::from(spatial::interpolate(a.pose(), b.pose(), share));
}

ArmSample mixed(const ArmSample& a, const ArmSample& b, double share) {
  ArmSample result;
  result.set_setpoint(spatial::interpolate(a.setpoint(), b.setpoint(), share),
                      a.setpoint_jaw_rad + share * (b.setpoint_jaw_rad - a.setpoint_jaw_rad));
  result.measured = mixed(a.measured, b.measured, share);
  const auto lerp = [share](float from, float to) {
    return static_cast<float>(static_cast<double>(from) + share * static_cast<double>(to - from));
  };
  result.jaw_rad = lerp(a.jaw_rad, b.jaw_rad);
  for (std::size_t i = 0; i < result.joints.size(); ++i) result.joints[i] = lerp(a.joints[i], b.joints[i]);
  return result;
}

spatial::Pose displaced(const spatial::Pose& X_WT, const Eigen::Vector3d& by_m, const Eigen::Quaterniond& turn) {
  return {X_WT.p + by_m, (turn * X_WT.q).normalized()};
}

}  // namespace

Status check_range(double from_s, double to_s) {
  if (!std::isfinite(from_s) || !std::isfinite(to_s)) {
    return fail(ErrorCode::kInvalidArgument, "the begin and the end must be finite numbers");
  }
  if (to_s <= from_s) {
    return fail(ErrorCode::kInvalidArgument,
                fmt::format("the end ({} s) must be after the begin ({} s)", to_s, from_s));
  }
  return {};
}

Status check_positive(double value, std::string_view what) {
  if (std::isfinite(value) && value > 0.0) return {};
  return fail(ErrorCode::kInvalidArgument, fmt::format("{} must be a number above 0", what));
}

Result<TrackPart> part_of(const Demonstration& document, double from_s, double to_s, std::size_t fewest) {
  TROCAR_RETURN_IF_ERROR(check_range(from_s, to_s));
  SampleTrack inside = document.samples_within(from_s, to_s);
  if (inside.size() < fewest) {
    return fail(ErrorCode::kInvalidArgument, fmt::format("{:.3f}–{:.3f} s holds {} samples, and {} are needed", from_s,
                                                         to_s, inside.size(), fewest));
  }
  return TrackPart{document.samples.lower_bound(inside.tick(0)), std::move(inside)};
}

Result<Stretch> stretch_of(const Demonstration& document, double from_s, double to_s, std::size_t fewest) {
  TROCAR_ASSIGN_OR_RETURN(const TrackPart part, part_of(document, from_s, to_s, fewest));
  return Stretch{part.first, part.samples.to_vector()};
}

Demonstration with_stretch(const Demonstration& document, Stretch stretch) {
  Demonstration edited = document;
  const std::size_t count = stretch.samples.size();
  edited.samples = document.samples.replaced(stretch.first, count, SampleTrack(stretch.samples));
  return edited;
}

Result<Demonstration> with_other_length(const Demonstration& document, std::size_t first, std::size_t count,
                                        const SampleTrack& samples, std::int64_t shift,
                                        const std::function<double(double)>& inside) {
  Demonstration edited = document;
  const SampleTrack& track = document.samples;
  edited.samples =
      SampleTrack::joined({track.slice(0, first), samples, track.slice(first + count, track.size()).shifted(shift)});
  if (edited.samples.size() < 2) return fail(ErrorCode::kInvalidArgument, "fewer than 2 samples would stay");
  const double begin_s = Tick{track.tick(std::min(first, track.size() - 1)) - document.first_tick()}.seconds();
  const std::size_t after = std::min(first + count, track.size() - 1);
  const double end_s = std::max(begin_s, Tick{track.tick(after) - document.first_tick()}.seconds());
  const double shift_s = Tick{shift}.seconds();
  const double stretched = end_s > begin_s ? std::max(0.0, (end_s + shift_s - begin_s) / (end_s - begin_s)) : 0.0;
  move_times(edited, [&](double t_s) {
    if (t_s <= begin_s) return t_s;
    if (t_s >= end_s) return t_s + shift_s;
    if (!inside) return begin_s + stretched * (t_s - begin_s);
    return begin_s + inside(t_s - begin_s);
  });
  edited.end_s = std::min(edited.end_s, edited.full_duration_s());
  if (edited.gated().size() >= 2) return edited;
  return fail(ErrorCode::kInvalidArgument, "fewer than 2 samples would stay between the gates");
}

void move_times(Demonstration& document, const std::function<double(double)>& moved) {
  document.begin_s = moved(document.begin_s);
  document.end_s = moved(document.end_s);
  for (SegmentSpan& span : document.segments) {
    span.begin_s = moved(span.begin_s);
    span.end_s = moved(span.end_s);
  }
  std::erase_if(document.segments, [](const SegmentSpan& span) { return span.begin_s >= span.end_s; });
  for (Note& note : document.notes) {
    note.begin_s = moved(note.begin_s);
    note.end_s = moved(note.end_s);
  }
}

std::vector<std::size_t> indices_of(Arms arms) {
  if (arms == Arms::kBoth) return {0, 1};
  return {arms == Arms::kLeft ? std::size_t{0} : std::size_t{1}};
}

Sample between(const Sample& a, const Sample& b, std::int64_t tick) {
  Sample result = a;
  const double share =
      static_cast<double>(tick - a.tick) / static_cast<double>(std::max<std::int64_t>(b.tick - a.tick, 1));
  result.tick = tick;
  for (std::size_t arm = 0; arm < 2; ++arm) result.arms[arm] = mixed(a.arms[arm], b.arms[arm], share);
  for (std::size_t i = 0; i < result.blocks.size(); ++i) result.blocks[i] = mixed(a.blocks[i], b.blocks[i], share);
  return result;
}

Sample TrackReader::at(double tick) {
  while (next_ < samples_.size() && static_cast<double>(samples_.tick(next_)) <= tick) ++next_;
  const Sample before = samples_[next_ - 1];
  if (next_ == samples_.size() || static_cast<double>(before.tick) >= tick) return before;
  const Sample after = samples_[next_];
  // In thousandths of a tick, so that `between` can work with whole numbers.
  constexpr double kFine = 1000.0;
  Sample low = before;
  Sample high = after;
  low.tick = 0;
  high.tick = static_cast<std::int64_t>(kFine) * (after.tick - before.tick);
  return between(low, high, std::llround(kFine * (tick - static_cast<double>(before.tick))));
}

void displace(Sample& sample, std::size_t arm, const Eigen::Vector3d& by_m, const Eigen::Quaterniond& turn, int block) {
  ArmSample& moved = sample.arms[arm];
  const spatial::Pose X_WT = moved.measured.pose();
  const spatial::Pose X_WT_new = displaced(X_WT, by_m, turn);
  moved.measured = CompactPose::from(X_WT_new);
  moved.set_setpoint(displaced(moved.setpoint(), by_m, turn), moved.setpoint_jaw_rad);
  if ((sample.flags & holds_flag(arm)) == 0 || block < 0 || block >= peg_board::kBlockCount) return;
  CompactPose& held = sample.blocks[static_cast<std::size_t>(block)];
  held = CompactPose::from(X_WT_new * X_WT.inverse() * held.pose());
}

SampleFlag holds_flag(std::size_t arm) {
  return arm == 0 ? kLeftHolds : kRightHolds;
}

}  // namespace trocar::demonstration
