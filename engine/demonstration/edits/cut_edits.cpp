// Samples taken out or brought back: DeleteSpan, Revert.
#include <fmt/format.h>

#include <utility>

#include "engine/demonstration/edits/edit_functions.h"
#include "engine/demonstration/edits/stretch.h"

namespace trocar::demonstration {

Result<Demonstration> made_by(const Demonstration& document, const DeleteSpan& edit) {
  TROCAR_RETURN_IF_ERROR(check_range(edit.from_s, edit.to_s));
  const SampleTrack& track = document.samples;
  const std::size_t first = track.lower_bound(document.tick_from(edit.from_s));
  const std::size_t after = track.lower_bound(document.tick_from(edit.to_s));
  if (after <= first) {
    return fail(ErrorCode::kInvalidArgument, fmt::format("there is no sample from {} to {} s", edit.from_s, edit.to_s));
  }
  const bool to_the_end = after == track.size();
  const std::int64_t shift = edit.ripple && !to_the_end ? track.tick(first) - track.tick(after) : 0;
  if (edit.ripple) return with_other_length(document, first, after - first, {}, shift);
  Demonstration edited = document;
  edited.samples = SampleTrack::joined({track.slice(0, first), track.slice(after, track.size())});
  if (edited.gated().size() >= 2) return edited;
  return fail(ErrorCode::kInvalidArgument, "fewer than 2 samples would stay between the gates");
}

namespace {

/// Of the arm what was recorded at the same tick: poses, jaw or both; what it holds moves with it.
void bring_back(Sample& sample, const Sample& recorded, std::size_t arm, RevertWhat what, int block) {
  const ArmSample& then = recorded.arms[arm];
  ArmSample& now = sample.arms[arm];
  if (what != RevertWhat::kJaw) {
    const spatial::Pose X_WT = now.measured.pose();
    const spatial::Pose X_WT_then = then.measured.pose();
    displace(sample, arm, X_WT_then.p - X_WT.p, X_WT_then.q * X_WT.q.conjugate(), block);
    now.measured = then.measured;
    now.set_setpoint(then.setpoint(), now.setpoint_jaw_rad);
    now.joints = then.joints;
    // To the bit where the recording knows it; what only the edited arm holds was moved along.
    const bool held = (recorded.flags & sample.flags & holds_flag(arm)) != 0;
    if (held && block >= 0 && block < peg_board::kBlockCount) {
      sample.blocks[static_cast<std::size_t>(block)] = recorded.blocks[static_cast<std::size_t>(block)];
    }
  }
  if (what == RevertWhat::kPose) return;
  now.setpoint_jaw_rad = then.setpoint_jaw_rad;
  now.jaw_rad = then.jaw_rad;
}

/// One channel or one arm: the samples stay those that there are.
Result<Demonstration> channel_reverted(const Demonstration& document, const Revert& edit) {
  TROCAR_ASSIGN_OR_RETURN(Stretch stretch, stretch_of(document, edit.from_s, edit.to_s, 1));
  const SampleTrack& track = document.recorded;
  const std::size_t first = track.lower_bound(stretch.samples.front().tick);
  const std::size_t after = track.lower_bound(stretch.samples.back().tick + 1);
  const std::size_t begin = first > 0 ? first - 1 : 0;
  const SampleTrack recorded = track.slice(begin, after + 1 - begin);
  if (after <= first) {
    return fail(ErrorCode::kInvalidArgument,
                fmt::format("nothing was recorded from {} to {} s", edit.from_s, edit.to_s));
  }
  const std::int64_t begin_tick = recorded.tick(0);
  const std::int64_t end_tick = recorded.tick(recorded.size() - 1);
  TrackReader reader(recorded);
  for (Sample& sample : stretch.samples) {
    if (sample.tick < begin_tick || sample.tick > end_tick) continue;
    const Sample then = reader.at(static_cast<double>(sample.tick));
    for (const std::size_t arm : indices_of(edit.arms)) bring_back(sample, then, arm, edit.what, document.block);
  }
  return with_stretch(document, std::move(stretch));
}

}  // namespace

Result<Demonstration> made_by(const Demonstration& document, const Revert& edit) {
  TROCAR_RETURN_IF_ERROR(check_range(edit.from_s, edit.to_s));
  if (edit.what == RevertWhat::kLabels) return with_recorded_labels(document, edit.from_s, edit.to_s);
  if (edit.what != RevertWhat::kSamples || edit.arms != Arms::kBoth) return channel_reverted(document, edit);
  const auto part = [&](const SampleTrack& track) {
    const std::size_t first = track.lower_bound(document.tick_from(edit.from_s));
    return std::pair{first, track.lower_bound(document.tick_after(edit.to_s))};
  };
  const auto [first, last] = part(document.samples);
  const auto [recorded_first, recorded_last] = part(document.recorded);
  if (recorded_last <= recorded_first) {
    return fail(ErrorCode::kInvalidArgument,
                fmt::format("nothing was recorded from {} to {} s", edit.from_s, edit.to_s));
  }
  Demonstration edited = document;
  edited.samples = SampleTrack::joined({document.samples.slice(0, first),
                                        document.recorded.slice(recorded_first, recorded_last - recorded_first),
                                        document.samples.slice(last, document.samples.size())});
  return edited;
}

}  // namespace trocar::demonstration
