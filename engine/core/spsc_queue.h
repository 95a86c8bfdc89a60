/// A stream in order from one thread to another, without locks and with a fixed capacity.
#pragma once

#include <atomic>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace trocar {

/// Threads: `push()` by one writer, `pop()` by one reader.
template <typename T>
class SpscQueue {
 public:
  /// Holds up to `capacity` values; precondition: capacity > 0.
  explicit SpscQueue(std::size_t capacity) : slots_(capacity + 1) {}

  /// False if the queue is full; `value` is then untouched.
  [[nodiscard]] bool push(T&& value) {
    const std::size_t tail = tail_.load(std::memory_order_relaxed);
    const std::size_t next = after(tail);
    if (next == head_.load(std::memory_order_acquire)) return false;
    slots_[tail] = std::move(value);
    tail_.store(next, std::memory_order_release);
    return true;
  }

  std::optional<T> pop() {
    const std::size_t head = head_.load(std::memory_order_relaxed);
    if (head == tail_.load(std::memory_order_acquire)) return std::nullopt;
    std::optional<T> value(std::move(slots_[head]));
    head_.store(after(head), std::memory_order_release);
    return value;
  }

 private:
  std::size_t after(std::size_t i) const { return i + 1 == slots_.size() ? 0 : i + 1; }

  std::vector<T> slots_;
  std::atomic<std::size_t> head_{0};
  std::atomic<std::size_t> tail_{0};
};

}  // namespace trocar
