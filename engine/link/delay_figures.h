/// Delays as they were measured or applied, in figures.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace trocar::link {

/// Of all: count, mean, worst. Of the newest `kKept`: any share of them. Threads: one at a time.
class DelayFigures {
 public:
  static constexpr std::size_t kKept = 4096;

  void add(double seconds);
  std::int64_t count() const { return count_; }
  /// 0 for none, as the next two.
  double mean_s() const { return count_ == 0 ? 0.0 : sum_s_ / static_cast<double>(count_); }
  double worst_s() const { return worst_s_; }
  /// What a share of 0 … 1 of them does not exceed (nearest rank).
  double quantile_s(double share) const;
  /// The newest `kKept`, in no order.
  const std::vector<double>& newest() const { return kept_s_; }
  double last_s() const { return last_s_; }

 private:
  std::vector<double> kept_s_;
  std::size_t next_ = 0;
  std::int64_t count_ = 0;
  double sum_s_ = 0.0;
  double worst_s_ = 0.0;
  double last_s_ = 0.0;
};

}  // namespace trocar::link
