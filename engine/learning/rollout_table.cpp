#include "engine/learning/rollout_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "engine/statistics/proportion.h"

namespace trocar::learning {
namespace {

using spatial::Action;
using spatial::CellIndex;

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t kLastOnes = 3;

/// The action that leads from one cell to the next.
Action action_between(const spatial::Grid& grid, CellIndex from, CellIndex to) {
  for (int a = 0; a < spatial::kActionCount; ++a) {
    if (grid.neighbour(from, static_cast<Action>(a)) == to) return static_cast<Action>(a);
  }
  return Action::kPlusX;  // Not reached: cells of a rollout are neighbours.
}

std::vector<Action> last_actions(const spatial::Grid& grid, const CellSequence& cells) {
  std::vector<Action> actions;
  const std::size_t first = cells.size() > kLastOnes ? cells.size() - kLastOnes : 1;
  for (std::size_t i = first; i < cells.size(); ++i) actions.push_back(action_between(grid, cells[i - 1], cells[i]));
  return actions;
}

/// Nothing for what is not known.
std::string cell_text(double value) {
  return std::isfinite(value) ? fmt::format("{:.6g}", value) : "";
}

std::string monte_carlo_cells(const MonteCarlo& result, std::size_t i) {
  if (i >= static_cast<std::size_t>(result.finished)) return ",,,,,,";
  const int arrived = result.arrived[i];
  const statistics::Interval interval = statistics::wilson_interval(arrived, result.runs());
  const double share = static_cast<double>(arrived) / result.runs();
  const std::string steps = arrived == 0 ? "" : fmt::format("{:.6g}", static_cast<double>(result.steps[i]) / arrived);
  return fmt::format(",{},{},{:.6g},{:.6g},{:.6g},{}", result.runs(), arrived, share, interval.low, interval.high,
                     steps);
}

std::string row_of(const Model& model, const Rollout& r, std::span<const double> clearance_m) {
  const spatial::CellCoordinates c = model.grid.coordinates(r.start);
  return fmt::format("{},{},{},{},{},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:d},{:.9g},{},{},{},{}", c.x,
                     c.y, c.z, to_string(r.end), r.cells.size() - 1, 1e3 * r.length_m, r.straightness,
                     1e3 * r.max_deviation_m, 1e3 * r.mean_deviation_m, 1e3 * r.frechet_m, 1e3 * r.hausdorff_m,
                     1e3 * r.warped_m, r.from_above, r.reward_sum, r.divergence_step, r.outside_steps,
                     last_moves(model.grid, r.cells), cell_text(1e3 * least_clearance_m(r, clearance_m)));
}

}  // namespace

std::string last_moves(const spatial::Grid& grid, const CellSequence& cells) {
  std::string words;
  for (const Action action : last_actions(grid, cells)) {
    if (!words.empty()) words += ' ';
    words += spatial::to_string(action);
  }
  return words;
}

double least_clearance_m(const Rollout& rollout, std::span<const double> by_cell) {
  if (by_cell.empty()) return kUnknown;
  double least_m = std::numeric_limits<double>::infinity();
  for (const CellIndex cell : rollout.cells) least_m = std::min(least_m, by_cell[static_cast<std::size_t>(cell.value)]);
  return least_m;
}

double measure(const Rollout& rollout, RolloutMeasure measure, const spatial::Grid& grid,
               std::span<const double> clearance_m) {
  switch (measure) {
    case RolloutMeasure::kStart:
      return rollout.start.value;
    case RolloutMeasure::kEnd:
      return static_cast<double>(rollout.end);
    case RolloutMeasure::kSteps:
      return static_cast<double>(rollout.cells.size() - 1);
    case RolloutMeasure::kLength:
      return rollout.length_m;
    case RolloutMeasure::kStraightness:
      return rollout.straightness;
    case RolloutMeasure::kMaxDeviation:
      return rollout.max_deviation_m;
    case RolloutMeasure::kMeanDeviation:
      return rollout.mean_deviation_m;
    case RolloutMeasure::kFrechet:
      return rollout.frechet_m;
    case RolloutMeasure::kHausdorff:
      return rollout.hausdorff_m;
    case RolloutMeasure::kWarped:
      return rollout.warped_m;
    case RolloutMeasure::kLastMoves: {
      const std::vector<Action> last = last_actions(grid, rollout.cells);
      return static_cast<double>(std::count(last.begin(), last.end(), Action::kMinusZ));
    }
    case RolloutMeasure::kFromAbove:
      return rollout.from_above ? 1.0 : 0.0;
    case RolloutMeasure::kReward:
      return rollout.reward_sum;
    case RolloutMeasure::kDivergence:
      return rollout.divergence_step;
    case RolloutMeasure::kOutside:
      return rollout.outside_steps;
    case RolloutMeasure::kClearance:
      return least_clearance_m(rollout, clearance_m);
  }
  return kUnknown;
}

bool lies_in(const Rollout& rollout, const std::vector<RolloutRange>& ranges, const spatial::Grid& grid,
             std::span<const double> clearance_m) {
  return std::all_of(ranges.begin(), ranges.end(), [&](const RolloutRange& range) {
    const double value = measure(rollout, range.measure, grid, clearance_m);
    return value >= range.low && value <= range.high;
  });
}

std::vector<std::size_t> sorted_by(const std::vector<Rollout>& rollouts, RolloutMeasure by, bool descending,
                                   const spatial::Grid& grid, std::span<const double> clearance_m) {
  std::vector<double> values;
  values.reserve(rollouts.size());
  for (const Rollout& rollout : rollouts) {
    const double value = measure(rollout, by, grid, clearance_m);
    values.push_back(std::isnan(value) ? std::numeric_limits<double>::infinity() : descending ? -value : value);
  }
  std::vector<std::size_t> order(rollouts.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&values](std::size_t a, std::size_t b) { return values[a] < values[b]; });
  return order;
}

