// The same motion elsewhere: Mirror, Retarget.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "engine/demonstration/edits/edit_functions.h"
#include "engine/demonstration/edits/stretch.h"

namespace trocar::demonstration {
namespace {

/// In a mirror through x and z; a rotation stays a rotation.
spatial::Pose mirrored(const spatial::Pose& X) {
  return {{X.p.x(), -X.p.y(), X.p.z()}, {X.q.w(), -X.q.x(), X.q.y(), -X.q.z()}};
}

ArmSample mirrored(const ArmSample& arm) {
  ArmSample result = arm;
  result.measured = CompactPose::from(mirrored(arm.measured.pose()));
  result.set_setpoint(mirrored(arm.setpoint()), arm.setpoint_jaw_rad);
  return result;
}

std::uint32_t swapped_flags(std::uint32_t flags) {
  const std::uint32_t others = flags & ~static_cast<std::uint32_t>(kLeftHolds | kRightHolds);
  return others | ((flags & kLeftHolds) != 0 ? kRightHolds : 0U) | ((flags & kRightHolds) != 0 ? kLeftHolds : 0U);
}

double eased(double x) {
  const double within = std::clamp(x, 0.0, 1.0);
  return within * within * (3.0 - 2.0 * within);
}

/// How much of the way to the other block and the other peg belongs to each instant.
struct RetargetShare {
  SegmentSpan carry;    ///< C: away from the block.
  SegmentSpan place;    ///< E: to the peg.
  double over_s = 0.0;  ///< In E: over the peg, before the block is lowered onto it.

  double of_block(double t_s) const { return 1.0 - eased((t_s - carry.begin_s) / (carry.end_s - carry.begin_s)); }
  double of_goal(double t_s) const { return eased((t_s - place.begin_s) / (over_s - place.begin_s)); }
};

/// When the right tool, holding the block in E, leaves the upper fifth of its heights for good; the middle of E where
/// it is not known to hold.
double begin_of_lowering(const Demonstration& document, const SampleTrack& samples, const SegmentSpan& place) {
  constexpr double kUpper = 0.8;
  const auto carried = [&](const Sample& sample) {
    const double t_s = document.time_of(sample);
    return t_s >= place.begin_s && t_s <= place.end_s && (sample.flags & kRightHolds) != 0;
  };
  double low_m = std::numeric_limits<double>::infinity();
  double high_m = -low_m;
  for (const Sample& sample : samples) {
    if (!carried(sample)) continue;
    low_m = std::min(low_m, sample.arms[1].setpoint_p[2]);
    high_m = std::max(high_m, sample.arms[1].setpoint_p[2]);
  }
  double over_s = 0.5 * (place.begin_s + place.end_s);
  if (!(high_m > low_m)) return over_s;
  for (const Sample& sample : samples) {
    if (carried(sample) && sample.arms[1].setpoint_p[2] >= low_m + kUpper * (high_m - low_m))
      over_s = document.time_of(sample);
  }
  return std::max(over_s, place.begin_s + 1.0 / kSampleRate_hz);
}

Result<RetargetShare> share_of(const Demonstration& document, const SampleTrack& samples) {
  const auto carry = document.segment(Segment::kC);
  const auto place = document.segment(Segment::kE);
  if (carry && place) return RetargetShare{*carry, *place, begin_of_lowering(document, samples, *place)};
  return fail(ErrorCode::kInvalidArgument, "it needs the segments C and E; label them first");
}

}  // namespace

Result<Demonstration> made_by(const Demonstration& document, const Mirror& /*edit*/) {
  return with_changed(document, {0, document.samples}, [](Sample& sample, std::size_t) {
    const ArmSample left = sample.arms[0];
    sample.arms[0] = mirrored(sample.arms[1]);
    sample.arms[1] = mirrored(left);
    for (CompactPose& block : sample.blocks) block = CompactPose::from(mirrored(block.pose()));
    sample.flags = swapped_flags(sample.flags);
  });
}

Result<Demonstration> made_by(const Demonstration& document, const Retarget& edit) {
  if (edit.block < 0 || edit.block >= peg_board::kBlockCount || edit.goal < 0 || edit.goal >= 6) {
    return fail(ErrorCode::kInvalidArgument, "blocks and goal pegs are numbered 0 to 5");
  }
  if (document.block < 0 || document.block >= peg_board::kBlockCount || document.goal < 0 || document.goal >= 6) {
    return fail(ErrorCode::kInvalidArgument, "it is not known which block was carried to which peg");
  }
  const Eigen::Vector3d to_block = peg_board::start_peg(edit.block) - peg_board::start_peg(document.block);
  const Eigen::Vector3d to_goal = peg_board::goal_peg(edit.goal) - peg_board::goal_peg(document.goal);
  const auto from = static_cast<std::size_t>(document.block);
  const auto to = static_cast<std::size_t>(edit.block);
  TROCAR_ASSIGN_OR_RETURN(const RetargetShare share, share_of(document, document.samples));
  const Sample start = document.samples.front();
  const auto retarget = [&](Sample& sample, std::size_t) {
    const double t_s = document.time_of(sample);
    const Eigen::Vector3d left_by = share.of_block(t_s) * to_block;
    const Eigen::Vector3d right_by = share.of_goal(t_s) * to_goal;
    // The block goes with whoever has it; before the grasp it stands where the left tool goes.
    const Eigen::Vector3d block_by =
        (sample.flags & kRightHolds) != 0 || t_s >= share.place.begin_s ? right_by : left_by;
    CompactPose block = sample.blocks[from];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      block.p[axis] += static_cast<float>(block_by[static_cast<Eigen::Index>(axis)]);
    }
    if (from != to) sample.blocks[from] = start.blocks[from];
    sample.blocks[to] = block;
    displace(sample, 0, left_by, Eigen::Quaterniond::Identity(), -1);
    displace(sample, 1, right_by, Eigen::Quaterniond::Identity(), -1);
  };
  Demonstration edited = with_changed(document, {0, document.samples}, retarget);
  edited.block = edit.block;
  edited.goal = edit.goal;
  return edited;
}

}  // namespace trocar::demonstration
