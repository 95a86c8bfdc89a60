/// How far a job has come, what it measures on its way, and whether somebody asked it to stop.
#pragma once

#include <atomic>
#include <functional>
#include <utility>

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

  /// `watcher` is called in the job's thread with every figure of `tell()`; it must not block. Call it before the job
  /// begins.
  void watch(std::function<void(double)> watcher) { watcher_ = std::move(watcher); }
  /// A figure by which the job can be watched, such as the mismatch after an epoch of a training.
  void tell(double figure) const {
    if (watcher_) watcher_(figure);
  }

 private:
  std::atomic<double> fraction_{0.0};
  std::atomic<bool> cancelled_{false};
  std::function<void(double)> watcher_;
};

}  // namespace trocar
