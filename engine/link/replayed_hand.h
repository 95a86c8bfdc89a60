/// A hand that leads the tool as a demonstration's setpoints went.
#pragma once

#include "engine/core/result.h"
#include "engine/demonstration/demonstration.h"
#include "engine/link/messages.h"

namespace trocar::link {

/// The hand's poses follow from the setpoints by the inverse of the mapping (control::ToolMapping) at `scale`: a trial
/// that begins where the demonstration did and maps by the same scale gets its setpoints again. Threads: any.
class ReplayedHand {
 public:
  /// Errors: kInvalidArgument for a demonstration without samples, or a scale outside of 0.1 … 0.5.
  static Result<ReplayedHand> create(std::shared_ptr<const demonstration::Demonstration> shown, double scale);

  /// At the sample that is the newest at `t_s` from its beginning.
  HandFrame at(double t_s) const;
  double end_s() const;

 private:
  ReplayedHand(std::shared_ptr<const demonstration::Demonstration> shown, double scale);
  std::shared_ptr<const demonstration::Demonstration> shown_;
  double scale_;
  demonstration::Sample first_;
};

}  // namespace trocar::link
