/// The agents of a trial: whose segment it is, why nobody of them can have the arm, and the one that has it.
#pragma once

#include <string>
#include <vector>

#include "engine/trial/agent.h"
#include "engine/trial/trial_options.h"

namespace trocar::trial {

/// At most one moves the arm ("Shared control", Authority). Positions of the left tip are metres in W, velocities m/s.
/// Threads: one at a time.
class SegmentAgents {
 public:
  explicit SegmentAgents(const TrialOptions& options);
  SegmentAgents(const SegmentAgents&) = delete;
  SegmentAgents& operator=(const SegmentAgents&) = delete;

  /// Why none can take the arm in this segment with the tip at `p_W`; "" if one can.
  std::string refusal(demonstration::Segment segment, const Eigen::Vector3d& p_W) const;
  /// `p_W` is in the safe set of the segment's agent; true where there is none.
  bool safe(demonstration::Segment segment, const Eigen::Vector3d& p_W) const;

  /// The segment's agent takes the tool over at `p_W` as it moves. Precondition: `refusal` is "".
  void begin(demonstration::Segment segment, const Eigen::Vector3d& p_W, const Eigen::Vector3d& v_W);
  /// No effect while none has the arm.
  void end();
  /// The one that has begun and not ended; null if none has.
  Agent* driving() { return driving_; }
  const Agent* driving() const { return driving_; }
  /// Cells that all of them have led through.
  int steps() const { return steps_ + (driving_ != nullptr ? driving_->steps() : 0); }

 private:
  const Agent* of(demonstration::Segment segment) const;

  Mode mode_;
  std::vector<Agent> agents_;
  Agent* driving_ = nullptr;
  int steps_ = 0;  ///< Of those that have ended.
};

}  // namespace trocar::trial
