/// Which of the listed rollouts lie in ranges of their measures that were dragged: what table and pictures then show.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "engine/learning/rollout_table.h"
#include "engine/workbench/insight.h"

namespace trocar::ui {

class RolloutBrush {
 public:
  using Range = std::array<double, 2>;  ///< As `learning::measure`; both ends included, low ≤ high.

  /// Takes other rollouts in; the ranges stay. Before anything else of it is asked, in each frame.
  void update(const workbench::ModelInsight& insight);
  /// These ranges from now on: those of `RolloutSettings::brushed`.
  void take(const std::vector<learning::RolloutRange>& ranges);
  std::vector<learning::RolloutRange> ranges() const;  ///< By measure.

  /// By the place in `ModelInsight::listed`; NaN for what is not known, which no range holds.
  const std::vector<double>& values(learning::RolloutMeasure measure) const;
  const std::optional<Range>& range(learning::RolloutMeasure measure) const;
  void set(learning::RolloutMeasure measure, std::optional<Range> range);
  void clear();
  bool any() const;
  bool keeps(std::size_t place) const { return kept_[place] != 0; }
  std::size_t kept() const { return kept_count_; }
  /// Another number whenever other rollouts may be kept.
  int version() const { return version_; }

 private:
  void sift();

  std::shared_ptr<const std::vector<learning::Rollout>> of_;
  std::array<std::vector<double>, learning::kRolloutMeasures> values_;
  std::array<std::optional<Range>, learning::kRolloutMeasures> ranges_;
  std::vector<std::uint8_t> kept_;
  std::size_t kept_count_ = 0;
  int version_ = 0;
};

/// By cell, metres; empty while it is not known.
std::span<const double> clearance_of(const workbench::ModelInsight& insight);

}  // namespace trocar::ui
