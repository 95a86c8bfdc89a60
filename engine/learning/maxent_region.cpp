#include "engine/learning/maxent_region.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <utility>

#include "engine/core/check.h"
#include "engine/learning/portable_math.h"
#include "engine/learning/power_of_two.h"

namespace trocar::learning {
namespace {

using spatial::kActionCount;

constexpr int kMaxSweeps = 100'000;
constexpr double kSmallVisits = 1e-3;  ///< Below it the tolerance is absolute.

}  // namespace

MaxentRegion::MaxentRegion(const Model& model, const std::vector<double>& theta) {
  label_cells(model, theta);
}

void MaxentRegion::label_cells(const Model& model, const std::vector<double>& theta) {
  using Entry = std::pair<double, std::int32_t>;
  constexpr double kFar = std::numeric_limits<double>::infinity();
  std::vector<double> distance(theta.size(), kFar);
  std::vector<std::int32_t> label(theta.size(), -1);
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  distance[static_cast<std::size_t>(model.goal.value)] = 0.0;
  queue.emplace(0.0, model.goal.value);
  std::vector<double> log_partition;
  while (!queue.empty()) {
    const auto [length, cell] = queue.top();
    queue.pop();
    if (label[static_cast<std::size_t>(cell)] >= 0) continue;
    label[static_cast<std::size_t>(cell)] = static_cast<std::int32_t>(cells_.size());
    cells_.push_back(cell);
    log_partition.push_back(-length);
    for (int a = 0; a < kActionCount; ++a) {
      const auto neighbour = model.grid.neighbour({cell}, static_cast<spatial::Action>(a));
      if (!neighbour || !model.safe.contains(*neighbour)) continue;
      const auto next = static_cast<std::size_t>(neighbour->value);
      const double longer = length - theta[next];
      if (longer >= distance[next]) continue;
      distance[next] = longer;
      queue.emplace(longer, neighbour->value);
    }
  }
  neighbours_.resize(cells_.size() * kActionCount, static_cast<std::int32_t>(cells_.size()));
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    for (int a = 0; a < kActionCount; ++a) {
      const auto neighbour = model.grid.neighbour({cells_[i]}, static_cast<spatial::Action>(a));
      if (!neighbour || !model.safe.contains(*neighbour)) continue;
      neighbours_[i * kActionCount + static_cast<std::size_t>(a)] = label[static_cast<std::size_t>(neighbour->value)];
    }
  }
  weights_.assign(count(), 0.0);
  visits_.assign(count(), 0.0);
  partition_.assign(count() + 1, 1.0);
  partition_.back() = 0.0;
  outflow_.assign(count() + 1, 0.0);
  choose_scales(log_partition);
}

void MaxentRegion::choose_scales(const std::vector<double>& log_partition) {
  scales_.resize(count());
  for (std::size_t i = 0; i < count(); ++i)
    scales_[i] = static_cast<std::int32_t>(std::lround(log_partition[i] / kLn2));
  ratios_.assign(neighbours_.size(), 1.0);
  for (std::size_t k = 0; k < neighbours_.size(); ++k) {
    const auto other = static_cast<std::size_t>(neighbours_[k]);
    if (other < count()) ratios_[k] = power_of_two(scales_[other] - scales_[k / kActionCount]);
  }
}

void MaxentRegion::rescale() {
  std::vector<double> logs(count());
  for (std::size_t i = 0; i < count(); ++i) logs[i] = log_partition(i);
  const std::vector<std::int32_t> before = scales_;
  choose_scales(logs);
  for (std::size_t i = 0; i < count(); ++i) {
    const int shift = before[i] - scales_[i];
    partition_[i] *= power_of_two(shift);
    outflow_[i] *= power_of_two(-shift);
  }
}

int MaxentRegion::solve_partition(const std::vector<double>& theta, double tolerance) {
  for (std::size_t i = 1; i < count(); ++i) weights_[i] = portable_exp(theta[i]);
  partition_[0] = power_of_two(-scales_[0]);
  const double* ratio = ratios_.data();
  const std::int32_t* neighbour = neighbours_.data();
  double* z = partition_.data();
  int sweeps = 0;
  for (bool settled = false; !settled; ++sweeps) {
    TROCAR_CHECK(sweeps < kMaxSweeps);  // θ below the limit makes the sweep a contraction
    settled = true;
    for (std::size_t i = 1; i < count(); ++i) {
      const std::size_t k = i * kActionCount;
      const double sum = (ratio[k] * z[neighbour[k]] + ratio[k + 1] * z[neighbour[k + 1]]) +
                         (ratio[k + 2] * z[neighbour[k + 2]] + ratio[k + 3] * z[neighbour[k + 3]]) +
                         (ratio[k + 4] * z[neighbour[k + 4]] + ratio[k + 5] * z[neighbour[k + 5]]);
      const double updated = weights_[i] * sum;
      settled = settled && std::abs(updated - z[i]) <= tolerance * updated;
      z[i] = updated;
    }
  }
  const auto [least, most] = std::minmax_element(partition_.begin(), partition_.end() - 1);
  if (*least < 0x1p-300 || *most > 0x1p300) rescale();
  return sweeps;
}

double MaxentRegion::log_partition(std::size_t label) const {
  return portable_log(partition_[label]) + kLn2 * scales_[label];
}

int MaxentRegion::solve_visits(const std::vector<double>& starts, double tolerance) {
  const double* ratio = ratios_.data();
  const std::int32_t* neighbour = neighbours_.data();
  double* flow = outflow_.data();
  int sweeps = 0;
  for (bool settled = false; !settled; ++sweeps) {
    TROCAR_CHECK(sweeps < kMaxSweeps);
    settled = true;
    for (std::size_t i = count(); i-- > 0;) {
      // D(s') / z(s') = start(s') / z(s') + Σ D(s) e^θ(s) / z(s), each scaled from s to s'. The opposite move's ratio
      // is the inverse, which the neighbour has stored; what leaves the lattice has outflow 0 and any ratio.
      const std::size_t k = i * kActionCount;
      double sum = 0.0;
      for (std::size_t a = 0; a < kActionCount; ++a)
        sum += flow[neighbour[k + a]] * inverse_of_power_of_two(ratio[k + a]);
      const double visits = starts[i] + partition_[i] * sum;
      settled = settled && std::abs(visits - visits_[i]) <= tolerance * (visits + kSmallVisits);
      visits_[i] = visits;
      flow[i] = i == 0 ? 0.0 : visits * weights_[i] / partition_[i];
    }
  }
  return sweeps;
}

}  // namespace trocar::learning
