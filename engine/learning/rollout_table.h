/// Rollouts as a table: what is measured of each, for sorting, and the rows that window and command line write alike.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/progress.h"
#include "engine/core/result.h"
#include "engine/learning/monte_carlo.h"
#include "engine/learning/rollout.h"

namespace trocar::learning {

enum class RolloutMeasure : std::uint8_t {
  kStart,
  kEnd,
  kSteps,
  kLength,
  kStraightness,
  kMaxDeviation,
  kMeanDeviation,
  kFrechet,
  kHausdorff,
  kWarped,
  kLastMoves,
  kFromAbove,
  kReward,
  kDivergence,
  kOutside,
  kClearance,
};
constexpr int kRolloutMeasures = 16;

/// What a measure is called, and in what it is written: its SI value times `scale` is in `unit`.
struct MeasureWords {
  std::string_view word;   ///< "max_deviation": on the command line.
  std::string_view name;   ///< "Worst": over a column.
  std::string_view title;  ///< "Worst deviation"
  std::string_view unit;   ///< "mm"; "" for a number.
  double scale = 1.0;
};
const MeasureWords& words_of(RolloutMeasure measure);
/// By its word. Errors: kInvalidArgument with the words that there are.
Result<RolloutMeasure> rollout_measure_from(std::string_view word);
/// The value in its unit, and its class in words: "12.5 mm", "loops", "never", "unknown" for NaN; a start by its flat
/// number.
std::string measure_text(RolloutMeasure measure, double value);

/// The last three moves in their order, "-z -z -z"; fewer for a shorter rollout, "" where it never moved.
std::string last_moves(const spatial::Grid& grid, const CellSequence& cells);

/// The least of `by_cell` (metres, by CellIndex) on the way; NaN if that is empty.
double least_clearance_m(const Rollout& rollout, std::span<const double> by_cell);

/// What rows are sorted by: SI units, classes by their number, starts by CellIndex. Of the last moves: how many of them
/// were −z. `clearance_m` is by CellIndex and may be empty: NaN then.
double measure(const Rollout& rollout, RolloutMeasure measure, const spatial::Grid& grid,
               std::span<const double> clearance_m);

/// The places of `rollouts`, sorted by one measure; equal ones by their place, unknown ones last.
std::vector<std::size_t> sorted_by(const std::vector<Rollout>& rollouts, RolloutMeasure by, bool descending,
                                   const spatial::Grid& grid, std::span<const double> clearance_m);

/// What a rollout must have to be kept: a measure from `low` to `high`, both included.
struct RolloutRange {
  RolloutMeasure measure = RolloutMeasure::kSteps;
  double low = 0.0;  ///< As `measure`.
  double high = 0.0;
  bool operator==(const RolloutRange&) const = default;
};
/// Whether it lies in all of them; what is not known lies in none.
bool lies_in(const Rollout& rollout, const std::vector<RolloutRange>& ranges, const spatial::Grid& grid,
             std::span<const double> clearance_m);

struct RolloutTableOptions {
  std::span<const double> clearance_m;      ///< By CellIndex; empty: the column stays empty.
  const MonteCarlo* monte_carlo = nullptr;  ///< Of the same starts in the same order: six columns more.
};
/// A header and one row for each start, in their order: lengths in millimetres; of the random rollouts how many were
/// run and arrived, their share and its 95 % interval (Wilson), empty for starts that were not finished. Errors:
/// kCancelled.
/// Precondition: `monte_carlo`, if any, has as many starts.
Result<std::string> rollout_csv(const Model& model, const std::vector<std::uint8_t>& policy,
                                const std::vector<spatial::CellIndex>& starts, const RolloutTableOptions& options,
                                Progress& progress);

/// How many of the starts have arrived within 0, 1, 2 … steps; up to the slowest that arrives, so that the last is how
/// many arrive at all. One 0 where none does.
std::vector<int> arrivals_by_step(const Basin& basin, const std::vector<spatial::CellIndex>& starts);

/// The way of a rollout up to so many steps, fractions too, from its start; W, metres; at least one point.
std::vector<Eigen::Vector3d> way_until(const Rollout& rollout, const spatial::Grid& grid, double steps);

}  // namespace trocar::learning
