/// The one convex problem that `exact` solves: its value and gradient at any θ.
#pragma once

#include <vector>

#include "engine/learning/maxent_region.h"
#include "engine/learning/model.h"

namespace trocar::learning {

/// Maximum entropy IRL with γ = 1 and an absorbing goal, over the paths that never leave the safe set:
///
///   J(θ) = Σ f(s) θ(s) − Σ p(s) log Z(s) − λ/2 Σ (θ(s) − θ₀)²,     ∂J/∂θ(s) = f(s) − D(s) − λ (θ(s) − θ₀)
///
/// f: the expert's counts up to its first arrival, the goal left out; p: where the agent may have to start (`starts`);
/// Z and D: `MaxentRegion`. J is concave: log Z is the log of a sum of exponentials of sums of θ. θ lies between
/// `lowest_reward()` and `exact_reward_limit()`. All vectors are by the region's labels.
class MaxentObjective {
 public:
  /// `theta`, by CellIndex, is where the search will start.
  MaxentObjective(const Model& model, const std::vector<double>& theta);

  /// J, and its gradient. `tolerance` is the linear solves' last relative change.
  double evaluate(const std::vector<double>& theta, std::vector<double>& gradient, double tolerance);
  /// ‖f − D‖₁ / ‖f‖₁ at the latest θ.
  double mismatch() const;

  const MaxentRegion& region() const { return region_; }
  const std::vector<double>& features() const { return features_; }
  const std::vector<double>& starts() const { return starts_; }

 private:
  double prior_;
  double regularisation_;
  MaxentRegion region_;
  std::vector<double> features_;
  std::vector<double> starts_;
};

/// No θ falls below it; a cell that is never worth entering needs no more.
double lowest_reward();

}  // namespace trocar::learning
