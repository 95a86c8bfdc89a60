/// A bounded queue of frames between whoever draws and the encoder. Private to the module.
#pragma once

#include <condition_variable>
#include <deque>
#include <mutex>
#include <optional>

#include "engine/core/image.h"

namespace trocar::media {

/// Threads: any; both sides wait without spinning.
class FrameQueue {
 public:
  explicit FrameQueue(std::size_t capacity) : capacity_(capacity) {}

  /// Waits while the queue is full. False if it was closed.
  bool push(Image frame) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return closed_ || frames_.size() < capacity_; });
    if (closed_) return false;
    frames_.push_back(std::move(frame));
    changed_.notify_all();
    return true;
  }

  /// Waits for a frame. None once the queue is closed and empty.
  std::optional<Image> pop() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return closed_ || !frames_.empty(); });
    if (frames_.empty()) return std::nullopt;
    std::optional<Image> frame(std::move(frames_.front()));
    frames_.pop_front();
    changed_.notify_all();
    return frame;
  }

  /// No more frames are taken; those inside are still given out, unless `drop`.
  void close(bool drop) {
    const std::scoped_lock lock(mutex_);
    closed_ = true;
    if (drop) frames_.clear();
    changed_.notify_all();
  }

 private:
  std::size_t capacity_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Image> frames_;
  bool closed_ = false;
};

}  // namespace trocar::media
