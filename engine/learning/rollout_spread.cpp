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
template <typename Value>
double quantile(const std::vector<Value>& sorted, double share) {
  const double at = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(at);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  const auto low = static_cast<double>(sorted[below]);
  return low + (at - static_cast<double>(below)) * (static_cast<double>(sorted[above]) - low);
}

/// Takes rollouts one by one and keeps numbers of them alone.
class Gatherer {
 public:
  Gatherer(const Model& model, std::span<const double> clearance_m)
      : model_(model),
        clearance_m_(clearance_m),
        deviation_m_(static_cast<std::size_t>(model.grid.cell_count()), kUnset) {}

  void add(const Rollout& rollout) {
    ++followed_;
    if (at_step_.size() < rollout.cells.size()) at_step_.resize(rollout.cells.size());
    for (std::size_t step = 0; step < rollout.cells.size(); ++step) {
      at_step_[step].push_back(rollout.cells[step]);
    }
    for (const RolloutMeasure measure : spread_measures()) {
      const double value = learning::measure(rollout, measure, model_.grid, clearance_m_);
      // It never departs: there is no step to be more or less.
      if (measure == RolloutMeasure::kDivergence && value < 0.0) continue;
      if (!std::isfinite(value)) continue;
      values_[static_cast<std::size_t>(measure)][static_cast<std::size_t>(rollout.end)].push_back(value);
    }
  }

  RolloutSpread finish(std::size_t starts) {
    RolloutSpread spread;
    spread.starts = starts;
    spread.followed = followed_;
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
  static constexpr double kUnset = -1.0;

  double deviation_m(CellIndex cell) {
    double& known = deviation_m_[static_cast<std::size_t>(cell.value)];
    if (known >= 0.0) return known;
    const Eigen::Vector3d here = model_.grid.centre(cell);
    known = std::numeric_limits<double>::infinity();
    for (const CellIndex expert : model_.experts.front()) {
      known = std::min(known, (model_.grid.centre(expert) - here).norm());
    }
    return known;
  }

  DeviationBand band() {
    DeviationBand band;
    std::vector<double> here;
    for (const std::vector<CellIndex>& cells : at_step_) {
      if (cells.size() < kLeastInBand) break;
      here.clear();
      for (const CellIndex cell : cells) here.push_back(deviation_m(cell));
      std::sort(here.begin(), here.end());
      band.low.push_back(quantile(here, 0.05));
      band.lower.push_back(quantile(here, 0.25));
      band.median.push_back(quantile(here, 0.5));
      band.upper.push_back(quantile(here, 0.75));
      band.high.push_back(quantile(here, 0.95));
      band.count.push_back(static_cast<int>(here.size()));
    }
    return band;
  }

  const Model& model_;
  std::span<const double> clearance_m_;
  std::size_t followed_ = 0;
  std::vector<std::vector<CellIndex>> at_step_;  ///< Of those that go on so far.
  std::vector<double> deviation_m_;              ///< By CellIndex.
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
  const std::vector<CellIndex> followed = evenly(starts, kMostFollowed);
  Gatherer gatherer(model, clearance_m);
  for (std::size_t i = 0; i < followed.size(); ++i) {
    if (progress.cancelled()) return fail(ErrorCode::kCancelled, "stopped before all rollouts were followed");
    progress.set(static_cast<double>(i) / static_cast<double>(followed.size()));
    gatherer.add(rollout(model, policy, followed[i]));
  }
  return gatherer.finish(starts.size());
}

RolloutSpread spread_of_rollouts(const Model& model, const std::vector<Rollout>& rollouts,
                                 std::span<const double> clearance_m) {
  Gatherer gatherer(model, clearance_m);
  for (const Rollout& one : rollouts) gatherer.add(one);
  return gatherer.finish(rollouts.size());
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
