/// Which bodies touch: every pair that may, in an order that never changes.
#pragma once

#include <array>

#include "engine/simulation/contacts.h"
#include "engine/simulation/physics.h"

namespace trocar::simulation {

/// What a block touched in one tick.
struct BlockTouch {
  std::array<std::array<bool, 2>, 2> jaws{};  ///< [arm][jaw]
  bool scene = false;
  bool shaft = false;
};

struct Touches {
  std::array<BlockTouch, peg_board::kBlockCount> blocks{};
  std::array<bool, 2> arms{};  ///< Whether an arm's jaws or shaft touch anything.
};

/// What the pair loop needs to know besides ODE's bodies. Blocks that sleep (their bodies are disabled) are static for
/// everything that moves slowly; what moves fast wakes them.
struct PairLoopInput {
  std::array<ArmPosture, 2> postures;
  std::array<double, 2> openings_rad{};
  double jaw_friction = 0.8;
  double scene_friction = 0.4;
  double step_s = 0.001;
  std::array<bool, peg_board::kBlockCount> fast{};  ///< Blocks that move faster than a resting one may.
};

/// Makes the contact joints of this tick. ODE's own spaces are not used: they reorder what moved, and the order of
/// contacts decides the last bits. Arms do not touch each other, nor an arm's jaws each other (the servo stops at 0).
class PairLoop {
 public:
  Touches connect(const Physics& physics, const PairLoopInput& input);

 private:
  void block_with_blocks(const Physics& physics, const PairLoopInput& input, std::size_t block);
  bool block_with_shaft(const Physics& physics, const PairLoopInput& input, std::size_t block, std::size_t arm);
  bool block_with_jaws(const Physics& physics, const PairLoopInput& input, std::size_t block, std::size_t arm,
                       std::array<bool, 2>& touching);
  void block_with_scene(const Physics& physics, const PairLoopInput& input, std::size_t block, BlockTouch& touch);
  bool jaws_with_scene(const Physics& physics, const PairLoopInput& input, std::size_t arm);
  bool finish(const Physics& physics, const PairLoopInput& input, const ContactMaterial& material);

  ContactPatch patch_;
  std::array<double, 2> sweeps_m_{};  ///< How far from the tool's axis a jaw may reach, for each arm.
};

/// The distance between a point and a segment.
double distance_to_segment(const Eigen::Vector3d& point, const Eigen::Vector3d& a, const Eigen::Vector3d& b);

}  // namespace trocar::simulation
