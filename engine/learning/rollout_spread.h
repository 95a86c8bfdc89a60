/// What the rollouts of many starts come to together, without keeping them: where each measure lies, by how they end,
/// and how far they are from the expert, step by step.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "engine/core/progress.h"
#include "engine/core/result.h"
#include "engine/learning/rollout_table.h"

namespace trocar::learning {

/// How far rollouts are from the expert's cells, step by step, metres: the middle one, and where half and 90 % lie, of
/// those that still go on, `count` of them; up to the last step that `kLeastInBand` of them reach.
struct DeviationBand {
  std::vector<double> low;    ///< 5 %
  std::vector<double> lower;  ///< 25 %
  std::vector<double> median;
  std::vector<double> upper;  ///< 75 %
  std::vector<double> high;   ///< 95 %
  std::vector<int> count;
};
constexpr int kLeastInBand = 5;
/// A header and one row for each step: how many still go on, and their share of all; millimetres.
std::string band_csv(const DeviationBand& band);

/// Where values lie, between whole ranks by proportion.
struct Spread {
  int count = 0;  ///< 0: there is none, and what follows is 0.
  double least = 0.0;
  double low = 0.0;  ///< A quarter lies below.
  double median = 0.0;
  double high = 0.0;  ///< A quarter lies above.
  double most = 0.0;
};
/// Of those that are finite.
Spread spread_of(std::vector<double> values);

/// Whether a measure is a number of which more or less can be said: no start, no class.
bool has_spread(RolloutMeasure measure);

/// Of one measure, SI.
struct MeasureSpread {
  Spread spread;
  std::vector<double> some;  ///< Of the values, evenly through the starts: to be drawn as points.
};
constexpr std::size_t kMostPoints = 120;
constexpr std::size_t kRolloutEnds = 4;

struct RolloutSpread {
  std::size_t starts = 0;
  DeviationBand band;
  std::array<std::array<MeasureSpread, kRolloutEnds>, kRolloutMeasures> by_end;  ///< Of those that `has_spread`.

  const MeasureSpread& of(RolloutMeasure measure, RolloutEnd end) const {
    return by_end[static_cast<std::size_t>(measure)][static_cast<std::size_t>(end)];
  }
};

/// `count` of the starts, evenly through their list; all, if there are no more.
std::vector<spatial::CellIndex> evenly(const std::vector<spatial::CellIndex>& starts, std::size_t count);

/// Follows the policy from the starts. `clearance_m` is by CellIndex and may be empty. Errors: kCancelled.
Result<RolloutSpread> spread_from(const Model& model, const std::vector<std::uint8_t>& policy,
                                  const std::vector<spatial::CellIndex>& starts, std::span<const double> clearance_m,
                                  Progress& progress);
/// Of rollouts that are there.
RolloutSpread spread_of_rollouts(const Model& model, const std::vector<Rollout>& rollouts,
                                 std::span<const double> clearance_m);

/// A header and a row for each measure and end that there is, in the unit of the measure; `name` is the model's.
std::string spread_csv_header();
std::string spread_csv_rows(const std::string& name, const RolloutSpread& spread,
                            const std::vector<RolloutMeasure>& measures);
/// Those that `has_spread`, in their order.
std::vector<RolloutMeasure> spread_measures();

}  // namespace trocar::learning
