/// What is left of the agent's motion when the operator takes over: it runs out, so that the tool does not jerk.
#pragma once

#include <Eigen/Core>
#include <algorithm>

namespace trocar::control {

/// The velocity at hand-over falls to nothing, evenly, within `kRunOut_s`; what it covers is added to where the hand
/// leads. At the agent's 50 mm/s that is 1 mm and 1.25 m/s². Threads: one at a time.
class CarryOver {
 public:
  static constexpr double kRunOut_s = 0.040;

  CarryOver() = default;
  explicit CarryOver(const Eigen::Vector3d& v_W) : v_W_(v_W), t_s_(0.0) {}

  /// How far it has carried after `seconds` more, metres in W.
  const Eigen::Vector3d& advance(double seconds) {
    const double before = share(t_s_);
    t_s_ = std::min(t_s_ + seconds, kRunOut_s);
    way_W_ += v_W_ * (share(t_s_) - before);
    return way_W_;
  }
  const Eigen::Vector3d& way() const { return way_W_; }
  bool over() const { return t_s_ >= kRunOut_s; }

 private:
  /// ∫ (1 − t/T) dt.
  static double share(double t_s) { return t_s - 0.5 * t_s * t_s / kRunOut_s; }

  Eigen::Vector3d v_W_{0.0, 0.0, 0.0};
  Eigen::Vector3d way_W_{0.0, 0.0, 0.0};
  double t_s_ = kRunOut_s;
};

}  // namespace trocar::control
