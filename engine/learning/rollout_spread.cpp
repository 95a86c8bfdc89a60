#include "engine/learning/rollout_spread.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace trocar::learning {
namespace {

using spatial::CellIndex;

/// Of sorted values, the one that a share of them does not exceed.
double quantile(const std::vector<double>& sorted, double share) {
  const double at = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(at);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (at - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

/// How often each squared distance between two cells occurs, in cells²: whole numbers, of which there are few.
class DistanceCounts {
 public:
  void add(std::int32_t squared) {
    const auto place = static_cast<std::size_t>(squared);
    if (counts_.size() <= place) counts_.resize(place + 1, 0);
    ++counts_[place];
    ++all_;
  }
  std::int64_t all() const { return all_; }
  /// As `quantile` of all distances, in cells.
  double quantile(double share) const {
    const double at = share * static_cast<double>(all_ - 1);
    const auto below = static_cast<std::int64_t>(at);
    const double low = ranked(below);
    return low + (at - static_cast<double>(below)) * (ranked(std::min(below + 1, all_ - 1)) - low);
  }

 private:
  double ranked(std::int64_t rank) const {
    std::size_t place = 0;
    for (std::int64_t before = counts_[0]; before <= rank; before += counts_[place]) ++place;
    return std::sqrt(static_cast<double>(place));
  }

  std::vector<std::int32_t> counts_;
  std::int64_t all_ = 0;
};

/// Takes rollouts one by one and keeps numbers of them alone.
class Gatherer {
 public:
  Gatherer(const Model& model, std::span<const double> clearance_m)
      : model_(model),
        clearance_m_(clearance_m),
        deviation_(static_cast<std::size_t>(model.grid.cell_count()), kUnset) {}

  void add(const Rollout& rollout) {
    ++starts_;
    if (at_step_.size() < rollout.cells.size()) at_step_.resize(rollout.cells.size());
    for (std::size_t step = 0; step < rollout.cells.size(); ++step) {
      at_step_[step].add(deviation(rollout.cells[step]));
    }
    for (const RolloutMeasure measure : spread_measures()) {
      const double value = learning::measure(rollout, measure, model_.grid, clearance_m_);
      // It never departs: there is no step to be more or less.
      if (measure == RolloutMeasure::kDivergence && value < 0.0) continue;
      if (!std::isfinite(value)) continue;
      values_[static_cast<std::size_t>(measure)][static_cast<std::size_t>(rollout.end)].push_back(value);
    }
  }

  RolloutSpread finish() {
    RolloutSpread spread;
    spread.starts = starts_;
    spread.band = band();
    for (std::size_t m = 0; m < values_.size(); ++m) {
      for (std::size_t e = 0; e < kRolloutEnds; ++e) {
        std::vector<double>& values = values_[m][e];
        MeasureSpread& of = spread.by_end[m][e];
        const std::size_t points = std::min(values.size(), kMostPoints);
        for (std::size_t i = 0; i < points; ++i) of.some.push_back(values[i * values.size() / points]);
        of.spread = spread_of(std::move(values));
      }
    }
    return spread;
  }

 private:
  static constexpr std::int32_t kUnset = -1;

  /// Squared, in cells: from the nearest of the expert's.
  std::int32_t deviation(CellIndex cell) {
    std::int32_t& known = deviation_[static_cast<std::size_t>(cell.value)];
    if (known != kUnset) return known;
    const spatial::CellCoordinates here = model_.grid.coordinates(cell);
    known = std::numeric_limits<std::int32_t>::max();
    for (const CellIndex expert : model_.experts.front()) {
      const spatial::CellCoordinates c = model_.grid.coordinates(expert);
      const int x = c.x - here.x;
      const int y = c.y - here.y;
      const int z = c.z - here.z;
      known = std::min(known, x * x + y * y + z * z);
    }
    return known;
  }

  DeviationBand band() const {
    DeviationBand band;
    const double cell_m = model_.grid.cell_m;
    for (const DistanceCounts& here : at_step_) {
      if (here.all() < kLeastInBand) break;
      band.low.push_back(cell_m * here.quantile(0.05));
      band.lower.push_back(cell_m * here.quantile(0.25));
      band.median.push_back(cell_m * here.quantile(0.5));
      band.upper.push_back(cell_m * here.quantile(0.75));
      band.high.push_back(cell_m * here.quantile(0.95));
      band.count.push_back(static_cast<int>(here.all()));
    }
    return band;
  }

  const Model& model_;
  std::span<const double> clearance_m_;
  std::size_t starts_ = 0;
  std::vector<DistanceCounts> at_step_;  ///< Of those that go on so far.
  std::vector<std::int32_t> deviation_;  ///< By CellIndex.
  std::array<std::array<std::vector<double>, kRolloutEnds>, kRolloutMeasures> values_;
};

/// A name may hold a comma; names are the user's.
std::string csv_name(const std::string& name) {
  if (name.find_first_of(",\"\n") == std::string::npos) return name;
  std::string quoted = "\"";
  for (const char c : name) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

}  // namespace

std::string band_csv(const DeviationBand& band) {
  std::string csv = "step,n,share,p05_mm,p25_mm,median_mm,p75_mm,p95_mm\n";
  for (std::size_t step = 0; step < band.count.size(); ++step) {
    csv += fmt::format("{},{},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g}\n", step, band.count[step],
                       static_cast<double>(band.count[step]) / static_cast<double>(band.count.front()),
                       1e3 * band.low[step], 1e3 * band.lower[step], 1e3 * band.median[step], 1e3 * band.upper[step],
                       1e3 * band.high[step]);
  }
  return csv;
}

Spread spread_of(std::vector<double> values) {
  std::erase_if(values, [](double value) { return !std::isfinite(value); });
  if (values.empty()) return {};
  std::sort(values.begin(), values.end());
  return {static_cast<int>(values.size()), values.front(),         quantile(values, 0.25),
          quantile(values, 0.5),           quantile(values, 0.75), values.back()};
}

bool has_spread(RolloutMeasure measure) {
  return measure != RolloutMeasure::kStart && measure != RolloutMeasure::kEnd &&
         measure != RolloutMeasure::kLastMoves && measure != RolloutMeasure::kFromAbove;
}

std::vector<RolloutMeasure> spread_measures() {
  std::vector<RolloutMeasure> measures;
  for (int i = 0; i < kRolloutMeasures; ++i) {
    if (has_spread(static_cast<RolloutMeasure>(i))) measures.push_back(static_cast<RolloutMeasure>(i));
  }
  return measures;
}

std::vector<CellIndex> evenly(const std::vector<CellIndex>& starts, std::size_t count) {
  if (starts.size() <= count) return starts;
  std::vector<CellIndex> some(count);
  for (std::size_t i = 0; i < count; ++i) some[i] = starts[i * starts.size() / count];
  return some;
}

Result<RolloutSpread> spread_from(const Model& model, const std::vector<std::uint8_t>& policy,
                                  const std::vector<CellIndex>& starts, std::span<const double> clearance_m,
                                  Progress& progress) {
  Gatherer gatherer(model, clearance_m);
  for (std::size_t i = 0; i < starts.size(); ++i) {
    if (progress.cancelled()) return fail(ErrorCode::kCancelled, "stopped before all rollouts were followed");
    progress.set(static_cast<double>(i) / static_cast<double>(starts.size()));
    gatherer.add(rollout(model, policy, starts[i]));
  }
  return gatherer.finish();
}

RolloutSpread spread_of_rollouts(const Model& model, const std::vector<Rollout>& rollouts,
                                 std::span<const double> clearance_m) {
  Gatherer gatherer(model, clearance_m);
  for (const Rollout& one : rollouts) gatherer.add(one);
  return gatherer.finish();
}

std::string spread_csv_header() {
  return "model,measure,unit,end,n,least,p25,median,p75,most\n";
}

std::string spread_csv_rows(const std::string& name, const RolloutSpread& spread,
                            const std::vector<RolloutMeasure>& measures) {
  std::string csv;
  for (const RolloutMeasure measure : measures) {
    const MeasureWords& words = words_of(measure);
    for (std::size_t e = 0; e < kRolloutEnds; ++e) {
      const auto end = static_cast<RolloutEnd>(e);
      const Spread& of = spread.of(measure, end).spread;
      if (of.count == 0) continue;
      csv += fmt::format("{},{},{},{},{},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g}\n", csv_name(name), words.word, words.unit,
                         to_string(end), of.count, words.scale * of.least, words.scale * of.low,
                         words.scale * of.median, words.scale * of.high, words.scale * of.most);
    }
  }
  return csv;
}

}  // namespace trocar::learning
