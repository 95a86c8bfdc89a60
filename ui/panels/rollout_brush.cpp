#include "ui/panels/rollout_brush.h"

#include <algorithm>

namespace trocar::ui {

using learning::RolloutMeasure;

void RolloutBrush::update(const workbench::ModelInsight& insight) {
  if (of_ == insight.listed) return;
  of_ = insight.listed;
  for (std::size_t m = 0; m < values_.size(); ++m) {
    values_[m].clear();
    values_[m].reserve(of_->size());
    for (const learning::Rollout& rollout : *of_) {
      values_[m].push_back(learning::measure(rollout, static_cast<RolloutMeasure>(m), insight.entry->model->grid,
                                             clearance_of(insight)));
    }
  }
  sift();
}

void RolloutBrush::take(const std::vector<learning::RolloutRange>& ranges) {
  if (ranges == this->ranges()) return;
  ranges_ = {};
  for (const learning::RolloutRange& one : ranges) {
    ranges_[static_cast<std::size_t>(one.measure)] = Range{one.low, one.high};
  }
  sift();
}

std::vector<learning::RolloutRange> RolloutBrush::ranges() const {
  std::vector<learning::RolloutRange> ranges;
  for (std::size_t m = 0; m < ranges_.size(); ++m) {
    if (ranges_[m]) ranges.push_back({static_cast<RolloutMeasure>(m), (*ranges_[m])[0], (*ranges_[m])[1]});
  }
  return ranges;
}

const std::vector<double>& RolloutBrush::values(RolloutMeasure measure) const {
  return values_[static_cast<std::size_t>(measure)];
}

const std::optional<RolloutBrush::Range>& RolloutBrush::range(RolloutMeasure measure) const {
  return ranges_[static_cast<std::size_t>(measure)];
}

void RolloutBrush::set(RolloutMeasure measure, std::optional<Range> range) {
  std::optional<Range>& held = ranges_[static_cast<std::size_t>(measure)];
  if (held == range) return;
  held = range;
  sift();
}

void RolloutBrush::clear() {
  ranges_ = {};
  sift();
}

bool RolloutBrush::any() const {
  return std::any_of(ranges_.begin(), ranges_.end(), [](const auto& range) { return range.has_value(); });
}

void RolloutBrush::sift() {
  kept_.assign(of_ ? of_->size() : 0, 1);
  for (std::size_t m = 0; m < ranges_.size(); ++m) {
    if (!ranges_[m]) continue;
    const auto [low, high] = *ranges_[m];
    for (std::size_t i = 0; i < kept_.size(); ++i) {
      if (!(values_[m][i] >= low && values_[m][i] <= high)) kept_[i] = 0;
    }
  }
  kept_count_ = static_cast<std::size_t>(std::count(kept_.begin(), kept_.end(), std::uint8_t{1}));
  ++version_;
}

std::span<const double> clearance_of(const workbench::ModelInsight& insight) {
  return insight.clearance_m ? std::span<const double>(*insight.clearance_m) : std::span<const double>();
}

}  // namespace trocar::ui
