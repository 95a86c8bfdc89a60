#include "engine/trial/hand_provenance.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/trial/provenance.h"

namespace trocar::trial {
namespace {

using kinematics::ArmSide;
using kinematics::index_of;

/// The device, and who drove the arms that it did not: nothing of that is passed off as a person's.
std::string device_of(const HandOptions& options) {
  std::string words = options.device;
  for (const ArmSide side : kinematics::kArmSides) {
    const ArmSource source = options.sources[index_of(side)];
    if (source == ArmSource::kHand) continue;
    words += fmt::format("; {} arm {}", side == ArmSide::kLeft ? "left" : "right", to_string(source));
    if (source == ArmSource::kReplay && !options.replay_of.empty()) words += fmt::format(" of {}", options.replay_of);
  }
  return words;
}

}  // namespace

std::string_view to_string(ArmSource source) {
  switch (source) {
    case ArmSource::kHand:
      return "hand";
    case ArmSource::kScripted:
      return "scripted";
    case ArmSource::kReplay:
      return "replay";
    case ArmSource::kStill:
      return "still";
  }
  return "";
}

Status check(const HandOptions& options) {
  const auto exists = [](int index) { return index >= 0 && index < peg_board::kBlockCount; };
  if (!exists(options.block)) return fail(ErrorCode::kInvalidArgument, "the block is a number from 0 to 5");
  if (!exists(options.goal)) return fail(ErrorCode::kInvalidArgument, "the goal is a number from 0 to 5");
  if (!std::isfinite(options.time_limit_s) || options.time_limit_s <= 0.0) {
    return fail(ErrorCode::kInvalidArgument, "the time limit is not positive");
  }
  if (!std::isfinite(options.countdown_s) || options.countdown_s < 0.0) {
    return fail(ErrorCode::kInvalidArgument, "the countdown is negative");
  }
  const auto drives = [&options](ArmSource source) {
    return std::find(options.sources.begin(), options.sources.end(), source) != options.sources.end();
  };
  if (!drives(ArmSource::kHand)) {
    return fail(ErrorCode::kInvalidArgument, "the operator drives neither arm, so there is nothing to record by hand");
  }
  if (drives(ArmSource::kReplay) && options.replay.empty()) {
    return fail(ErrorCode::kInvalidArgument, "there is nothing to replay");
  }
  if (options.begin_segment && !options.initial_world.empty()) {
    return fail(ErrorCode::kInvalidArgument,
                "a take begins in one world: that of a segment, or that of a demonstration");
  }
  return {};
}

demonstration::Provenance provenance_of(const HandOptions& options, const simulation::WorldOptions& world) {
  demonstration::Provenance provenance = provenance_on(world, options.seed, options.block, options.goal);
  provenance.operator_kind = options.operator_kind;
  provenance.device = device_of(options);
  return provenance;
}

}  // namespace trocar::trial
