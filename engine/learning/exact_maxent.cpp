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
constexpr double kLoosestSolve = 1e-7;
constexpr double kTightestSolve = 1e-11;
constexpr double kFinalSolve = 1e-12;
constexpr int kStepsKept = 5;  ///< Of L-BFGS; each costs 16 bytes for each safe cell.
// The curvature along one θ is λ plus the variance of the visits, which is near D where visits are rare. Where they are
// many, θ is mostly held at its limit; these two were the best of a dozen pairs tried (44 iterations became 12).
constexpr double kVisitShare = 0.5;
constexpr double kMostFromVisits = 0.03;
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

/// The search from `guess` (by CellIndex); fills θ, V on the safe set, visits and curve.
Status optimise(Model& model, const std::vector<double>& guess, int iterations, Progress& progress) {
  MaxentObjective objective(model, guess);
  const MaxentRegion& region = objective.region();
  std::vector<double> theta(region.count(), exact_reward_limit());
  for (std::size_t i = 1; i < theta.size(); ++i) theta[i] = guess[static_cast<std::size_t>(region.cells()[i])];

  double tolerance = kLoosestSolve;
  const BoundedFunction function = [&](const std::vector<double>& x, std::vector<double>& gradient,
                                       std::vector<double>& curvature) {
    const double value = objective.evaluate(x, gradient, tolerance);
    for (std::size_t i = 0; i < x.size(); ++i) {
      gradient[i] = -gradient[i];
      curvature[i] = model.options.regularisation + std::min(kVisitShare * region.visits()[i], kMostFromVisits);
    }
    return -value;
  };
  double first = 0.0;
  const auto each_iteration = [&](double gradient) {
    model.curve.push_back(objective.mismatch());
    progress.tell(model.curve.back());
    // Far from the optimum a step gains about gradient²: the solves need not be much better than that.
    tolerance = std::clamp(1e-3 * gradient * gradient, kTightestSolve, kLoosestSolve);
    first = std::max(first, gradient);
    if (gradient < first)
      progress.set(std::min(0.99, std::log(first / gradient) / std::log(first / kGradientTolerance)));
  };
  BoundedOptions options;
  options.low = lowest_reward();
  options.high = exact_reward_limit();
  options.tolerance = kGradientTolerance;
  options.memory = kStepsKept;
  options.max_iterations = iterations;
  if (iterations > 0) TROCAR_RETURN_IF_ERROR(minimise(function, options, theta, each_iteration, progress));
  std::vector<double> gradient(theta.size());
  objective.evaluate(theta, gradient, kFinalSolve);
  write_solution(model, region, theta);
  return {};
}

}  // namespace

Status solve_exact(Model& model, const Model* previous, Progress& progress) {
  return solve_exact(model, previous, BoundedOptions{}.max_iterations, progress);
}

Status solve_exact(Model& model, const Model* previous, int iterations, Progress& progress) {
  TROCAR_RETURN_IF_ERROR(optimise(model, first_guess(model, previous), iterations, progress));
  complete_partition(model, model.value);
  fill_action_values(model);
  return {};
}

}  // namespace trocar::learning
