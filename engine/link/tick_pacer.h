/// 1 kHz by the wall: when the next tick is due, and how late the ticks were.
#pragma once

#include <array>
#include <cstdint>
#include <string>

namespace trocar::link {

/// How late ticks began, by classes; without a clock. Threads: one at a time.
class LatenessHistogram {
 public:
  /// Upper ends of the classes but the last, which has none.
  static constexpr std::array<std::int64_t, 8> kUpTo_us{50, 100, 200, 500, 1000, 2000, 5000, 10000};

  void add(std::int64_t late_ns);
  std::int64_t ticks() const { return ticks_; }
  std::int64_t worst_ns() const { return worst_ns_; }
  /// Ticks that began when the next one was already due: a whole period late or more.
  std::int64_t missed() const { return missed_; }
  const std::array<std::int64_t, kUpTo_us.size() + 1>& counts() const { return counts_; }
  /// A class a line, with its count and share.
  std::string text() const;

 private:
  std::array<std::int64_t, kUpTo_us.size() + 1> counts_{};
  std::int64_t ticks_ = 0;
  std::int64_t worst_ns_ = 0;
  std::int64_t missed_ = 0;
};

/// Deadlines do not drift: each is a millisecond after the last, however late that was; late ticks are caught up with.
/// Who is more than 100 ms behind (a machine that slept) goes on from now. Threads: one at a time.
class TickPacer {
 public:
  static constexpr std::int64_t kPeriod_ns = 1'000'000;

  TickPacer();
  /// Sleeps until the next tick is due.
  void wait();
  const LatenessHistogram& lateness() const { return lateness_; }
  /// Times it gave up catching up.
  int given_up() const { return given_up_; }

 private:
  std::int64_t due_ns_;
  LatenessHistogram lateness_;
  int given_up_ = 0;
};

/// Asks for a real-time scheduler for this thread, and for memory that is not paged out; false where the system does
/// not grant it.
bool ask_for_real_time();

}  // namespace trocar::link
