#include "engine/link/tick_pacer.h"

#include <fmt/format.h>
#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>

#include <algorithm>
#include <chrono>
#include <thread>

#include "engine/link/messages.h"

namespace trocar::link {
namespace {

constexpr std::int64_t kTooFar_ns = 100'000'000;
constexpr int kPriority = 20;

}  // namespace

void LatenessHistogram::add(std::int64_t late_ns) {
  const auto* const bin = std::lower_bound(kUpTo_us.begin(), kUpTo_us.end(), (late_ns + 999) / 1000);
  ++counts_[static_cast<std::size_t>(bin - kUpTo_us.begin())];
  ++ticks_;
  worst_ns_ = std::max(worst_ns_, late_ns);
  if (late_ns >= TickPacer::kPeriod_ns) ++missed_;
}

std::string LatenessHistogram::text() const {
  std::string text;
  for (std::size_t i = 0; i < counts_.size(); ++i) {
    const std::string name = i < kUpTo_us.size() ? fmt::format("up to {} us", kUpTo_us[i]) : std::string("later");
    const double share = ticks_ == 0 ? 0.0 : 100.0 * static_cast<double>(counts_[i]) / static_cast<double>(ticks_);
    text += fmt::format("  {:<14} {:>8} {:>7.2f} %\n", name, counts_[i], share);
  }
  return text;
}

TickPacer::TickPacer() : due_ns_(monotonic_ns()) {}

void TickPacer::wait() {
  due_ns_ += kPeriod_ns;
  std::this_thread::sleep_until(std::chrono::steady_clock::time_point(std::chrono::nanoseconds(due_ns_)));
  const std::int64_t late_ns = monotonic_ns() - due_ns_;
  lateness_.add(std::max<std::int64_t>(late_ns, 0));
  if (late_ns > kTooFar_ns) {
    due_ns_ += late_ns;
    ++given_up_;
  }
}

bool ask_for_real_time() {
  sched_param parameters{};
  parameters.sched_priority = kPriority;
  const bool scheduled = pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameters) == 0;
  const bool locked = mlockall(MCL_CURRENT | MCL_FUTURE) == 0;
  return scheduled && locked;
}

}  // namespace trocar::link
