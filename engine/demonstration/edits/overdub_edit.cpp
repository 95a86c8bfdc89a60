// Overdub: what an arm did elsewhere, in place of what it did here.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "engine/demonstration/clip.h"
#include "engine/demonstration/edits/edit_functions.h"
#include "engine/demonstration/edits/stretch.h"

namespace trocar::demonstration {
namespace {

double eased(double x) {
  return x * x * x * (10.0 - 15.0 * x + 6.0 * x * x);  // Flash and Hogan, 1985
}

/// `kept` as it is, but that `arms` do what they do in `clip`; blocks and pedals follow those who move.
Sample overdubbed(Sample kept, const Sample& clip, const std::vector<std::size_t>& arms) {
  std::uint32_t stays = 0;
  for (std::size_t arm = 0; arm < 2; ++arm) {
    if (std::find(arms.begin(), arms.end(), arm) == arms.end()) {
      stays |= holds_flag(arm);
    } else {
      kept.arms[arm] = clip.arms[arm];
    }
  }
  kept.flags = (kept.flags & stays) | (clip.flags & ~stays);
  kept.blocks = clip.blocks;
  return kept;
}

/// From where an arm was told to be and is in `old` to where in `now`.
struct Lead {
  Eigen::Vector3d measured_m{0.0, 0.0, 0.0};
  Eigen::Quaterniond measured_turn = Eigen::Quaterniond::Identity();
  Eigen::Vector3d setpoint_m{0.0, 0.0, 0.0};
  Eigen::Quaterniond setpoint_turn = Eigen::Quaterniond::Identity();
  double jaw_rad = 0.0;
  double setpoint_jaw_rad = 0.0;

  static Lead of(const ArmSample& old, const ArmSample& now) {
    const spatial::Pose X_WT = old.measured.pose();
    const spatial::Pose X_WT_now = now.measured.pose();
    const spatial::Pose told = old.setpoint();
    const spatial::Pose told_now = now.setpoint();
    return {X_WT_now.p - X_WT.p,
            X_WT_now.q * X_WT.q.conjugate(),
            told_now.p - told.p,
            told_now.q * told.q.conjugate(),
            static_cast<double>(now.jaw_rad) - static_cast<double>(old.jaw_rad),
            now.setpoint_jaw_rad - old.setpoint_jaw_rad};
  }
};

/// The share `left` of the lead is still there.
void follow(Sample& sample, std::size_t arm, const Lead& lead, double left, int block) {
  const Eigen::Quaterniond none = Eigen::Quaterniond::Identity();
  const ArmSample old = sample.arms[arm];
  displace(sample, arm, left * lead.measured_m, none.slerp(left, lead.measured_turn), block);
  const spatial::Pose told = old.setpoint();
  sample.arms[arm].set_setpoint(
      {told.p + left * lead.setpoint_m, (none.slerp(left, lead.setpoint_turn) * told.q).normalized()},
      old.setpoint_jaw_rad + left * lead.setpoint_jaw_rad);
  sample.arms[arm].jaw_rad = static_cast<float>(static_cast<double>(old.jaw_rad) + left * lead.jaw_rad);
}

/// The samples after `end`, which comes to `now`, on their way back to what they were.
std::vector<Sample> way_back(const Demonstration& document, std::int64_t end, const Sample& now, const Overdub& edit) {
  const SampleTrack& track = document.samples;
  const std::size_t after = track.lower_bound(end + 1);
  const std::int64_t length = std::llround(edit.ease_s * static_cast<double>(Tick::kPerSecond));
  const std::size_t last = track.lower_bound(end + length);
  if (length == 0 || last <= after) return {};
  const std::size_t from = after > 0 ? after - 1 : 0;
  const Sample old = TrackReader(track.slice(from, after + 1 - from)).at(static_cast<double>(end));
  std::vector<Sample> samples = track.slice(after, last - after).to_vector();
  for (const std::size_t arm : indices_of(edit.arms)) {
    const Lead lead = Lead::of(old.arms[arm], now.arms[arm]);
    for (Sample& sample : samples) {
      const double left = 1.0 - eased(static_cast<double>(sample.tick - end) / static_cast<double>(length));
      follow(sample, arm, lead, left, document.block);
    }
  }
  return samples;
}

Status check(const Demonstration& document, const Overdub& edit) {
  if (!edit.clip) return fail(ErrorCode::kInvalidArgument, "there is no clip to put in");
  if (!std::isfinite(edit.at_s)) return fail(ErrorCode::kInvalidArgument, "the times must be finite");
  constexpr double kLongestEase_s = 60.0;
  if (!(edit.ease_s >= 0.0 && edit.ease_s <= kLongestEase_s)) {
    return fail(ErrorCode::kInvalidArgument, "the way back must take a number from 0 to 60 s");
  }
  const SampleTrack& track = document.samples;
  if (document.tick_from(std::max(edit.at_s, 0.0)) <= track.tick(track.size() - 1)) return {};
  return fail(ErrorCode::kInvalidArgument,
              fmt::format("there is nothing at {:.3f} s that could be replaced", edit.at_s));
}

}  // namespace

Result<Demonstration> made_by(const Demonstration& document, const Overdub& edit) {
  TROCAR_RETURN_IF_ERROR(check(document, edit));
  const SampleTrack& track = document.samples;
  const std::int64_t begin = std::max(document.tick_from(std::max(edit.at_s, 0.0)), track.tick(0));
  const std::size_t first = track.lower_bound(begin);
  const std::int64_t last_tick = track.tick(track.size() - 1);
  // The clip's own instants, so that it fills what was lifted; the other arm is read off between its samples.
  const std::size_t from = first > 0 ? first - 1 : 0;
  const SampleTrack& clip = edit.clip->samples;
  const std::size_t end_of_run = std::min(track.lower_bound(begin + clip.tick(clip.size() - 1)) + 1, track.size());
  TrackReader reader(track.slice(from, end_of_run - from));
  const std::vector<std::size_t> arms = indices_of(edit.arms);
  std::vector<Sample> made;
  for (const Sample& sample : clip) {
    const std::int64_t tick = begin + sample.tick;
    if (tick > last_tick) break;
    made.push_back(overdubbed(reader.at(static_cast<double>(tick)), sample, arms));
    made.back().tick = tick;
  }
  const std::int64_t end = made.back().tick;
  const std::vector<Sample> back = way_back(document, end, made.back(), edit);
  made.insert(made.end(), back.begin(), back.end());
  const std::size_t after = track.lower_bound(made.back().tick + 1);
  Demonstration edited = document;
  edited.samples = SampleTrack::joined(
      {track.slice(0, first), SampleTrack(std::move(made)), track.slice(after, track.size() - after)});
  return edited;
}

}  // namespace trocar::demonstration
