#include "ui/idle.h"

#include <cmath>
#include <span>

namespace trocar::ui {
namespace {

using demonstration::Sample;

bool moves(const Sample& a, const Sample& b, double speed_m_per_s) {
  const double dt = b.t_s() - a.t_s();
  for (std::size_t arm = 0; arm < 2; ++arm) {
    double squared = 0.0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double step = b.arms[arm].setpoint_p[axis] - a.arms[arm].setpoint_p[axis];
      squared += step * step;
    }
    if (std::sqrt(squared) > speed_m_per_s * dt) return true;
    if (a.arms[arm].setpoint_jaw_rad != b.arms[arm].setpoint_jaw_rad) return true;
  }
  return false;
}

}  // namespace

std::optional<demonstration::Trim> idle_trim(const demonstration::Demonstration& shown, const IdleOptions& options) {
  const std::span<const Sample> samples = shown.gated();
  if (samples.size() < 3) return std::nullopt;
  std::size_t first = 0;
  while (first + 1 < samples.size() && !moves(samples[first], samples[first + 1], options.speed_m_per_s)) ++first;
  if (first + 1 == samples.size()) return std::nullopt;
  std::size_t last = samples.size() - 1;
  while (last > first && !moves(samples[last - 1], samples[last], options.speed_m_per_s)) --last;
  const double moves_from_s = shown.time_of(samples[first]);
  const double moves_to_s = shown.time_of(samples[last]);
  demonstration::Trim trim{shown.begin_s, shown.end_s};
  if (moves_from_s - shown.begin_s > options.longest_s) trim.from_s = moves_from_s - options.kept_s;
  if (shown.end_s - moves_to_s > options.longest_s) trim.to_s = moves_to_s + options.kept_s;
  if (trim.from_s == shown.begin_s && trim.to_s == shown.end_s) return std::nullopt;
  return trim;
}

}  // namespace trocar::ui
