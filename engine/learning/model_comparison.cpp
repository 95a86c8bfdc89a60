#include "engine/learning/model_comparison.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "engine/core/check.h"

namespace trocar::learning {
namespace {

constexpr double kNotKnown = std::numeric_limits<double>::quiet_NaN();

struct Mean {
  double sum = 0.0;
  int count = 0;

  void add(double value) {
    if (!std::isfinite(value)) return;
    sum += value;
    ++count;
  }
  double value() const { return count == 0 ? kNotKnown : sum / count; }
};

ModelMeasures measures_of(const Model& model, const Basin& basin, const std::vector<spatial::CellIndex>& all,
                          const std::array<std::vector<spatial::CellIndex>, 5>& around) {
  ModelMeasures measures;
  measures.exploration = exploration(model);
  const Field reward = field(model, Layer::kReward);
  const Field margin = field(model, Layer::kMargin);
  Mean mean_reward;
  Mean mean_margin;
  for (const double value : reward.values) mean_reward.add(value);
  for (const double value : margin.values) mean_margin.add(value);
  measures.least_reward = mean_reward.count == 0 ? kNotKnown : reward.low();
  measures.mean_reward = mean_reward.value();
  measures.mean_margin = mean_margin.value();
  measures.mismatch = model.curve.empty() ? kNotKnown : model.curve.back();
  measures.all = summarise(basin, all);
  for (std::size_t k = 0; k < around.size(); ++k) measures.around[k] = summarise(basin, around[k]);
  return measures;
}

Field classes(const spatial::Grid& grid, std::string title, std::vector<std::string> names) {
  Field field;
  field.grid = grid;
  field.values.assign(static_cast<std::size_t>(grid.cell_count()), kNotKnown);
  field.title = std::move(title);
  field.categorical = true;
  field.categories = std::move(names);
  return field;
}

}  // namespace

Field difference(const Field& a, const Field& b) {
  TROCAR_CHECK(a.grid == b.grid && a.layer == b.layer);
  Field result;
  if (a.categorical) {
    result = classes(a.grid, a.title + ", same or not", {"same", "differs"});
  } else {
    result.grid = a.grid;
    result.values.assign(a.values.size(), kNotKnown);
    result.title = a.title + ", B \u2212 A";
    result.unit = a.unit;
  }
  result.layer = a.layer;
  for (std::size_t s = 0; s < result.values.size(); ++s) {
    if (!std::isfinite(a.values[s]) || !std::isfinite(b.values[s])) continue;
    const double change = b.values[s] - a.values[s];
    result.values[s] = !a.categorical ? change : change == 0.0 ? 0.0 : 1.0;
  }
  return result;
}

Field policy_change(const spatial::Grid& grid, const std::vector<std::uint8_t>& policy_a,
                    const std::vector<std::uint8_t>& policy_b) {
  Field result =
      classes(grid, "Change of the policy", {"same action", "another action", "only A has one", "only B has one"});
  result.layer = Layer::kPolicy;
  for (std::size_t s = 0; s < result.values.size(); ++s) {
    const bool in_a = policy_a[s] != kNoAction;
    const bool in_b = policy_b[s] != kNoAction;
    if (!in_a && !in_b) continue;
    result.values[s] = in_a && in_b ? (policy_a[s] == policy_b[s] ? 0.0 : 1.0) : in_a ? 2.0 : 3.0;
  }
  return result;
}

Field paired_outcomes(const spatial::Grid& grid, const Basin& a, const Basin& b) {
  Field result =
      classes(grid, "Outcome of a start with A and B", {"both arrive", "only A arrives", "only B arrives", "neither"});
  result.layer = Layer::kBasin;
  for (std::size_t s = 0; s < result.values.size(); ++s) {
    const bool in_a = a.end[s] == RolloutEnd::kArrives;
    const bool in_b = b.end[s] == RolloutEnd::kArrives;
    result.values[s] = in_a && in_b ? 0.0 : in_a ? 1.0 : in_b ? 2.0 : 3.0;
  }
  return result;
}

ModelComparison compare_models(const Model& a, const Model& b) {
  TROCAR_CHECK(a.grid == b.grid);
  const std::vector<std::uint8_t> policy_a = greedy_policy(a);
  const std::vector<std::uint8_t> policy_b = greedy_policy(b);
  ModelComparison result;
  result.basin_a = basin(a, policy_a);
  result.basin_b = basin(b, policy_b);
  std::vector<spatial::CellIndex> all(policy_a.size());
  for (std::size_t s = 0; s < all.size(); ++s) all[s].value = static_cast<std::int32_t>(s);
  std::array<std::vector<spatial::CellIndex>, 5> around;
  for (std::size_t k = 0; k < around.size(); ++k) around[k] = starts_around(a, static_cast<int>(k) + 1);
  result.a = measures_of(a, result.basin_a, all, around);
  result.b = measures_of(b, result.basin_b, all, around);
  result.policy_change = policy_change(a.grid, policy_a, policy_b);
  for (const double value : result.policy_change.values) {
    if (!std::isfinite(value)) continue;
    result.policy_compared += value < 2.0 ? 1 : 0;
    result.policy_differs += value == 1.0 ? 1 : 0;
    result.policy_changed += value > 0.0 ? 1 : 0;
  }
  result.paired = compare(result.basin_a, result.basin_b, all);
  return result;
}

}  // namespace trocar::learning
