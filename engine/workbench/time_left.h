/// How long a job still takes, as far as its pace so far tells.
#pragma once

#include <optional>

namespace trocar::workbench {

/// Time in which the job is paused, or has not begun to show a fraction, does not count. Threads: one owner.
class TimeLeft {
 public:
  /// What was seen of the job at `now_s` (of any clock that does not go back). Precondition: looks come in order.
  void look(double now_s, double fraction, bool paused) {
    if (begun_ && !paused_) worked_s_ += now_s - last_s_;
    if (!begun_ && fraction > 0.0) {
      begun_ = true;
      first_ = fraction;
    }
    last_s_ = now_s;
    paused_ = paused;
    // Between two steps of the job the estimate stays as it is: it is made anew with each.
    if (!begun_ || fraction <= first_ || fraction == fraction_ || worked_s_ <= 0.0) return;
    fraction_ = fraction;
    left_s_ = worked_s_ * (1.0 - fraction) / (fraction - first_);
  }
  /// As of the last step that was seen; none before the second.
  std::optional<double> left_s() const { return left_s_; }

 private:
  bool begun_ = false;
  bool paused_ = false;
  double first_ = 0.0;  ///< The first fraction that was seen.
  double fraction_ = 0.0;
  double last_s_ = 0.0;
  double worked_s_ = 0.0;  ///< Since then, pauses left out.
  std::optional<double> left_s_;
};

}  // namespace trocar::workbench
