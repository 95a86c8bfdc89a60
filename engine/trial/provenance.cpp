#include "engine/trial/provenance.h"

#include <string>
#include <string_view>

#include "engine/core/hash.h"
#include "engine/peg_board/peg_board.h"

namespace trocar::trial {
namespace {

constexpr std::string_view kSoftware = "trocar 0.1.0";

/// Of what a world is made of, to tell whether two recordings are of the same scene.
std::string scene_hash(const simulation::WorldOptions& options) {
  Hasher hasher;
  hasher.value(options.seed).value(options.jaw_friction).value(options.scene_friction);
  hasher.value(options.grip_torque_nm).value(options.ticks_per_second);
  for (int i = 0; i < peg_board::kBlockCount; ++i) {
    for (const Eigen::Vector3d& foot : {peg_board::start_peg(i), peg_board::goal_peg(i)}) {
      hasher.value(foot.x()).value(foot.y()).value(foot.z());
    }
  }
  return to_hex(hasher.digest());
}

}  // namespace

demonstration::Provenance provenance_on(const simulation::WorldOptions& world, std::uint64_t seed, int block,
                                        int goal) {
  demonstration::Provenance provenance;
  provenance.seed = seed;
  provenance.block = block;
  provenance.goal = goal;
  provenance.scene_hash = scene_hash(world);
  provenance.software = kSoftware;
  return provenance;
}

}  // namespace trocar::trial
