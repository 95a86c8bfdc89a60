/// Wall time behind an interface, so that tests and the command line can drive it by hand.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace trocar {

/// Threads: any.
class Clock {
 public:
  virtual ~Clock() = default;
  /// Monotonic nanoseconds since an arbitrary moment.
  virtual std::int64_t now_ns() const = 0;
  /// Seconds since 1970, UTC.
  virtual std::int64_t unix_s() const = 0;

  double now_s() const { return static_cast<double>(now_ns()) * 1e-9; }
};

class SystemClock final : public Clock {
 public:
  std::int64_t now_ns() const override;
  std::int64_t unix_s() const override;
};

/// Stands still until told. Threads: one at a time.
class ManualClock final : public Clock {
 public:
  std::int64_t now_ns() const override { return now_ns_; }
  std::int64_t unix_s() const override { return kEpoch_s + now_ns_ / 1'000'000'000; }
  void advance_s(double seconds) { now_ns_ += static_cast<std::int64_t>(seconds * 1e9); }

 private:
  static constexpr std::int64_t kEpoch_s = 1'700'000'000;
  std::int64_t now_ns_ = 0;
};

/// "2026-03-01T12:00:00Z".
std::string iso_time(std::int64_t unix_s);

}  // namespace trocar
