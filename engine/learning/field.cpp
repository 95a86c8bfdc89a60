#include "engine/learning/field.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/core/check.h"
#include "engine/learning/learning_history.h"
#include "engine/learning/policy.h"
#include "engine/learning/rollout.h"

namespace trocar::learning {
namespace {

using spatial::kActionCount;

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

struct LayerText {
  std::string_view name;
  std::string_view title;
};

constexpr std::array<LayerText, 18> kLayers{{{"reward", "Reward θ"},
                                             {"value", "Value V"},
                                             {"q+x", "Q of +x"},
                                             {"q-x", "Q of −x"},
                                             {"q+y", "Q of +y"},
                                             {"q-y", "Q of −y"},
                                             {"q+z", "Q of +z"},
                                             {"q-z", "Q of −z"},
                                             {"margin", "Margin of the best action"},
                                             {"visits", "Visits"},
                                             {"explored", "Explored actions"},
                                             {"safe", "Safe set"},
                                             {"basin", "Outcome of a start"},
                                             {"steps", "Steps to the goal"},
                                             {"policy", "Policy"},
                                             {"expert", "Expert cells"},
                                             {"theta-change", "Change of θ in the last epoch"},
                                             {"obstacles", "Cells that a peg touches"}}};

bool known(const Model& model, std::size_t s) {
  return model.tried[s] != 0 || model.visits[s] != 0 || static_cast<std::int32_t>(s) == model.goal.value;
}

std::vector<double> rewards(const Model& model, const std::vector<double>& expert) {
  std::vector<double> values(model.theta.size(), kUnknown);
  for (std::size_t s = 0; s < values.size(); ++s) {
    if (known(model, s) || expert[s] > 0.0) values[s] = model.theta[s];
  }
  return values;
}

/// Of a method that samples, V is the Q of the best action. Where that one was never tried it is what Q began with: the
/// agent hopes there, and knows nothing.
bool hopes(const Model& model, std::size_t s) {
  if (!is_sampled(model.options.method) || static_cast<std::int32_t>(s) == model.goal.value) return false;
  double untried = -std::numeric_limits<double>::infinity();
  double tried = untried;
  for (std::size_t a = 0; a < kActionCount; ++a) {
    double& best = (model.tried[s] >> a & 1) != 0 ? tried : untried;
    const double q = model.q[s * kActionCount + a];
    if (std::isfinite(q)) best = std::max(best, q);
  }
  return untried > tried && untried == model.value[s];
}

bool value_is_known(const Model& model, std::size_t s) {
  return known(model, s) && std::isfinite(model.value[s]) && !hopes(model, s);
}

std::vector<double> state_values(const Model& model) {
  std::vector<double> values(model.value.size(), kUnknown);
  for (std::size_t s = 0; s < values.size(); ++s) {
    if (value_is_known(model, s)) values[s] = model.value[s];
  }
  return values;
}

std::vector<double> action_values(const Model& model, std::size_t action) {
  std::vector<double> values(model.tried.size(), kUnknown);
  for (std::size_t s = 0; s < values.size(); ++s) {
    const double q = model.q[s * kActionCount + action];
    if ((model.tried[s] >> action & 1) != 0 && std::isfinite(q)) values[s] = q;
  }
  return values;
}

std::vector<double> margins(const Model& model) {
  std::vector<double> values(model.tried.size(), kUnknown);
  const std::vector<std::uint8_t> all_candidates = candidate_moves(model);
  for (std::size_t s = 0; s < values.size(); ++s) {
    const unsigned candidates = all_candidates[s];
    std::array<double, kActionCount> q{};
    std::size_t count = 0;
    for (std::size_t a = 0; a < kActionCount; ++a) {
      if ((candidates >> a & 1U) != 0) q[count++] = model.q[s * kActionCount + a];
    }
    if (count < 2) continue;
    std::partial_sort(q.begin(), q.begin() + 2, q.begin() + static_cast<std::ptrdiff_t>(count), std::greater<>());
    values[s] = q[0] - q[1];
  }
  return values;
}

std::vector<double> visit_counts(const Model& model) {
  if (!knows_visits(model)) return std::vector<double>(model.visits.size(), kUnknown);
  const double unit = model.options.method == Method::kExact ? 1e-3 : 1.0;
  std::vector<double> values(model.visits.size());
  for (std::size_t s = 0; s < values.size(); ++s) values[s] = unit * model.visits[s];
  return values;
}

std::vector<double> explored_classes(const Model& model) {
  constexpr std::uint8_t kAllActions = (1U << kActionCount) - 1;
  if (!is_sampled(model.options.method)) return std::vector<double>(model.tried.size(), kUnknown);
  std::vector<double> values(model.tried.size());
  for (std::size_t s = 0; s < values.size(); ++s) {
    values[s] = model.tried[s] == kAllActions ? 2.0 : (model.tried[s] != 0 ? 1.0 : 0.0);
  }
  values[static_cast<std::size_t>(model.goal.value)] = kUnknown;  // no action is ever taken there
  return values;
}

std::vector<double> expert_cells(const Model& model) {
  std::vector<double> values(model.theta.size(), 0.0);
  for (const CellSequence& cells : model.experts) {
    for (const spatial::CellIndex cell : cells) values[static_cast<std::size_t>(cell.value)] = 1.0;
  }
  return values;
}

std::vector<double> policy_actions(const Model& model) {
  const std::vector<std::uint8_t> policy = greedy_policy(model);
  std::vector<double> values(policy.size(), kUnknown);
  for (std::size_t s = 0; s < values.size(); ++s) {
    if (policy[s] != kNoAction) values[s] = policy[s];
  }
  return values;
}

std::vector<double> outcomes(const Model& model) {
  const Basin all = basin(model, greedy_policy(model));
  std::vector<double> values(all.end.size());
  for (std::size_t s = 0; s < values.size(); ++s) values[s] = static_cast<double>(all.end[s]);
  return values;
}

std::vector<double> steps_to_goal(const Model& model) {
  const Basin all = basin(model, greedy_policy(model));
  std::vector<double> values(all.end.size(), kUnknown);
  for (std::size_t s = 0; s < values.size(); ++s) {
    if (all.end[s] == RolloutEnd::kArrives) values[s] = all.steps[s];
  }
  return values;
}

std::vector<double> theta_change(const Model& model) {
  std::vector<double> values(model.theta.size(), kUnknown);
  Progress never_cancelled;
  const Result<Model> before = model_at_epoch(model, epoch_count(model) - 1, never_cancelled);
  if (!before || epoch_count(model) == 0) return values;
  for (std::size_t s = 0; s < values.size(); ++s) {
    if (known(model, s)) values[s] = model.theta[s] - before->theta[s];
  }
  return values;
}

std::vector<double> obstacle_classes(const Model& model, const spatial::CellSet* obstacles) {
  if (obstacles == nullptr) return std::vector<double>(model.theta.size(), kUnknown);
  return {obstacles->flags().begin(), obstacles->flags().end()};
}

std::vector<std::string> category_names(Layer layer) {
  switch (layer) {
    case Layer::kObstacles:
      return {"free", "a peg"};
    case Layer::kExplored:
      return {"no action", "some actions", "all six actions"};
    case Layer::kSafe:
      return {"outside", "safe"};
    case Layer::kBasin:
      return {"arrives", "loops", "dead end", "outside the safe set"};
    case Layer::kPolicy:
      return {"+x", "−x", "+y", "−y", "+z", "−z"};
    case Layer::kExpert:
      return {"not visited", "visited by the expert"};
    default:
      return {};
  }
}

std::vector<double> layer_values(const Model& model, Layer layer, const spatial::CellSet* obstacles) {
  switch (layer) {
    case Layer::kReward:
      return rewards(model, expert_cells(model));
    case Layer::kValue:
      return state_values(model);
    case Layer::kMargin:
      return margins(model);
    case Layer::kVisits:
      return visit_counts(model);
    case Layer::kExplored:
      return explored_classes(model);
    case Layer::kSafe:
      return {model.safe.flags().begin(), model.safe.flags().end()};
    case Layer::kBasin:
      return outcomes(model);
    case Layer::kSteps:
      return steps_to_goal(model);
    case Layer::kPolicy:
      return policy_actions(model);
    case Layer::kExpert:
      return expert_cells(model);
    case Layer::kThetaChange:
      return theta_change(model);
    case Layer::kObstacles:
      return obstacle_classes(model, obstacles);
    default:
      return action_values(model, static_cast<std::size_t>(layer) - static_cast<std::size_t>(Layer::kQPlusX));
  }
}

}  // namespace

std::string_view to_string(Layer layer) {
  return kLayers[static_cast<std::size_t>(layer)].name;
}

Result<Layer> layer_from(std::string_view text) {
  for (std::size_t i = 0; i < kLayers.size(); ++i) {
    if (text == kLayers[i].name) return static_cast<Layer>(i);
  }
  std::string names;
  for (const LayerText& layer : kLayers) names += fmt::format("{}{}", names.empty() ? "" : ", ", layer.name);
  return fail(ErrorCode::kInvalidArgument, fmt::format("\"{}\" is no layer: use one of {}", text, names));
}

const std::vector<Layer>& all_layers() {
  static const std::vector<Layer> layers = [] {
    std::vector<Layer> list;
    for (std::size_t i = 0; i < kLayers.size(); ++i) list.push_back(static_cast<Layer>(i));
    return list;
  }();
  return layers;
}

bool knows_visits(const Model& model) {
  return model.options.method != Method::kImported;
}

double Field::low() const {
  double lowest = std::numeric_limits<double>::infinity();
  for (const double value : values) lowest = std::isfinite(value) ? std::min(lowest, value) : lowest;
  return std::isfinite(lowest) ? lowest : 0.0;
}

double Field::high() const {
  double highest = -std::numeric_limits<double>::infinity();
  for (const double value : values) highest = std::isfinite(value) ? std::max(highest, value) : highest;
  return std::isfinite(highest) ? highest : 1.0;
}

Field field(const Model& model, Layer layer, const spatial::CellSet* obstacles) {
  Field result;
  result.layer = layer;
  result.grid = model.grid;
  result.values = layer_values(model, layer, obstacles);
  result.title = kLayers[static_cast<std::size_t>(layer)].title;
  if (layer == Layer::kVisits && model.options.method == Method::kExact) result.title = "Expected visits";
  if (layer == Layer::kSteps) result.unit = "steps";
  result.categories = category_names(layer);
  result.categorical = !result.categories.empty();
  return result;
}

std::optional<double> known_value(const Model& model, Layer layer, spatial::CellIndex cell) {
  const auto s = static_cast<std::size_t>(cell.value);
  const auto finite = [](double value) { return std::isfinite(value) ? std::optional(value) : std::nullopt; };
  const auto of_action = [&](std::size_t action) {
    const bool tried = (model.tried[s] >> action & 1) != 0;
    return tried ? finite(model.q[s * kActionCount + action]) : std::nullopt;
  };
  if (layer == Layer::kReward) {
    const auto shown = [cell](const CellSequence& expert) {
      return std::find(expert.begin(), expert.end(), cell) != expert.end();
    };
    const bool there = known(model, s) || std::any_of(model.experts.begin(), model.experts.end(), shown);
    return there ? finite(model.theta[s]) : std::nullopt;
  }
  if (layer == Layer::kValue) return value_is_known(model, s) ? finite(model.value[s]) : std::nullopt;
  TROCAR_CHECK(layer >= Layer::kQPlusX && layer <= Layer::kQMinusZ);
  return of_action(static_cast<std::size_t>(layer) - static_cast<std::size_t>(Layer::kQPlusX));
}

}  // namespace trocar::learning
