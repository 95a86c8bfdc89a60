/// How far the tools of a demonstration stay from what they could hit, sample by sample.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "engine/demonstration/demonstration.h"
#include "engine/kinematics/reach.h"
#include "engine/review/tool_shape.h"

namespace trocar::review {

/// What a tool could hit. The table counts as board.
enum class Obstacle : std::uint8_t { kBoard, kPeg, kBlock, kOtherTool };
constexpr std::size_t kObstacleCount = 4;

/// Clearances are followed up to here; what is farther is at this distance, in metres.
constexpr double kHorizon_m = 0.02;

/// The least distance of a tool from one kind of obstacle.
struct Nearest {
  float distance_m = static_cast<float>(kHorizon_m);  ///< Below 0: how deep they are in each other.
  Part part = Part::kShaft;                           ///< Of the tool; meaningless at the horizon.
  std::uint8_t index = 0;                             ///< Of the peg (0 … 11) or block, or the other tool's `Part`.
};

/// One tool in one sample.
struct ToolReview {
  std::array<Nearest, kObstacleCount> nearest;  ///< By `Obstacle`.
  kinematics::Excess excess;                    ///< Of the joints that its setpoint asks for.
  bool reachable = true;                        ///< False: no joints at all lead to its setpoint.

  double least_m() const;
};
using SampleReview = std::array<ToolReview, 2>;  ///< Left, right.

/// The reviews of all gated samples, in their order.
class ClearanceCurve {
 public:
  std::size_t size() const { return size_; }
  const SampleReview& operator[](std::size_t i) const;

 private:
  friend class ClearanceMaker;
  using Chunk = std::vector<SampleReview>;
  std::vector<std::shared_ptr<const Chunk>> chunks_;
  std::vector<std::size_t> starts_;
  std::size_t size_ = 0;
};

/// Works the curve out, and remembers it by what the samples hold and not by when they are: what an edit did not touch,
/// or only moved in time, is not worked out again.
///
/// The tools are where they were measured, their shapes those of the simulation. Left out: the block that is carried,
/// where the jaws touch it as they must, and while an arm holds it; blocks whose place is not known (exactly at W's
/// origin, as in imports); samples that are not finite. Threads: one at a time.
class ClearanceMaker {
 public:
  ClearanceCurve make(const demonstration::Demonstration& document);
  /// Samples that the last call worked out; the others it remembered.
  std::size_t worked_out() const { return worked_out_; }

 private:
  std::unordered_map<std::uint64_t, std::shared_ptr<const ClearanceCurve::Chunk>> known_;
  std::size_t worked_out_ = 0;
};

}  // namespace trocar::review
