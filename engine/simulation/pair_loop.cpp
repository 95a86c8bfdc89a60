#include "engine/simulation/pair_loop.h"

#include <algorithm>
#include <cmath>

namespace trocar::simulation {
namespace {

using namespace peg_board;

constexpr double kJawReach_m =
    0.0025;  ///< From the segment wrist–tip to the farthest point of a jaw, closed or nearly.
constexpr double kShaftReach_m = 0.0040;

Eigen::Vector3d centre_of(const Block& block) {
  return from_ode(dBodyGetPosition(block.body.get()));
}

bool awake(const Block& block) {
  return dBodyIsEnabled(block.body.get()) != 0;
}

/// How far the tips of opened jaws stand away from the tool's axis, and some.
double jaw_sweep(const Gripper& gripper) {
  return kJawReach_m + kinematics::kTipFromWrist_m * std::sin(std::min(1.6, std::abs(opening(gripper)) / 2.0 + 0.05));
}

}  // namespace

double distance_to_segment(const Eigen::Vector3d& point, const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  const Eigen::Vector3d along = b - a;
  const double s = std::clamp((point - a).dot(along) / along.squaredNorm(), 0.0, 1.0);
  return (point - a - s * along).norm();
}

bool PairLoop::finish(const Physics& physics, const PairLoopInput& input, const ContactMaterial& material) {
  if (patch_.empty()) return false;
  patch_.thin();
  patch_.connect(physics.world(), physics.contacts.get(), material, input.step_s);
  return true;
}

void PairLoop::block_with_blocks(const Physics& physics, const PairLoopInput& input, std::size_t block) {
  const Block& first = physics.blocks[block];
  for (std::size_t other = block + 1; other < physics.blocks.size(); ++other) {
    const Block& second = physics.blocks[other];
    if (!awake(first) && !awake(second)) continue;
    if ((centre_of(first) - centre_of(second)).squaredNorm() > 4.0 * kBlockRadius_m * kBlockRadius_m) continue;
    patch_.clear();
    for (const OdeGeom& a : first.boxes) {
      for (const OdeGeom& b : second.boxes) patch_.collide(a.get(), b.get());
    }
    if (patch_.empty()) continue;
    if (input.fast[block] || input.fast[other]) {
      dBodyEnable(first.body.get());
      dBodyEnable(second.body.get());
    }
    finish(physics, input, {input.scene_friction, {}});
  }
}

void PairLoop::block_with_arm(const Physics& physics, const PairLoopInput& input, std::size_t block, std::size_t arm,
                              BlockTouch& touch) {
  const Block& held = physics.blocks[block];
  const Gripper& gripper = physics.grippers[arm];
  const auto& skeleton = input.postures[arm].skeleton;
  const Eigen::Vector3d centre = centre_of(held);
  for (std::size_t i = 0; i < gripper.links.size(); ++i) {
    if (distance_to_segment(centre, skeleton[2 - i], skeleton[1 - i]) > kBlockRadius_m + kShaftReach_m) continue;
    patch_.clear();
    for (const OdeGeom& box : held.boxes) patch_.collide(box.get(), gripper.links[i].capsule.get());
    if (patch_.empty()) continue;
    dBodyEnable(held.body.get());
    touch.shaft |= finish(physics, input, {input.scene_friction, {}});
  }
  if (distance_to_segment(centre, skeleton[2], skeleton[3]) > kBlockRadius_m + jaw_sweep(gripper)) return;
  for (std::size_t i = 0; i < gripper.jaws.size(); ++i) {
    patch_.clear();
    for (const OdeGeom& box : held.boxes) patch_.collide(box.get(), gripper.jaws[i].box.get());
    if (patch_.empty()) continue;
    dBodyEnable(held.body.get());
    touch.jaws[arm][i] = finish(physics, input, {input.jaw_friction, finger_direction(gripper.jaws[i])});
  }
}

void PairLoop::block_with_scene(const Physics& physics, const PairLoopInput& input, std::size_t block,
                                BlockTouch& touch) {
  const Block& resting = physics.blocks[block];
  const Eigen::Vector3d centre = centre_of(resting);
  const ContactMaterial material{input.scene_friction, {}};
  if (centre.z() < kBlockRadius_m) {
    for (const OdeGeom* ground : {&physics.board.board, &physics.board.table}) {
      patch_.clear();
      for (const OdeGeom& box : resting.boxes) patch_.collide(box.get(), ground->get());
      touch.scene |= finish(physics, input, material);
    }
  }
  if (centre.z() > kPegHeight_m + kBlockRadius_m) return;
  for (std::size_t i = 0; i < physics.board.pegs.size(); ++i) {
    if ((centre - physics.board.feet[i]).head<2>().norm() > kBlockRadius_m + kPegRadius_m) continue;
    patch_.clear();
    for (const OdeGeom& box : resting.boxes) patch_.collide(box.get(), physics.board.pegs[i].get());
    touch.scene |= finish(physics, input, material);
  }
}

void PairLoop::jaws_with_scene(const Physics& physics, const PairLoopInput& input, std::size_t arm) {
  const Gripper& gripper = physics.grippers[arm];
  const auto& skeleton = input.postures[arm].skeleton;
  const double sweep = jaw_sweep(gripper);
  const double low = std::min(skeleton[2].z(), skeleton[3].z()) - sweep;
  if (low > kPegHeight_m) return;
  const ContactMaterial material{input.scene_friction, {}};
  for (const Jaw& jaw : gripper.jaws) {
    if (low < 0.0) {
      for (const OdeGeom* ground : {&physics.board.board, &physics.board.table}) {
        patch_.clear();
        patch_.collide(jaw.box.get(), ground->get());
        finish(physics, input, material);
      }
    }
    for (std::size_t i = 0; i < physics.board.pegs.size(); ++i) {
      Eigen::Vector3d foot = physics.board.feet[i];
      foot.z() = std::clamp(skeleton[3].z(), 0.0, kPegHeight_m);
      if (distance_to_segment(foot, skeleton[2], skeleton[3]) > 0.012 + sweep) continue;
      patch_.clear();
      patch_.collide(jaw.box.get(), physics.board.pegs[i].get());
      finish(physics, input, material);
    }
  }
}

std::array<BlockTouch, kBlockCount> PairLoop::connect(const Physics& physics, const PairLoopInput& input) {
  Touches touches{};
  // What can wake a block comes first, so that all that is awake then finds its ground.
  for (std::size_t block = 0; block < physics.blocks.size(); ++block) {
    for (std::size_t arm = 0; arm < physics.grippers.size(); ++arm) {
      block_with_arm(physics, input, block, arm, touches[block]);
    }
    block_with_blocks(physics, input, block);
  }
  for (std::size_t block = 0; block < physics.blocks.size(); ++block) {
    if (awake(physics.blocks[block])) block_with_scene(physics, input, block, touches[block]);
  }
  for (std::size_t arm = 0; arm < physics.grippers.size(); ++arm) jaws_with_scene(physics, input, arm);
  return touches;
}

}  // namespace trocar::simulation