Result<std::string> rollout_csv(const Model& model, const std::vector<std::uint8_t>& policy,
                                const std::vector<CellIndex>& starts, const RolloutTableOptions& options,
                                Progress& progress) {
  std::string csv =
      "i,j,k,end,steps,length_mm,straightness,max_deviation_mm,mean_deviation_mm,frechet_mm,hausdorff_mm,dtw_mm,"
      "from_above,reward_sum,divergence_step,outside_steps,last_moves,clearance_mm";
  if (options.monte_carlo != nullptr) csv += ",runs,runs_arrived,share,low,high,mean_steps";
  csv += '\n';
  for (std::size_t i = 0; i < starts.size(); ++i) {
    if (progress.cancelled()) return fail(ErrorCode::kCancelled, "stopped before all rollouts were written");
    progress.set(static_cast<double>(i) / static_cast<double>(starts.size()));
    csv += row_of(model, rollout(model, policy, starts[i]), options.clearance_m);
    if (options.monte_carlo != nullptr) csv += monte_carlo_cells(*options.monte_carlo, i);
    csv += '\n';
  }
  return csv;
}

std::vector<int> arrivals_by_step(const Basin& basin, const std::vector<CellIndex>& starts) {
  std::vector<int> by_step(1, 0);
  for (const CellIndex start : starts) {
    const auto cell = static_cast<std::size_t>(start.value);
    if (basin.end[cell] != RolloutEnd::kArrives) continue;
    const std::size_t steps = basin.steps[cell];
    if (steps >= by_step.size()) by_step.resize(steps + 1, 0);
    ++by_step[steps];
  }
  std::partial_sum(by_step.begin(), by_step.end(), by_step.begin());
  return by_step;
}

std::vector<Eigen::Vector3d> way_until(const Rollout& rollout, const spatial::Grid& grid, double steps) {
  const std::size_t last = rollout.cells.size() - 1;
  const double within = std::clamp(steps, 0.0, static_cast<double>(last));
  const auto whole = static_cast<std::size_t>(within);
  std::vector<Eigen::Vector3d> points;
  for (std::size_t i = 0; i <= whole; ++i) points.push_back(grid.centre(rollout.cells[i]));
  const double part = within - static_cast<double>(whole);
  if (part > 0.0) points.push_back(points.back() + part * (grid.centre(rollout.cells[whole + 1]) - points.back()));
  return points;
}

}  // namespace trocar::learning
