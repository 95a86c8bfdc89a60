/// How far the tools of a demonstration stay from what they could hit, sample by sample.
#pragma once

#include <array>
#include <cstdint>
#include <list>
#include <memory>
#include <mutex>
#include <unordered_map>
#include <utility>
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

/// The reviews of a run of samples, in a fraction of their room: what is at the horizon or within reach all along, as
/// most is, is not kept for each sample. Immutable once made.
class ClearanceChunk {
 public:
  explicit ClearanceChunk(const std::vector<SampleReview>& reviews);

  std::size_t size() const { return size_; }
  SampleReview operator[](std::size_t i) const;
  Nearest nearest(std::size_t i, std::size_t arm, std::size_t kind) const;
  /// Of either tool, over all samples.
  double least_m() const { return least_m_; }
  /// Of one tool and one kind of obstacle.
  double least_m(std::size_t arm, std::size_t kind) const { return columns_[arm][kind].least_m; }
  /// True if all setpoints of an arm are within reach and no joint beyond its limit.
  bool within_reach(std::size_t arm) const { return reach_[arm].empty(); }
  std::size_t bytes() const;

 private:
  struct Which {
    Part part = Part::kShaft;
    std::uint8_t index = 0;
    bool operator==(const Which&) const = default;
  };
  /// Of one tool and one kind of obstacle; without distances all are at the horizon.
  struct Column {
    std::vector<float> distance_m;
    std::vector<Which> which;  ///< One, if it is the same all along.
    double least_m = kHorizon_m;
  };
  struct Reach {
    kinematics::Excess excess;
    bool reachable = true;
  };

  std::size_t size_ = 0;
  double least_m_ = kHorizon_m;
  std::array<std::array<Column, kObstacleCount>, 2> columns_;
  std::array<std::vector<Reach>, 2> reach_;  ///< Empty: all within reach.
};

/// The reviews of all gated samples, in their order.
class ClearanceCurve {
 public:
  std::size_t size() const { return size_; }
  SampleReview operator[](std::size_t i) const;
  /// The least clearance of either tool; `kHorizon_m` of no samples.
  Nearest nearest(std::size_t i, std::size_t arm, std::size_t kind) const;
  double least_m() const;
  const std::vector<std::shared_ptr<const ClearanceChunk>>& chunks() const { return chunks_; }
  /// Indices of the samples in which a tool is nearer than `below_m` to a kind of obstacle; quick where few are.
  std::vector<std::size_t> nearer_than(double below_m, std::size_t arm, std::size_t kind) const;
  /// Of those in which an arm's setpoint may be beyond its reach.
  std::vector<std::size_t> perhaps_beyond_reach(std::size_t arm) const;

 private:
  friend class ClearanceMaker;
  std::size_t chunk_of(std::size_t i) const;

  std::vector<std::shared_ptr<const ClearanceChunk>> chunks_;
  std::vector<std::size_t> starts_;
  std::size_t size_ = 0;
};

/// What chunks may take together, beyond those that a curve still holds: two hours of both tools at 200 Hz.
constexpr std::size_t kClearanceBudget_bytes = std::size_t{64} << 20U;

/// Chunks by what they are of, for all who ask: what the Problems work out, curves and library find. What was used
/// longest ago goes first when there is more than the budget; it is still found while a curve holds it.
/// Threads: any; a lock is held while a chunk is looked up, never while one is worked out.
class ClearanceStore {
 public:
  explicit ClearanceStore(std::size_t budget_bytes = kClearanceBudget_bytes) : budget_bytes_(budget_bytes) {}

  /// Null if it is not there.
  std::shared_ptr<const ClearanceChunk> find(std::uint64_t key);
  void keep(std::uint64_t key, const std::shared_ptr<const ClearanceChunk>& chunk);
  /// Of the chunks within the budget.
  std::size_t count() const;
  std::size_t bytes() const;

 private:
  struct Kept {
    std::uint64_t key = 0;
    std::shared_ptr<const ClearanceChunk> chunk;
  };
  void add(std::uint64_t key, std::shared_ptr<const ClearanceChunk> chunk);

  const std::size_t budget_bytes_;
  mutable std::mutex mutex_;
  std::list<Kept> kept_;  ///< The one that was used last comes first.
  std::unordered_map<std::uint64_t, std::list<Kept>::iterator> places_;
  std::unordered_map<std::uint64_t, std::weak_ptr<const ClearanceChunk>> let_go_;  ///< Those that a curve may hold.
  std::size_t swept_at_ = 1024;
  std::size_t bytes_ = 0;
};

/// Works the curve out, and remembers it by what the samples hold and not by when they are: what an edit did not touch,
/// or only moved in time, is not worked out again.
///
/// The tools are where they were measured, their shapes those of the simulation. Left out: the block that is carried,
/// where the jaws touch it as they must, and while an arm holds it; blocks whose place is not known (exactly at W's
/// origin, as in imports); samples that are not finite. Threads: one at a time.
class ClearanceMaker {
 public:
  explicit ClearanceMaker(std::shared_ptr<ClearanceStore> store = std::make_shared<ClearanceStore>())
      : store_(std::move(store)) {}

  ClearanceCurve make(const demonstration::Demonstration& document);
  /// Samples that the last call worked out; the others it remembered.
  std::size_t worked_out() const { return worked_out_; }

 private:
  std::shared_ptr<ClearanceStore> store_;
  std::size_t worked_out_ = 0;
};

}  // namespace trocar::review
