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

double next_boundary(const demonstration::Demonstration& shown, double t_s, int direction) {
  // Half a sample, so that a boundary under the playhead is not found again.
  constexpr double kSlack_s = 0.5 / demonstration::kSampleRate_hz;
  double best = direction > 0 ? shown.end_s : shown.begin_s;
  for (const demonstration::SegmentSpan& span : shown.segments) {
    for (const double edge : {span.begin_s, span.end_s}) {
      if (direction > 0 && edge > t_s + kSlack_s) best = std::min(best, edge);
      if (direction < 0 && edge < t_s - kSlack_s) best = std::max(best, edge);
    }
  }
  return std::clamp(best, shown.begin_s, shown.end_s);
}

}  // namespace trocar::ui
