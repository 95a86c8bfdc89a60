/// How far a job has come, what it measures on its way, and whether somebody asked it to stop or to wait.
#pragma once

#include <atomic>
#include <functional>
#include <utility>

namespace trocar {

/// Threads: the job writes the fraction, anyone reads it; anyone may cancel and pause.
class Progress {
 public:
  /// From 0 to 1.
  void set(double fraction) { fraction_.store(fraction, std::memory_order_relaxed); }
  double fraction() const { return fraction_.load(std::memory_order_relaxed); }
  /// Of a job that counts what it has done, such as frames: so many of so many, and the fraction with them.
  /// Precondition: 0 ≤ done ≤ of, 0 < of.
  void count(int done, int of) {
    done_.store(done, std::memory_order_relaxed);
    of_.store(of, std::memory_order_relaxed);
    set(static_cast<double>(done) / of);
  }
  int done() const { return done_.load(std::memory_order_relaxed); }
  int of() const { return of_.load(std::memory_order_relaxed); }  ///< 0: nothing is counted.

  /// The job notices at its next look, also while it is paused, and returns `ErrorCode::kCancelled`. Safe in a signal
  /// handler.
  void cancel() {
    state_.fetch_or(kCancelled, std::memory_order_relaxed);
    state_.notify_all();
  }
  bool cancelled() const { return (state_.load(std::memory_order_relaxed) & kCancelled) != 0; }

  /// The job stands still where it next calls `wait_while_paused`, until it is told to go on or cancelled. One that
  /// never calls it goes on.
  void pause(bool paused) {
    if (paused) {
      state_.fetch_or(kPaused, std::memory_order_relaxed);
    } else {
      state_.fetch_and(~kPaused, std::memory_order_relaxed);
    }
    state_.notify_all();
  }
  bool paused() const { return (state_.load(std::memory_order_relaxed) & kPaused) != 0; }
  /// For the job, between two of its steps: sleeps while it is paused and not cancelled.
  void wait_while_paused() const {
    while (state_.load(std::memory_order_relaxed) == kPaused) state_.wait(kPaused, std::memory_order_relaxed);
  }

  /// `watcher` is called in the job's thread with every figure of `tell()`; it must not block. Call it before the job
  /// begins.
  void watch(std::function<void(double)> watcher) { watcher_ = std::move(watcher); }
  /// A figure by which the job can be watched, such as the mismatch after an epoch of a training.
  void tell(double figure) const {
    if (watcher_) watcher_(figure);
  }

 private:
  static constexpr int kCancelled = 1;
  static constexpr int kPaused = 2;

  std::atomic<double> fraction_{0.0};
  std::atomic<int> done_{0};
  std::atomic<int> of_{0};
  std::atomic<int> state_{0};  ///< Both bits in one, so that a job that sleeps on it wakes for either.
  std::function<void(double)> watcher_;
};

}  // namespace trocar
