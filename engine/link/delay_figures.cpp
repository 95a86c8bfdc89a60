#include "engine/link/delay_figures.h"

#include <algorithm>
#include <cmath>

namespace trocar::link {

void DelayFigures::add(double seconds) {
  if (kept_s_.size() < kKept) {
    kept_s_.push_back(seconds);
  } else {
    kept_s_[next_] = seconds;
  }
  next_ = (next_ + 1) % kKept;
  ++count_;
  sum_s_ += seconds;
  worst_s_ = std::max(worst_s_, seconds);
  last_s_ = seconds;
}

double DelayFigures::quantile_s(double share) const {
  if (kept_s_.empty()) return 0.0;
  std::vector<double> sorted = kept_s_;
  const auto rank =
      static_cast<std::size_t>(std::ceil(std::clamp(share, 0.0, 1.0) * static_cast<double>(sorted.size())));
  const std::size_t index = rank == 0 ? 0 : rank - 1;
  std::nth_element(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(index), sorted.end());
  return sorted[index];
}

}  // namespace trocar::link
