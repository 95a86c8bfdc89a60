#include "engine/simulation/pair_loop.h"

#include <algorithm>
#include <cmath>

namespace trocar::simulation {
namespace {

using namespace peg_board;
using kinematics::kTipFromWrist_m;

constexpr double kJawReach_m =
    0.0025;  ///< From the segment wrist–tip to the farthest point of a jaw, closed or nearly.
constexpr double kShaftReach_m = 0.0040;

Eigen::Vector3d centre_of(const Block& block) {
  return from_ode(dBodyGetPosition(block.body.get()));
}

bool awake(const Block& block) {
  return dBodyIsEnabled(block.body.get()) != 0;
}

/// How far from the tool's axis jaws that are opened that far may reach.
double sweep_of(double opening_rad) {
  return kJawReach_m + kTipFromWrist_m * std::sin(std::min(1.5, std::abs(opening_rad) / 2.0 + 0.05));
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

bool PairLoop::block_with_shaft(const Physics& physics, const PairLoopInput& input, std::size_t block,
                                std::size_t arm) {
  const Block& pushed = physics.blocks[block];
  const auto& skeleton = input.postures[arm].skeleton;
  const Eigen::Vector3d centre = centre_of(pushed);
  constexpr double kReach_m = kBlockRadius_m + kShaftReach_m;
  if (centre.z() + kReach_m < std::min({skeleton[0].z(), skeleton[1].z(), skeleton[2].z()})) return false;
  bool touching = false;
  for (std::size_t i = 0; i < physics.grippers[arm].links.size(); ++i) {
    if (distance_to_segment(centre, skeleton[2 - i], skeleton[1 - i]) > kReach_m) continue;
    patch_.clear();
    for (const OdeGeom& box : pushed.boxes) patch_.collide(box.get(), physics.grippers[arm].links[i].capsule.get());
    if (patch_.empty()) continue;
    dBodyEnable(pushed.body.get());
    touching |= finish(physics, input, {input.scene_friction, {}});
  }
  return touching;
}

bool PairLoop::block_with_jaws(const Physics& physics, const PairLoopInput& input, std::size_t block, std::size_t arm,
                               std::array<bool, 2>& touching) {
  const Block& held = physics.blocks[block];
  const Gripper& gripper = physics.grippers[arm];
  const auto& skeleton = input.postures[arm].skeleton;
  const double reach_m = kBlockRadius_m + sweeps_m_[arm];
  const Eigen::Vector3d centre = centre_of(held);
  if (centre.z() + reach_m < std::min(skeleton[2].z(), skeleton[3].z())) return false;
  if (distance_to_segment(centre, skeleton[2], skeleton[3]) > reach_m) return false;
  for (std::size_t i = 0; i < gripper.jaws.size(); ++i) {
    patch_.clear();
    for (const OdeGeom& box : held.boxes) patch_.collide(box.get(), gripper.jaws[i].box.get());
    if (patch_.empty()) continue;
    dBodyEnable(held.body.get());
    touching[i] = finish(physics, input, {input.jaw_friction, finger_direction(gripper.jaws[i])});
  }
  return touching[0] || touching[1];
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

bool PairLoop::jaws_with_scene(const Physics& physics, const PairLoopInput& input, std::size_t arm) {
  const auto& skeleton = input.postures[arm].skeleton;
  const double sweep_m = sweeps_m_[arm];
  const double low = std::min(skeleton[2].z(), skeleton[3].z()) - sweep_m;
  if (low > kPegHeight_m) return false;
  const ContactMaterial material{input.scene_friction, {}};
  bool touching = false;
  for (const Jaw& jaw : physics.grippers[arm].jaws) {
    const auto touch = [&](const OdeGeom& geom) {
      patch_.clear();
      patch_.collide(jaw.box.get(), geom.get());
      touching |= finish(physics, input, material);
    };
    if (low < 0.0) {
      touch(physics.board.board);
      touch(physics.board.table);
    }
    for (std::size_t i = 0; i < physics.board.pegs.size(); ++i) {
      Eigen::Vector3d beside = physics.board.feet[i];
      beside.z() = std::clamp(skeleton[3].z(), 0.0, kPegHeight_m);
      if (distance_to_segment(beside, skeleton[2], skeleton[3]) < kTipFromWrist_m + sweep_m)
        touch(physics.board.pegs[i]);
    }
  }
  return touching;
}

Touches PairLoop::connect(const Physics& physics, const PairLoopInput& input) {
  Touches touches;
  for (std::size_t arm = 0; arm < sweeps_m_.size(); ++arm) sweeps_m_[arm] = sweep_of(input.openings_rad[arm]);
  // What can wake a block comes first, so that all that is awake then finds its ground.
  for (std::size_t block = 0; block < physics.blocks.size(); ++block) {
    BlockTouch& touch = touches.blocks[block];
    for (std::size_t arm = 0; arm < physics.grippers.size(); ++arm) {
      const bool by_shaft = block_with_shaft(physics, input, block, arm);
      const bool by_jaws = block_with_jaws(physics, input, block, arm, touch.jaws[arm]);
      touch.shaft |= by_shaft;
      touches.arms[arm] |= by_shaft || by_jaws;
    }
    block_with_blocks(physics, input, block);
  }
  for (std::size_t block = 0; block < physics.blocks.size(); ++block) {
    if (awake(physics.blocks[block])) block_with_scene(physics, input, block, touches.blocks[block]);
  }
  for (std::size_t arm = 0; arm < physics.grippers.size(); ++arm) {
    touches.arms[arm] |= jaws_with_scene(physics, input, arm);
  }
  return touches;
}

}  // namespace trocar::simulation
