#include "engine/learning/exact_maxent.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/learning/bounded_minimiser.h"
#include "engine/learning/maxent_objective.h"
#include "engine/learning/outside_partition.h"
#include "engine/learning/policy.h"
#include "engine/learning/training_input.h"

namespace trocar::learning {
namespace {

using spatial::kActionCount;

constexpr double kGradientTolerance = 1e-5;
constexpr double kNoWay = -std::numeric_limits<double>::infinity();

std::vector<std::uint8_t> expert_flags(const Model& model) {
  std::vector<std::uint8_t> flags(model.theta.size(), 0);
  for (const CellSequence& cells : model.experts) {
    for (const spatial::CellIndex cell : cells) flags[static_cast<std::size_t>(cell.value)] = 1;
  }
  return flags;
}

/// Where the search starts, by CellIndex: the limit along the expert, the prior elsewhere; or what was known before,
/// except where the expert has come or gone.
std::vector<double> first_guess(const Model& model, const Model* previous) {
  const std::vector<std::uint8_t> expert = expert_flags(model);
  std::vector<double> theta(model.theta.size(), model.options.theta_prior);
  for (std::size_t s = 0; s < theta.size(); ++s) {
    if (expert[s] != 0) theta[s] = exact_reward_limit();
  }
  if (previous == nullptr) return theta;
  const std::vector<std::uint8_t> before = expert_flags(*previous);
  for (std::size_t s = 0; s < theta.size(); ++s) {
    const bool known = previous->safe.flags()[s] != 0 && expert[s] == before[s];
    if (known) theta[s] = std::clamp(previous->theta[s], lowest_reward(), exact_reward_limit());
  }
  return theta;
}

/// The known moves, and Q from V = log Z.
void fill_action_values(Model& model) {
  model.tried = allowed_moves(model.grid, model.safe);
  model.tried[static_cast<std::size_t>(model.goal.value)] = 0;
  const auto stride = strides(model.grid);
  for (std::size_t s = 0; s < model.value.size(); ++s) {
    for (std::size_t a = 0; a < kActionCount; ++a) {
      const bool known = (model.tried[s] >> a & 1) != 0;
      const auto next = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(s) + stride[a]);
      model.q[s * kActionCount + a] = known ? model.theta[s] + model.value[next] : kNoWay;
    }
  }
}

void write_solution(Model& model, const MaxentRegion& region, const std::vector<double>& theta) {
  std::fill(model.theta.begin(), model.theta.end(), model.options.theta_prior);
  for (std::size_t i = 0; i < region.count(); ++i) {
    const auto s = static_cast<std::size_t>(region.cells()[i]);
    model.theta[s] = i == 0 ? 0.0 : theta[i];
    model.value[s] = region.log_partition(i);
    model.visits[s] = static_cast<std::uint32_t>(std::lround(1000.0 * region.visits()[i]));
  }
}

}  // namespace

Status solve_exact(Model& model, const Model* previous, Progress& progress) {
  {
    const std::vector<double> guess = first_guess(model, previous);
    MaxentObjective objective(model, guess);
    const MaxentRegion& region = objective.region();
    std::vector<double> theta(region.count());
    for (std::size_t i = 0; i < theta.size(); ++i) theta[i] = guess[static_cast<std::size_t>(region.cells()[i])];
    theta[0] = exact_reward_limit();

    const BoundedFunction function = [&](const std::vector<double>& x, std::vector<double>& gradient,
                                         std::vector<double>& curvature) {
      const double value = objective.evaluate(x, gradient);
      for (std::size_t i = 0; i < x.size(); ++i) {
        gradient[i] = -gradient[i];
        curvature[i] = model.options.regularisation + std::min(1.0, region.visits()[i]);
      }
      return -value;
    };
    BoundedOptions options;
    options.low = lowest_reward();
    options.high = exact_reward_limit();
    options.tolerance = kGradientTolerance;
    double first = 0.0;
    const auto each_iteration = [&](double gradient) {
      model.curve.push_back(objective.mismatch());
      first = std::max(first, gradient);
      progress.set(std::clamp(std::log(first / gradient) / std::log(first / kGradientTolerance), 0.0, 0.99));
    };
    TROCAR_RETURN_IF_ERROR(minimise(function, options, theta, each_iteration, progress));
    std::vector<double> gradient(theta.size());
    objective.evaluate(theta, gradient);
    write_solution(model, region, theta);
  }
  complete_partition(model, model.value);
  fill_action_values(model);
  return {};
}

}  // namespace trocar::learning
