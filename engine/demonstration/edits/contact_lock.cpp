#include "engine/demonstration/edits/contact_lock.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace trocar::demonstration {
namespace {

/// Nothing moves this near to a grasp, and all does this much further away.
constexpr double kHeld_s = 0.05;
constexpr double kEased_s = 0.25;

double eased(double distance_s, double held_s) {
  const double x = std::clamp((distance_s - held_s) / kEased_s, 0.0, 1.0);
  return x * x * (3.0 - 2.0 * x);
}

/// For each sample the time to the nearest event before it, walking in the order of `order`.
template <typename Order>
void spread(const std::vector<double>& times_s, const std::vector<bool>& event, std::vector<double>& nearest_s,
            Order order) {
  double last_s = std::numeric_limits<double>::infinity();
  bool seen = false;
  for (std::size_t step = 0; step < times_s.size(); ++step) {
    const std::size_t i = order(step);
    if (event[i]) {
      last_s = times_s[i];
      seen = true;
    }
    if (seen) nearest_s[i] = std::min(nearest_s[i], std::abs(times_s[i] - last_s));
  }
}

}  // namespace

ContactLock::ContactLock(const SampleTrack& samples, bool contacts) : freedom_(samples.size(), 1.0) {
  if (samples.empty()) return;
  std::vector<bool> event(samples.size(), false);
  std::vector<double> times_s;
  times_s.reserve(samples.size());
  constexpr std::uint32_t kContacts = kLeftHolds | kRightHolds;
  std::uint32_t before = samples.front().flags;
  for (const Sample& sample : samples) {
    event[times_s.size()] = contacts && ((sample.flags ^ before) & kContacts) != 0;
    before = sample.flags;
    times_s.push_back(sample.t_s());
  }
  std::vector<double> nearest_s(samples.size(), std::numeric_limits<double>::infinity());
  spread(times_s, event, nearest_s, [](std::size_t step) { return step; });
  spread(times_s, event, nearest_s, [&](std::size_t step) { return times_s.size() - 1 - step; });
  for (std::size_t i = 0; i < times_s.size(); ++i) {
    const double from_end_s = std::min(times_s[i] - times_s.front(), times_s.back() - times_s[i]);
    freedom_[i] = std::min(eased(from_end_s, 0.0), eased(nearest_s[i], kHeld_s));
  }
}

}  // namespace trocar::demonstration
