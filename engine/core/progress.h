/// How far a job has come, and whether somebody asked it to stop.
#pragma once

#include <atomic>

namespace trocar {

/// Threads: the job writes the fraction, anyone reads it; anyone may cancel.
class Progress {
 public:
  /// From 0 to 1.
  void set(double fraction) { fraction_.store(fraction, std::memory_order_relaxed); }
  double fraction() const { return fraction_.load(std::memory_order_relaxed); }
  /// The job notices at its next look and returns `ErrorCode::kCancelled`. Safe in a signal handler.
  void cancel() { cancelled_.store(true, std::memory_order_relaxed); }
  bool cancelled() const { return cancelled_.load(std::memory_order_relaxed); }

 private:
  std::atomic<double> fraction_{0.0};
  std::atomic<bool> cancelled_{false};
};

}  // namespace trocar
