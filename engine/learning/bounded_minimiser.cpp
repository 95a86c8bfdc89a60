#include "engine/learning/bounded_minimiser.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <deque>

namespace trocar::learning {
namespace {

using Vector = std::vector<double>;

double dot(const Vector& a, const Vector& b) {
  // Four running sums: a fixed order that still fills the vector units.
  double sums[4] = {0.0, 0.0, 0.0, 0.0};
  std::size_t i = 0;
  for (; i + 4 <= a.size(); i += 4) {
    for (std::size_t k = 0; k < 4; ++k) sums[k] += a[i + k] * b[i + k];
  }
  for (; i < a.size(); ++i) sums[0] += a[i] * b[i];
  return (sums[0] + sums[1]) + (sums[2] + sums[3]);
}

void add_scaled(Vector& to, double factor, const Vector& what) {
  for (std::size_t i = 0; i < to.size(); ++i) to[i] += factor * what[i];
}

struct Pair {
  Vector step;
  Vector change;  ///< Of the gradient over the step.
  double inverse_product = 0.0;
};

class Minimiser {
 public:
  Minimiser(const BoundedFunction& function, const BoundedOptions& options, Vector& x)
      : function_(function), options_(options), x_(x), gradient_(x.size()), curvature_(x.size(), 1.0) {
    result_.values.push_back(evaluate(x_, gradient_));
    project_gradient();
  }

  bool done() const { return result_.gradient <= options_.tolerance; }

  /// One accepted step, or false if none can be found.
  bool advance() {
    Vector direction = quasi_newton_direction();
    if (!(dot(direction, projected_) < 0.0)) direction = scaled_descent_direction();
    if (line_search(direction)) return true;
    if (pairs_.empty()) return false;
    pairs_.clear();
    return line_search(scaled_descent_direction());
  }

  BoundedResult take_result() { return std::move(result_); }
  double gradient() const { return result_.gradient; }

 private:
  double evaluate(const Vector& at, Vector& gradient) {
    ++result_.evaluations;
    return function_(at, gradient, curvature_);
  }

  bool held(std::size_t i) const {
    return (x_[i] >= options_.high && gradient_[i] <= 0.0) || (x_[i] <= options_.low && gradient_[i] >= 0.0);
  }

  void project_gradient() {
    projected_ = gradient_;
    result_.gradient = 0.0;
    for (std::size_t i = 0; i < x_.size(); ++i) {
      if (held(i)) projected_[i] = 0.0;
      result_.gradient = std::max(result_.gradient, std::abs(projected_[i]));
    }
  }

  Vector scaled_descent_direction() const {
    Vector direction(x_.size());
    for (std::size_t i = 0; i < x_.size(); ++i) direction[i] = -projected_[i] / curvature_[i];
    return direction;
  }

  /// The two loops of L-BFGS over the variables that are not held at a bound.
  Vector quasi_newton_direction() const {
    Vector direction = projected_;
    Vector factors(pairs_.size());
    for (std::size_t k = pairs_.size(); k-- > 0;) {
      factors[k] = pairs_[k].inverse_product * dot(pairs_[k].step, direction);
      add_scaled(direction, -factors[k], pairs_[k].change);
    }
    for (std::size_t i = 0; i < direction.size(); ++i) direction[i] /= curvature_[i];
    for (std::size_t k = 0; k < pairs_.size(); ++k) {
      const double factor = pairs_[k].inverse_product * dot(pairs_[k].change, direction);
      add_scaled(direction, factors[k] - factor, pairs_[k].step);
    }
    for (std::size_t i = 0; i < direction.size(); ++i) direction[i] = held(i) ? 0.0 : -direction[i];
    return direction;
  }

  bool line_search(const Vector& direction) {
    constexpr int kMaxHalvings = 30;
    constexpr double kSufficient = 1e-4;
    const double value = result_.values.back();
    // Below this the function's own rounding decides, and a smaller gradient is the better witness.
    const double noise = 1e-13 * (1.0 + std::abs(value));
    Vector trial(x_.size());
    Vector trial_gradient(x_.size());
    double length = 1.0;
    for (int halving = 0; halving < kMaxHalvings; ++halving, length *= 0.5) {
      double promised = 0.0;
      for (std::size_t i = 0; i < x_.size(); ++i) {
        trial[i] = std::clamp(x_[i] + length * direction[i], options_.low, options_.high);
        promised += gradient_[i] * (trial[i] - x_[i]);
      }
      if (promised > -noise) return false;
      const double reached = evaluate(trial, trial_gradient);
      if (reached > value + kSufficient * promised) continue;
      remember(trial, trial_gradient);
      x_.swap(trial);
      gradient_.swap(trial_gradient);
      result_.values.push_back(reached);
      project_gradient();
      return true;
    }
    return false;
  }

  void remember(const Vector& trial, const Vector& trial_gradient) {
    Pair pair;
    if (pairs_.size() == static_cast<std::size_t>(options_.memory)) {
      pair = std::move(pairs_.front());
      pairs_.pop_front();
    }
    pair.step.resize(x_.size());
    pair.change.resize(x_.size());
    for (std::size_t i = 0; i < x_.size(); ++i) {
      pair.step[i] = trial[i] - x_[i];
      pair.change[i] = trial_gradient[i] - gradient_[i];
    }
    const double product = dot(pair.step, pair.change);
    if (product <= 1e-14 * dot(pair.change, pair.change)) return;
    pair.inverse_product = 1.0 / product;
    pairs_.push_back(std::move(pair));
  }

  const BoundedFunction& function_;
  const BoundedOptions& options_;
  Vector& x_;
  Vector gradient_;
  Vector projected_;
  Vector curvature_;
  std::deque<Pair> pairs_;
  BoundedResult result_;
};

}  // namespace

Result<BoundedResult> minimise(const BoundedFunction& function, const BoundedOptions& options, std::vector<double>& x,
                               const std::function<void(double gradient)>& each_iteration, const Progress& progress) {
  Minimiser minimiser(function, options, x);
  for (int iteration = 0; iteration < options.max_iterations && !minimiser.done(); ++iteration) {
    if (progress.cancelled()) return fail(ErrorCode::kCancelled, "the training was cancelled");
    if (!minimiser.advance()) break;
    each_iteration(minimiser.gradient());
  }
  return minimiser.take_result();
}

}  // namespace trocar::learning
