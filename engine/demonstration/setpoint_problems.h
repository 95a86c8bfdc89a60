/// What is wrong with where the tools are told to be: outside of the workspaces, too fast, in leaps. Private to the
/// module.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "engine/demonstration/problem_spans.h"
#include "engine/demonstration/problems.h"

namespace trocar::demonstration {

/// Goes through the gated samples in their order, once; what it says is meant only if all of them are finite.
class SetpointChecks {
 public:
  explicit SetpointChecks(const MotionBounds& bounds) : bounds_(bounds) {}
  void add(const Sample& sample, double t_s);
  void report(std::vector<Problem>& found) const;

 private:
  /// Of one arm.
  struct Arm {
    SpanCollector outside;
    SpanCollector jaw;
    SpanCollector leaps;
    SpanCollector speeds;
    SpanCollector jaw_speeds;
    Eigen::Vector3d last_p_WT{0.0, 0.0, 0.0};
    double last_jaw_rad = 0.0;
  };
  void check_place(const Sample& sample, double t_s, std::size_t arm);
  void check_step(const Sample& sample, double t_s, std::size_t arm);
  static void report_places(std::size_t arm, const Arm& of, std::vector<Problem>& found);
  void report_steps(std::size_t arm, const Arm& of, std::vector<Problem>& found) const;

  MotionBounds bounds_;
  std::array<Arm, 2> arms_;
  bool begun_ = false;
  double last_s_ = 0.0;  ///< By the recording's clock.
};

}  // namespace trocar::demonstration
