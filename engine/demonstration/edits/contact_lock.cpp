#include "engine/demonstration/edits/contact_lock.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace trocar::demonstration {
namespace {

/// Nothing moves this near to a grasp, and all does this much further away.
constexpr double kHeld_s = 0.05;
constexpr double kEased_s = 0.25;

/// A gripper that moves faster opens or closes.
constexpr double kJawMoves_rad_s = 0.2;

bool jaw_moves(const Sample& a, const Sample& b) {
  const double dt_s = b.t_s() - a.t_s();
  for (std::size_t arm = 0; arm < 2; ++arm) {
    if (std::abs(b.arms[arm].setpoint_jaw_rad - a.arms[arm].setpoint_jaw_rad) > kJawMoves_rad_s * dt_s) return true;
  }
  return false;
}

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

ContactLock::ContactLock(const SampleTrack& samples, What what) : freedom_(samples.size(), 1.0) {
  if (samples.empty()) return;
  std::vector<bool> event(samples.size(), false);
  std::vector<double> times_s;
  times_s.reserve(samples.size());
  constexpr std::uint32_t kContacts = kLeftHolds | kRightHolds;
  Sample before = samples.front();
  for (const Sample& sample : samples) {
    event[times_s.size()] = (what.contacts && ((sample.flags ^ before.flags) & kContacts) != 0) ||
                            (what.jaws && !times_s.empty() && jaw_moves(before, sample));
    before = sample;
    times_s.push_back(sample.t_s());
  }
  std::vector<double> nearest_s(samples.size(), std::numeric_limits<double>::infinity());
  spread(times_s, event, nearest_s, [](std::size_t step) { return step; });
  spread(times_s, event, nearest_s, [&](std::size_t step) { return times_s.size() - 1 - step; });
  for (std::size_t i = 0; i < times_s.size(); ++i) {
    const double from_end_s = std::min(times_s[i] - times_s.front(), times_s.back() - times_s[i]);
    freedom_[i] = std::min(what.ends ? eased(from_end_s, 0.0) : 1.0, eased(nearest_s[i], kHeld_s));
  }
}

}  // namespace trocar::demonstration
