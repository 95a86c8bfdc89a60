/// The operator's hand as it arrives at the arm: later than it moved, by the delay of the network.
#pragma once

#include <deque>

#include "engine/control/delay_model.h"
#include "engine/core/tick.h"
#include "engine/trial/operator_input.h"

namespace trocar::trial {

/// In order, nothing lost. Threads: one at a time.
class HandLine {
 public:
  explicit HandLine(const control::DelayOptions& options) : delay_(options) {}

  void send(const HandSample& sample, Tick now);
  /// Takes in what has arrived by `now`; true if anything had. A constant delay is an exact shift in ticks.
  bool receive(Tick now);
  /// The newest that has arrived.
  const HandSample& sample() const { return newest_; }
  bool any() const { return any_; }
  /// When the newest one arrived.
  Tick arrived_at() const { return arrived_; }
  double last_delay_s() const { return last_delay_s_; }
  double mean_delay_s() const { return count_ == 0 ? 0.0 : sum_delay_s_ / static_cast<double>(count_); }
  double worst_delay_s() const { return worst_delay_s_; }

 private:
  struct Message {
    HandSample sample;
    Tick sent;
    Tick arrives;
  };
  control::DelayModel delay_;
  std::deque<Message> under_way_;
  HandSample newest_;
  Tick arrived_;
  bool any_ = false;
  std::int64_t count_ = 0;
  double last_delay_s_ = 0.0;
  double sum_delay_s_ = 0.0;
  double worst_delay_s_ = 0.0;
};

}  // namespace trocar::trial
