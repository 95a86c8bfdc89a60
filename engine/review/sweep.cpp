#include "engine/review/sweep.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/spatial/rotation.h"

namespace trocar::review {
namespace {

using demonstration::ArmSample;
using demonstration::CompactPose;
using demonstration::Sample;
using Eigen::Vector3d;
using namespace peg_board;

constexpr double kUnmeasured = -std::numeric_limits<double>::infinity();
constexpr std::size_t kBoard = 0;
constexpr std::size_t kPeg = 1;
constexpr std::size_t kBlock = 2;
constexpr std::size_t kOther = 3;

/// The box's longest line is its third axis, for jaws and capsules alike: all of it lies within this of that line.
double girth(const RoundedBox& box) {
  return std::hypot(box.half_m.x(), box.half_m.y()) + box.radius_m;
}

Vector3d half_line(const RoundedBox& box) {
  return box.half_m.z() * box.R.col(2);
}

/// No point of the shape has gone farther.
double largest_move(const RoundedBox& from, const RoundedBox& to) {
  const Vector3d middle = to.p - from.p;
  const Vector3d half = half_line(to) - half_line(from);
  double most = std::max((middle + half).norm(), (middle - half).norm());
  for (int i = 0; i < 2; ++i) most += to.half_m[i] * (to.R.col(i) - from.R.col(i)).norm();
  return most;
}

RoundedBox board_shape() {
  RoundedBox box;
  box.p = {0.0, 0.0, -0.5 * kBoardZ_m};
  box.half_m = 0.5 * Vector3d(kBoardX_m, kBoardY_m, kBoardZ_m);
  return box;
}

/// The lowest point of a shape without its rounding.
Vector3d lowest(const RoundedBox& box) {
  const Vector3d down = box.R.row(2).transpose();
  return box.p - box.R * Vector3d(std::copysign(box.half_m.x(), down.x()), std::copysign(box.half_m.y(), down.y()),
                                  std::copysign(box.half_m.z(), down.z()));
}

double to_board(const RoundedBox& shape) {
  static const RoundedBox kBoardShape = board_shape();
  const Vector3d low = lowest(shape);
  const bool over_board = std::abs(low.x()) <= kBoardShape.half_m.x() && std::abs(low.y()) <= kBoardShape.half_m.y();
  // Above half of its depth the nearest way out of the board is up.
  if (over_board && low.z() > -0.4 * kBoardZ_m) return low.z() - shape.radius_m;
  const double to_table = low.z() - shape.radius_m - kTableZ_m;
  if (to_table > kHorizon_m - kTableZ_m) return kHorizon_m;
  return std::min(to_table, separation(shape, kBoardShape).distance_m);
}

std::array<RoundedBox, simulation::kBoxesPerBlock> block_shape(const spatial::Pose& X_WK) {
  static const auto kBoxes = simulation::block_boxes();
  std::array<RoundedBox, simulation::kBoxesPerBlock> shape;
  const Eigen::Matrix3d R_WK = X_WK.rotation();
  for (std::size_t i = 0; i < shape.size(); ++i) {
    const simulation::BlockBox& box = kBoxes[i];
    const double c = std::cos(box.angle_rad);
    const double s = std::sin(box.angle_rad);
    // Its longest line third: the width of a wall, the height of a corner.
    const Vector3d out = R_WK * Vector3d(c, s, 0.0);
    const Vector3d across = R_WK * Vector3d(-s, c, 0.0);
    const bool wide = box.width_m > kBlockHeight_m;
    shape[i].p = X_WK.p + box.distance_m * out;
    shape[i].R << out, (wide ? Vector3d(R_WK.col(2)) : across), (wide ? across : Vector3d(R_WK.col(2)));
    shape[i].half_m =
        0.5 * Vector3d(box.depth_m, wide ? kBlockHeight_m : box.width_m, wide ? box.width_m : kBlockHeight_m);
  }
  return shape;
}

double least_between(const RoundedBox& a, const RoundedBox& b) {
  return distance_of_segments(a.p, half_line(a), b.p, half_line(b)) - girth(a) - girth(b);
}

/// The exact distance if it may be below `enough`; else a bound that is not below it.
double distance_or_bound(const RoundedBox& a, const RoundedBox& b, double enough) {
  const double bound = least_between(a, b);
  return bound >= enough ? bound : separation(a, b).distance_m;
}

double distance_or_bound(const RoundedBox& a, const Cylinder& peg, double enough) {
  const Vector3d half(0.0, 0.0, 0.5 * peg.height_m);
  const double bound = distance_of_segments(a.p, half_line(a), peg.foot + half, half) - girth(a) - peg.radius_m;
  return bound >= enough ? bound : separation(a, peg).distance_m;
}

double distance_or_bound(const RoundedBox& a, const std::array<RoundedBox, simulation::kBoxesPerBlock>& block,
                         const Vector3d& p_WK, double enough) {
  const double whole =
      distance_of_segments(a.p, half_line(a), p_WK, Vector3d::Zero()) - girth(a) - simulation::kBlockRadius_m;
  if (whole >= enough) return whole;
  double least = std::numeric_limits<double>::infinity();
  for (const RoundedBox& box : block) least = std::min(least, distance_or_bound(a, box, std::min(enough, least)));
  return least;
}

/// Measures the pairs of one tool and one kind of obstacle, the one that was nearest before first. `measure(part, k,
/// enough)` gives the exact distance below `enough`, a bound above; `counts(part, k)` whether the pair is looked at.
template <typename Bounds, typename Measure, typename Counts>
Nearest nearest_of(Bounds& bounds, const Nearest& before, const Measure& measure, const Counts& counts) {
  Nearest best;
  double least = kHorizon_m;
  const auto look = [&](std::size_t part, std::size_t k) {
    double& bound = bounds[part][k];
    if (bound >= least || !counts(part, k)) return;
    bound = measure(part, k, least);
    if (bound >= least) return;
    least = bound;
    best = {static_cast<float>(least), static_cast<Part>(part), static_cast<std::uint8_t>(k)};
  };
  look(static_cast<std::size_t>(before.part), before.index);
  for (std::size_t part = 0; part < bounds.size(); ++part) {
    for (std::size_t k = 0; k < bounds[part].size(); ++k) look(part, k);
  }
  return best;
}

Separation apart_from(const RoundedBox& shape, const std::array<RoundedBox, simulation::kBoxesPerBlock>& block) {
  Separation least = separation(shape, block.front());
  for (const RoundedBox& box : block) {
    const Separation other = separation(shape, box);
    if (other.distance_m < least.distance_m) least = other;
  }
  return least;
}

ToolShape shape_of(const Sample& sample, std::size_t arm) {
  const kinematics::PsmModel model = kinematics::psm_model(kinematics::kArmSides[arm]);
  spatial::Pose X_WT = sample.arms[arm].measured.pose();
  X_WT.q.normalize();
  return tool_shape(model, X_WT, static_cast<double>(sample.arms[arm].jaw_rad));
}

Cylinder peg_shape(int peg) {
  return {peg < kBlockCount ? start_peg(peg) : goal_peg(peg - kBlockCount), kPegRadius_m, kPegHeight_m};
}

bool same(const CompactPose& a, const CompactPose& b) {
  return a.p == b.p && a.q_wxyz == b.q_wxyz;
}

}  // namespace

Sweep::Sweep(int block)
    : carried_(block),
      models_{kinematics::psm_model(kinematics::ArmSide::kLeft), kinematics::psm_model(kinematics::ArmSide::kRight)} {
  // Nothing is known of a pair that was never measured.
  for (Tool& tool : tools_) {
    for (std::size_t part = 0; part < kPartCount; ++part) {
      tool.pegs[part].fill(kUnmeasured);
      tool.blocks[part].fill(kUnmeasured);
      tool.other[part].fill(kUnmeasured);
    }
  }
  for (int i = 0; i < kPegCount; ++i) peg_shapes_[static_cast<std::size_t>(i)] = peg_shape(i);
}

void Sweep::move_blocks(const Sample& sample) {
  for (std::size_t i = 0; i < kBlocks; ++i) {
    Block& block = blocks_[i];
    const CompactPose& pose = sample.blocks[i];
    block.moved_m = 0.0;
    if (started_ && same(block.pose, pose)) continue;
    const spatial::Pose before = block.X_WK;
    block.pose = pose;
    block.known = demonstration::is_known(pose);
    block.X_WK = pose.pose();
    block.X_WK.q.normalize();
    block.shape = block_shape(block.X_WK);
    // A rotation moves nothing by more than its angle times the radius.
    block.moved_m =
        (block.X_WK.p - before.p).norm() + simulation::kBlockRadius_m * spatial::angle_between(block.X_WK.q, before.q);
  }
}

void Sweep::move_tool(const ArmSample& arm, std::size_t index) {
  Tool& tool = tools_[index];
  spatial::Pose X_WT = arm.measured.pose();
  X_WT.q.normalize();
  const ToolShape shape = tool_shape(models_[index], X_WT, static_cast<double>(arm.jaw_rad));
  for (std::size_t part = 0; part < kPartCount; ++part) {
    tool.moved_m[part] = started_ ? largest_move(tool.shape[part], shape[part]) : 0.0;
    for (double& bound : tool.pegs[part]) bound -= tool.moved_m[part];
    for (std::size_t k = 0; k < kBlocks; ++k) tool.blocks[part][k] -= tool.moved_m[part] + blocks_[k].moved_m;
  }
  tool.shape = shape;
}

Nearest Sweep::board(const Tool& tool) const {
  Nearest best;
  for (std::size_t part = 0; part < kPartCount; ++part) {
    const auto distance = static_cast<float>(to_board(tool.shape[part]));
    if (distance < best.distance_m) best = {distance, static_cast<Part>(part), 0};
  }
  return best;
}

Nearest Sweep::pegs(Tool& tool) const {
  return nearest_of(
      tool.pegs, tool.last[kPeg],
      [&](std::size_t part, std::size_t k, double enough) {
        return distance_or_bound(tool.shape[part], peg_shapes_[k], enough);
      },
      [](std::size_t, std::size_t) { return true; });
}

Nearest Sweep::blocks(Tool& tool, bool holds) const {
  const auto carried = static_cast<std::size_t>(carried_);
  const auto counts = [&](std::size_t part, std::size_t k) {
    const bool jaws = part >= static_cast<std::size_t>(Part::kJaw0);
    if (!blocks_[k].known) return false;
    // Which block is carried may not be known: then it may be any.
    if (carried_ < 0) return !jaws;
    return k != carried || !(jaws || holds);
  };
  return nearest_of(
      tool.blocks, tool.last[kBlock],
      [&](std::size_t part, std::size_t k, double enough) {
        return distance_or_bound(tool.shape[part], blocks_[k].shape, blocks_[k].X_WK.p, enough);
      },
      counts);
}

Nearest Sweep::tools() {
  Tool& left = tools_[0];
  const Tool& right = tools_[1];
  for (std::size_t part = 0; part < kPartCount; ++part) {
    for (std::size_t k = 0; k < kPartCount; ++k) left.other[part][k] -= left.moved_m[part] + right.moved_m[k];
  }
  return nearest_of(
      left.other, left.last[kOther],
      [&](std::size_t part, std::size_t k, double enough) {
        return distance_or_bound(left.shape[part], right.shape[k], enough);
      },
      [](std::size_t, std::size_t) { return true; });
}

void Sweep::set_reach(const ArmSample& arm, std::size_t index, ToolReview& review) const {
  spatial::Pose X_WT = arm.setpoint();
  X_WT.q.normalize();
  const Result<kinematics::Excess> excess = kinematics::excess_at(models_[index], X_WT);
  review.reachable = excess.has_value();
  if (excess) review.excess = *excess;
}

SampleReview Sweep::next(const Sample& sample) {
  SampleReview review;
  if (!demonstration::is_finite(sample)) {
    // What comes after is measured afresh.
    *this = Sweep(carried_);
    return review;
  }
  move_blocks(sample);
  for (std::size_t i = 0; i < 2; ++i) move_tool(sample.arms[i], i);
  const std::array<bool, 2> holds{(sample.flags & demonstration::kLeftHolds) != 0,
                                  (sample.flags & demonstration::kRightHolds) != 0};
  for (std::size_t i = 0; i < 2; ++i) {
    Tool& tool = tools_[i];
    review[i].nearest[kBoard] = board(tool);
    review[i].nearest[kPeg] = pegs(tool);
    review[i].nearest[kBlock] = blocks(tool, holds[i]);
    set_reach(sample.arms[i], i, review[i]);
  }
  const Nearest met = tools();
  review[0].nearest[kOther] = met;
  review[1].nearest[kOther] = {met.distance_m, static_cast<Part>(met.index), static_cast<std::uint8_t>(met.part)};
  for (std::size_t i = 0; i < 2; ++i) tools_[i].last = review[i].nearest;
  started_ = true;
  return review;
}

Separation separation_at(const Sample& sample, std::size_t arm, Obstacle obstacle, const Nearest& nearest) {
  const RoundedBox shape = shape_of(sample, arm)[static_cast<std::size_t>(nearest.part)];
  switch (obstacle) {
    case Obstacle::kPeg:
      return separation(shape, peg_shape(nearest.index));
    case Obstacle::kBlock: {
      spatial::Pose X_WK = sample.blocks[nearest.index].pose();
      X_WK.q.normalize();
      return apart_from(shape, block_shape(X_WK));
    }
    case Obstacle::kOtherTool:
      return separation(shape, shape_of(sample, 1 - arm)[nearest.index]);
    case Obstacle::kBoard:
      break;
  }
  // Out of the board is up.
  return {static_cast<double>(nearest.distance_m), Vector3d::UnitZ()};
}

}  // namespace trocar::review
