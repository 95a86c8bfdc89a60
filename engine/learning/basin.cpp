// All rollouts at once: the policy is a function from cell to cell, so each cell is looked at twice at most.
#include <algorithm>
#include <limits>

#include "engine/learning/policy.h"
#include "engine/learning/rollout.h"
#include "engine/statistics/proportion.h"

namespace trocar::learning {
namespace {

using spatial::Action;
using spatial::CellIndex;

constexpr std::uint8_t kDown = static_cast<std::uint8_t>(Action::kMinusZ);
/// `from_above` asks for this many −z moves at the end.
constexpr int kLastMoves = 3;

class BasinPass {
 public:
  BasinPass(const Model& model, const std::vector<std::uint8_t>& policy)
      : model_(model), policy_(policy), strides_(strides(model.grid)) {
    basin_.end.assign(policy.size(), RolloutEnd::kDeadEnd);
    basin_.steps.assign(policy.size(), 0);
    basin_.from_above.assign(policy.size(), 0);
    known_.assign(policy.size(), kFresh);
  }

  Basin run() {
    for (std::size_t s = 0; s < policy_.size(); ++s) {
      if (known_[s] == kFresh) follow(static_cast<std::int32_t>(s));
    }
    return std::move(basin_);
  }

 private:
  enum Mark : std::uint8_t { kFresh, kOnPath, kDone };

  RolloutEnd end_without_move(std::int32_t cell) const {
    if (cell == model_.goal.value) return RolloutEnd::kArrives;
    return model_.safe.contains({cell}) ? RolloutEnd::kDeadEnd : RolloutEnd::kOutsideSafeSet;
  }

  void follow(std::int32_t cell) {
    path_.clear();
    RolloutEnd end = RolloutEnd::kLoops;
    for (;;) {
      const auto s = static_cast<std::size_t>(cell);
      if (known_[s] == kOnPath) break;
      if (known_[s] == kDone) {
        end = basin_.end[s];
        break;
      }
      if (policy_[s] == kNoAction || cell == model_.goal.value) {
        end = end_without_move(cell);
        settle(cell, end);
        break;
      }
      known_[s] = kOnPath;
      path_.push_back(cell);
      cell += strides_[policy_[s]];
    }
    for (auto on_path = path_.rbegin(); on_path != path_.rend(); ++on_path) settle(*on_path, end);
  }

  void settle(std::int32_t cell, RolloutEnd end) {
    const auto s = static_cast<std::size_t>(cell);
    known_[s] = kDone;
    basin_.end[s] = end;
    if (end != RolloutEnd::kArrives || cell == model_.goal.value) return;
    const std::int32_t neighbour = cell + strides_[policy_[s]];
    const auto next = static_cast<std::size_t>(neighbour);
    constexpr int kMost = std::numeric_limits<std::uint16_t>::max();
    basin_.steps[s] = static_cast<std::uint16_t>(std::min(kMost, basin_.steps[next] + 1));
    basin_.from_above[s] = basin_.steps[s] == kLastMoves ? straight_down(cell) : basin_.from_above[next];
  }

  std::uint8_t straight_down(std::int32_t cell) const {
    for (int i = 0; i < kLastMoves; ++i, --cell) {
      if (policy_[static_cast<std::size_t>(cell)] != kDown) return 0;
    }
    return 1;
  }

  const Model& model_;
  const std::vector<std::uint8_t>& policy_;
  std::array<std::int32_t, 6> strides_;
  Basin basin_;
  std::vector<std::uint8_t> known_;
  std::vector<std::int32_t> path_;
};

}  // namespace

Basin basin(const Model& model, const std::vector<std::uint8_t>& policy) {
  return BasinPass(model, policy).run();
}

std::vector<CellIndex> starts_around(const Model& model, int k) {
  const spatial::CellSet near = spatial::cells_within(model.grid, {model.start}, k);
  std::vector<CellIndex> starts;
  for (std::int32_t cell = 0; cell < model.grid.cell_count(); ++cell) {
    if (near.contains({cell})) starts.push_back({cell});
  }
  return starts;
}

RolloutSummary summarise(const Basin& basin, const std::vector<CellIndex>& starts) {
  RolloutSummary summary;
  for (const CellIndex start : starts) {
    const auto s = static_cast<std::size_t>(start.value);
    ++summary.count;
    switch (basin.end[s]) {
      case RolloutEnd::kArrives:
        ++summary.arrived;
        summary.from_above += basin.from_above[s];
        break;
      case RolloutEnd::kLoops:
        ++summary.looped;
        break;
      case RolloutEnd::kDeadEnd:
        ++summary.dead_end;
        break;
      case RolloutEnd::kOutsideSafeSet:
        ++summary.outside;
        break;
    }
  }
  return summary;
}

PairedComparison compare(const Basin& a, const Basin& b, const std::vector<CellIndex>& starts) {
  PairedComparison result;
  for (const CellIndex start : starts) {
    const auto s = static_cast<std::size_t>(start.value);
    const bool a_arrives = a.end[s] == RolloutEnd::kArrives;
    const bool b_arrives = b.end[s] == RolloutEnd::kArrives;
    result.wins_a += a_arrives && !b_arrives ? 1 : 0;
    result.wins_b += b_arrives && !a_arrives ? 1 : 0;
    result.ties += a_arrives == b_arrives ? 1 : 0;
  }
  result.mcnemar_p = statistics::mcnemar_exact_p(result.wins_a, result.wins_b);
  return result;
}

OutcomeTable outcome_table(const Basin& a, const Basin& b, const std::vector<spatial::CellIndex>& starts) {
  OutcomeTable table{};
  for (const spatial::CellIndex start : starts) {
    const auto cell = static_cast<std::size_t>(start.value);
    ++table[static_cast<std::size_t>(a.end[cell])][static_cast<std::size_t>(b.end[cell])];
  }
  return table;
}

}  // namespace trocar::learning
