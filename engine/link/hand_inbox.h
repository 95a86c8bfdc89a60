/// Which of the frames that have come is gone by, and how fresh the link is: without sockets and without a clock.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>

#include "engine/core/tick.h"
#include "engine/link/messages.h"

namespace trocar::link {

struct ArrivedFrame {
  HandFrame frame;
  std::int64_t arrived_ns = 0;
  std::uint32_t connection = 0;  ///< Counts up with each.
};

/// Poses may be passed over for newer ones; a change of a pedal never is. Threads: one at a time.
class HandInbox {
 public:
  static constexpr std::size_t kMostWaiting = 1024;

  /// In the order in which they came. A frame whose sequence does not grow within its connection is dropped.
  void put(const ArrivedFrame& arrived);
  /// The newest, but never past a change of a pedal: then that frame, and the rest the next time. Nothing if nothing is
  /// new.
  std::optional<trial::HandSample> take();
  /// The same if a pedal changes by it; a hand that only moved waits.
  std::optional<trial::HandSample> take_pedal();
  /// What waits is gone by, pedals too: the newest frame is as if it had been taken.
  void pass_over();

  /// The frame that was taken last; nothing if none ever was.
  std::optional<trial::HandSample> taken() const { return any_taken_ ? std::optional(taken_) : std::nullopt; }
  /// The right hand of the frame that was taken last.
  const trial::HandSample& assistant() const { return assistant_; }

  /// Frames that were dropped: their sequence did not grow, or too many waited.
  std::int64_t dropped() const { return dropped_; }
  /// Frames that never came, by the gaps in the sequence.
  std::int64_t lost() const { return lost_; }
  /// Presses of which no frame told but by their count.
  std::int64_t unseen_presses() const { return unseen_presses_; }

 private:
  void add(const HandFrame& frame);
  bool changes_pedal(const HandFrame& frame) const;

  std::deque<HandFrame> waiting_;
  HandFrame newest_;  ///< That was put.
  trial::HandSample taken_;
  trial::HandSample assistant_;
  std::uint32_t connection_ = 0;
  bool any_ = false;
  bool any_taken_ = false;
  std::int64_t dropped_ = 0;
  std::int64_t lost_ = 0;
  std::int64_t unseen_presses_ = 0;
};

/// How old what was last heard is, as the guard is shown it: the guard's own rules decide what is too old. Threads: one
/// at a time.
class LinkWatchdog {
 public:
  void heard(std::int64_t at_ns, bool present);
  /// `now` and `now_ns` are the same moment, in the session's ticks and by the clock of `heard`.
  trial::LinkState state(Tick now, std::int64_t now_ns, bool connected) const;
  std::int64_t age_ns(std::int64_t now_ns) const { return any_ ? now_ns - heard_ns_ : kNever; }

 private:
  static constexpr std::int64_t kNever = std::int64_t{1} << 60;
  std::int64_t heard_ns_ = 0;
  bool present_ = false;
  bool any_ = false;
};

}  // namespace trocar::link
