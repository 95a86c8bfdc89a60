/// The newest value across two threads: the writer never waits, the reader never sees half a value.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>

namespace trocar {

/// Threads: `back()` and `publish()` by one writer; `update()` and `front()` by one reader.
template <typename T>
class TripleBuffer {
 public:
  /// The slot to fill before `publish()`; it holds an old value, not the last one written.
  T& back() { return slots_[writer_slot_]; }

  void publish() {
    const std::uint32_t old = shared_.exchange(writer_slot_ | kFresh, std::memory_order_acq_rel);
    writer_slot_ = old & kSlot;
  }

  /// Takes the newest value if there is one since the last call; returns whether there was.
  bool update() {
    if ((shared_.load(std::memory_order_relaxed) & kFresh) == 0) return false;
    const std::uint32_t old = shared_.exchange(reader_slot_, std::memory_order_acq_rel);
    reader_slot_ = old & kSlot;
    return true;
  }

  /// As `update()`; what was in front before is let go of, not kept until it is written over.
  bool replace() {
    if ((shared_.load(std::memory_order_relaxed) & kFresh) == 0) return false;
    slots_[reader_slot_] = T{};
    return update();
  }

  const T& front() const { return slots_[reader_slot_]; }

 private:
  static constexpr std::uint32_t kSlot = 3;
  static constexpr std::uint32_t kFresh = 4;

  std::array<T, 3> slots_{};
  std::uint32_t writer_slot_ = 0;
  std::uint32_t reader_slot_ = 1;
  std::atomic<std::uint32_t> shared_{2};
};

}  // namespace trocar
