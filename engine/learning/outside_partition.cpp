#include "engine/learning/outside_partition.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/core/check.h"
#include "engine/learning/policy.h"
#include "engine/learning/portable_math.h"
#include "engine/learning/power_of_two.h"

namespace trocar::learning {
namespace {

using spatial::kActionCount;

constexpr double kTolerance = 1e-12;
constexpr int kMaxOutsideSweeps = 100'000;
constexpr double kNotReached = -std::numeric_limits<double>::infinity();

class OutsideSolver {
 public:
  OutsideSolver(const Model& model, std::vector<double>& log_partition)
      : model_(model),
        logs_(log_partition),
        moves_(allowed_moves(model.grid, model.safe)),
        stride_(strides(model.grid)),
        weight_(portable_exp(model.options.theta_prior)) {}

  void run() {
    spread();
    choose_scales();
    for (int count = 0; !sweep(); ++count)
      TROCAR_CHECK(count < kMaxOutsideSweeps);  // θ₀ below the limit: a contraction
    for (const std::int32_t cell : order_) {
      const auto s = static_cast<std::size_t>(cell);
      logs_[s] = portable_log(partition_[s]) + kLn2 * scales_[s];
    }
  }

 private:
  bool safe(std::size_t s) const { return model_.safe.flags()[s] != 0; }
  std::size_t next(std::size_t s, std::size_t action) const {
    return static_cast<std::size_t>(static_cast<std::ptrdiff_t>(s) + stride_[action]);
  }

  /// Safe cells with a neighbour outside that can reach the goal, the most likely first.
  std::vector<std::int32_t> border() const {
    std::vector<std::uint8_t> seen(logs_.size(), 0);
    std::vector<std::int32_t> cells;
    for (std::size_t s = 0; s < logs_.size(); ++s) {
      if (safe(s)) continue;
      for (std::size_t a = 0; a < kActionCount; ++a) {
        if ((moves_[s] >> a & 1) == 0) continue;
        const std::size_t other = next(s, a);
        if (!safe(other) || seen[other] != 0) continue;
        seen[other] = 1;
        cells.push_back(static_cast<std::int32_t>(other));
      }
    }
    std::sort(cells.begin(), cells.end(), [this](std::int32_t a, std::int32_t b) {
      const double left = logs_[static_cast<std::size_t>(a)];
      const double right = logs_[static_cast<std::size_t>(b)];
      return left != right ? left > right : a < b;
    });
    return cells;
  }

  /// Gives each outside cell the log of its best single path, in falling order: as all steps outside cost the same, the
  /// sorted border and the queue of cells reached so far need only be merged.
  void spread() {
    for (std::size_t s = 0; s < logs_.size(); ++s) logs_[s] = safe(s) ? logs_[s] : kNotReached;
    const std::vector<std::int32_t> seeds = border();
    std::size_t seed = 0;
    std::size_t reached = 0;
    while (seed < seeds.size() || reached < order_.size()) {
      const double by_seed = seed < seeds.size() ? logs_[static_cast<std::size_t>(seeds[seed])] : kNotReached;
      const double by_queue = reached < order_.size() ? logs_[static_cast<std::size_t>(order_[reached])] : kNotReached;
      const std::int32_t cell = by_seed >= by_queue ? seeds[seed++] : order_[reached++];
      extend_from(cell);
    }
  }

  void extend_from(std::int32_t cell) {
    const auto s = static_cast<std::size_t>(cell);
    for (std::size_t a = 0; a < kActionCount; ++a) {
      // From a safe cell only safe cells are allowed, but here it is the neighbour who steps in.
      const auto neighbour = safe(s) ? model_.grid.neighbour({cell}, static_cast<spatial::Action>(a))
                             : (moves_[s] >> a & 1) != 0
                                 ? std::optional(spatial::CellIndex{static_cast<std::int32_t>(next(s, a))})
                                 : std::nullopt;
      if (!neighbour) continue;
      const auto other = static_cast<std::size_t>(neighbour->value);
      if (safe(other) || logs_[other] != kNotReached) continue;
      logs_[other] = logs_[s] + model_.options.theta_prior;
      order_.push_back(neighbour->value);
    }
  }

  void choose_scales() {
    scales_.resize(logs_.size());
    partition_.resize(logs_.size());
    for (std::size_t s = 0; s < logs_.size(); ++s) {
      scales_[s] = static_cast<std::int32_t>(std::floor(logs_[s] / kLn2 + 0.5));
      partition_[s] = portable_exp(logs_[s] - kLn2 * scales_[s]);
    }
  }

  bool sweep() {
    bool settled = true;
    for (const std::int32_t cell : order_) {
      const auto s = static_cast<std::size_t>(cell);
      double sum = 0.0;
      for (std::size_t a = 0; a < kActionCount; ++a) {
        if ((moves_[s] >> a & 1) == 0) continue;
        const std::size_t other = next(s, a);
        sum += partition_[other] * power_of_two(scales_[other] - scales_[s]);
      }
      const double updated = weight_ * sum;
      settled = settled && std::abs(updated - partition_[s]) <= kTolerance * updated;
      partition_[s] = updated;
    }
    return settled;
  }

  const Model& model_;
  std::vector<double>& logs_;
  std::vector<std::uint8_t> moves_;
  std::array<std::int32_t, kActionCount> stride_;
  double weight_;  ///< e^θ₀.
  std::vector<std::int32_t> order_;
  std::vector<std::int32_t> scales_;
  std::vector<double> partition_;  ///< Z = partition · 2^scale.
};

}  // namespace

void complete_partition(const Model& model, std::vector<double>& log_partition) {
  OutsideSolver(model, log_partition).run();
}

}  // namespace trocar::learning
