/// Minimises a smooth convex function of many variables between bounds (projected L-BFGS).
#pragma once

#include <functional>
#include <vector>

#include "engine/core/progress.h"
#include "engine/core/result.h"

namespace trocar::learning {

/// What is minimised. Fills the gradient and a positive estimate of the curvature along each variable (the first guess
/// of the inverse Hessian), and returns the value.
using BoundedFunction =
    std::function<double(const std::vector<double>& x, std::vector<double>& gradient, std::vector<double>& curvature)>;

struct BoundedOptions {
  double low = 0.0;
  double high = 1.0;
  double tolerance = 1e-6;  ///< On the largest entry of the gradient, bounds considered.
  int max_iterations = 1000;
  int memory = 8;  ///< Pairs of steps kept; each costs two numbers for each variable.
};

struct BoundedResult {
  std::vector<double> values;  ///< At each accepted point, the first included: never rising.
  double gradient = 0.0;       ///< The largest entry at the end.
  int evaluations = 0;
};

/// Moves `x`, which must lie between the bounds, to the minimum. `each_iteration` is called after each accepted step.
/// Stops early where rounding leaves nothing to gain. Errors: kCancelled.
Result<BoundedResult> minimise(const BoundedFunction& function, const BoundedOptions& options, std::vector<double>& x,
                               const std::function<void(double gradient)>& each_iteration, const Progress& progress);

}  // namespace trocar::learning
