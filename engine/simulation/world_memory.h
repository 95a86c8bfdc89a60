/// Everything that a world's next step depends on, as plain values, and its form as bytes.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "engine/core/random.h"
#include "engine/simulation/body_bits.h"
#include "engine/simulation/world.h"

namespace trocar::simulation {

struct ArmMemory {
  ArmCommand setpoint;
  kinematics::Joints setpoint_joints{};
  spatial::Pose X_WT;
  kinematics::Joints joints{};
  std::array<BodyBits, 2> jaws{};
};

struct BlockMemory {
  BodyBits body{};
  std::int32_t rest_ticks = 0;
  bool asleep = false;
  bool touches_scene = false;
  std::array<std::array<bool, 2>, 2> jaw_contact{};
};

struct WorldMemory {
  std::int64_t tick = 0;
  std::int64_t strained = 0;
  Random::State random{};
  std::array<ArmMemory, 2> arms;
  std::array<BlockMemory, peg_board::kBlockCount> blocks;
};

struct StoredWorld {
  WorldOptions options;
  WorldMemory memory;
};

/// Host byte order; magic, version and options at the front.
std::string encode(const WorldOptions& options, const WorldMemory& memory);
/// Where in the bytes the memory begins: what lies before it is the options.
std::size_t memory_offset();
/// Errors: kInvalidArgument for bytes that are not a snapshot of this version, of the wrong length, or that no world
/// can have written (not finite, not a rotation, joints beyond their limits).
Result<StoredWorld> decode(std::string_view bytes);

}  // namespace trocar::simulation
