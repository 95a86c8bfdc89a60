/// Follows both tools from sample to sample and measures only what may have come nearer. Private to the module.
#pragma once

#include <array>

#include "engine/review/clearance.h"
#include "engine/simulation/shapes.h"

namespace trocar::review {

/// One run of neighbouring samples. The distances are exact: a pair of shapes is passed over only as long as the way
/// that both have gone since it was measured cannot have brought them nearer than the nearest pair.
class Sweep {
 public:
  /// `block`: the one that is carried, or `demonstration::kUnknownPlace`.
  explicit Sweep(int block);
  SampleReview next(const demonstration::Sample& sample);

 private:
  static constexpr std::size_t kBlocks = peg_board::kBlockCount;
  static constexpr std::size_t kPegs = peg_board::kPegCount;
  using BlockShape = std::array<RoundedBox, simulation::kBoxesPerBlock>;
  /// At least so far apart, by part of the tool and obstacle.
  template <std::size_t kCount>
  using Bounds = std::array<std::array<double, kCount>, kPartCount>;

  struct Block {
    demonstration::CompactPose pose;
    spatial::Pose X_WK;
    BlockShape shape;
    bool known = false;    ///< Where it is.
    double moved_m = 0.0;  ///< At most, since the sample before.
  };
  struct Tool {
    ToolShape shape;
    std::array<double, kPartCount> moved_m{};
    Bounds<kPegs> pegs{};
    Bounds<kBlocks> blocks{};
    Bounds<kPartCount> other{};  ///< Of the left tool alone.
    std::array<Nearest, kObstacleCount> last;
  };

  void move_blocks(const demonstration::Sample& sample);
  void move_tool(const demonstration::ArmSample& arm, std::size_t index);
  Nearest board(const Tool& tool) const;
  Nearest pegs(Tool& tool) const;
  Nearest blocks(Tool& tool, bool holds) const;
  Nearest tools();
  void set_reach(const demonstration::ArmSample& arm, std::size_t index, ToolReview& review) const;

  int carried_;
  bool started_ = false;
  std::array<kinematics::PsmModel, 2> models_;
  std::array<Cylinder, kPegs> peg_shapes_;
  std::array<Block, kBlocks> blocks_;
  std::array<Tool, 2> tools_;
};

/// The separation of the pair of shapes that a review found nearest; the tool is the first shape.
Separation separation_at(const demonstration::Sample& sample, std::size_t arm, Obstacle obstacle,
                         const Nearest& nearest);

}  // namespace trocar::review
