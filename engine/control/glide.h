/// From cell to cell without a jump of place, speed or direction: the agent's motion between its steps.
#pragma once

#include <Eigen/Core>
#include <array>

namespace trocar::control {

/// A uniform cubic B-spline over places that come one after the other, one for each step of the agent. It passes within
/// a third of a cell of the places between, ends at the last, and never leaves the convex hull of any four that follow
/// each other. Place, velocity and acceleration are continuous. Threads: one at a time.
class Glide {
 public:
  /// Begins where the tool is and as fast as it moves: `p_W` metres, `v_W` metres a second. `rate_hz`: steps a second;
  /// precondition: positive. `first` is where the agent steps first.
  Glide(const Eigen::Vector3d& p_W, const Eigen::Vector3d& v_W, double rate_hz, const Eigen::Vector3d& first);

  /// A step is over: `add` the place after the last one before `advance` is called again.
  bool wants_place() const { return wants_; }
  void add(const Eigen::Vector3d& p_W);
  /// Moves on by `seconds` (less than a step); returns where the tool is to be. Precondition: not `wants_place()`.
  Eigen::Vector3d advance(double seconds);

  Eigen::Vector3d place() const { return at(t_); }
  /// Metres a second.
  Eigen::Vector3d velocity() const;
  /// The same place was added three times: it has come to rest there.
  bool at_rest() const;

 private:
  Eigen::Vector3d at(double t) const;

  std::array<Eigen::Vector3d, 4> places_;
  double rate_hz_;
  double t_ = 0.0;  ///< In the span between the second and the third place, 0 … 1.
  bool wants_ = true;
};

}  // namespace trocar::control
