#include "ui/timeline_steps.h"

#include <algorithm>

namespace trocar::ui {

double stepped(const demonstration::Demonstration& shown, double t_s, int steps) {
  const auto samples = shown.gated();
  if (samples.empty()) return t_s;
  const auto at = static_cast<std::ptrdiff_t>(samples.lower_bound(shown.tick_after(t_s)));
  const auto index = std::max<std::ptrdiff_t>(at - 1, 0) + steps;
  const auto last = static_cast<std::ptrdiff_t>(samples.size()) - 1;
  return shown.time_of(samples[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(index, 0, last))]);
}

double shuttled(double speed, int direction) {
  constexpr double kFastest = 32.0;
  const double ahead = direction * speed;
  return direction * (ahead < 1.0 ? 1.0 : std::min(2.0 * ahead, kFastest));
}

}  // namespace trocar::ui
