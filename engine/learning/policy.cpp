#include "engine/learning/policy.h"

#include <cmath>
#include <limits>

#include "engine/learning/rollout.h"

namespace trocar::learning {
namespace {

using spatial::Grid;
using spatial::kActionCount;

constexpr double kLowest = -std::numeric_limits<double>::infinity();

/// Bits of the two actions along one axis that stay on the lattice.
unsigned along_axis(int coordinate, int n, unsigned plus_bit) {
  return (coordinate + 1 < n ? plus_bit : 0U) | (coordinate > 0 ? plus_bit << 1U : 0U);
}

/// Actions whose Q is the best one in the cell, to the bit.
std::vector<std::uint8_t> tied_moves(const Model& model, const std::vector<std::uint8_t>& candidates,
                                     const std::vector<std::uint8_t>& policy) {
  std::vector<std::uint8_t> tied(policy.size(), 0);
  for (std::size_t s = 0; s < policy.size(); ++s) {
    if (policy[s] == kNoAction) continue;
    const double best = model.q[s * kActionCount + policy[s]];
    for (unsigned a = 0; a < kActionCount; ++a) {
      const bool ties = (candidates[s] >> a & 1U) != 0 && model.q[s * kActionCount + a] == best;
      tied[s] = static_cast<std::uint8_t>(tied[s] | (ties ? 1U << a : 0U));
    }
  }
  return tied;
}

/// Of tied actions the one on the shortest way to the goal, so that nobody goes round where θ is 0. Ways are counted
/// over tied actions alone, from the goal backwards.
void prefer_short_ways(const Model& model, const std::vector<std::uint8_t>& candidates,
                       std::vector<std::uint8_t>& policy) {
  constexpr std::int32_t kNever = std::numeric_limits<std::int32_t>::max();
  const std::vector<std::uint8_t> tied = tied_moves(model, candidates, policy);
  const auto stride = strides(model.grid);
  const std::int32_t cells = model.grid.cell_count();
  std::vector<std::int32_t> steps(tied.size(), kNever);
  std::vector<std::int32_t> reached{model.goal.value};
  steps[static_cast<std::size_t>(model.goal.value)] = 0;
  for (std::size_t i = 0; i < reached.size(); ++i) {
    const std::int32_t here = reached[i];
    for (unsigned a = 0; a < kActionCount; ++a) {
      const std::int32_t before = here - stride[a];
      if (before < 0 || before >= cells || (tied[static_cast<std::size_t>(before)] >> a & 1U) == 0) continue;
      std::int32_t& known = steps[static_cast<std::size_t>(before)];
      if (known != kNever) continue;
      known = steps[static_cast<std::size_t>(here)] + 1;
      reached.push_back(before);
    }
  }
  for (std::size_t s = 0; s < policy.size(); ++s) {
    std::int32_t least = kNever;
    for (unsigned a = 0; a < kActionCount; ++a) {
      if ((tied[s] >> a & 1U) == 0) continue;
      const std::int32_t there = steps[static_cast<std::size_t>(static_cast<std::int32_t>(s) + stride[a])];
      if (there >= least) continue;
      least = there;
      policy[s] = static_cast<std::uint8_t>(a);
    }
  }
}

/// Its Q is of the cheapest way: rewards of 0 leave ties all over the lattice.
bool is_of_imported_rewards(const Model& model) {
  return model.options.method == Method::kImported &&
         std::isfinite(model.theta[static_cast<std::size_t>(model.start.value)]);
}

}  // namespace

std::array<std::int32_t, kActionCount> strides(const Grid& grid) {
  const int n = grid.n;
  return {n * n, -n * n, n, -n, 1, -1};
}

std::vector<std::uint8_t> allowed_moves(const Grid& grid, const spatial::CellSet& safe) {
  std::vector<std::uint8_t> moves(static_cast<std::size_t>(grid.cell_count()));
  const std::vector<std::uint8_t>& flags = safe.flags();
  const auto stride = strides(grid);
  std::size_t s = 0;
  for (int x = 0; x < grid.n; ++x) {
    for (int y = 0; y < grid.n; ++y) {
      const unsigned sideways = along_axis(x, grid.n, 1U) | along_axis(y, grid.n, 4U);
      for (int z = 0; z < grid.n; ++z, ++s) {
        unsigned bits = sideways | along_axis(z, grid.n, 16U);
        if (flags[s] != 0) {
          for (unsigned a = 0; a < kActionCount; ++a) {
            const std::size_t next = s + static_cast<std::size_t>(static_cast<std::ptrdiff_t>(stride[a]));
            if ((bits >> a & 1U) != 0 && flags[next] == 0) bits &= ~(1U << a);
          }
        }
        moves[s] = static_cast<std::uint8_t>(bits);
      }
    }
  }
  return moves;
}

std::vector<std::uint8_t> candidate_moves(const Model& model) {
  std::vector<std::uint8_t> moves = allowed_moves(model.grid, model.safe);
  const bool paper = model.options.method == Method::kEgMaxent;
  for (std::size_t s = 0; s < moves.size(); ++s) {
    if (paper) {
      if (model.tried[s] == 0 || model.safe.flags()[s] == 0) moves[s] = 0;
      continue;
    }
    unsigned finite = 0;
    for (unsigned a = 0; a < kActionCount; ++a) finite |= (model.q[s * kActionCount + a] > kLowest ? 1U : 0U) << a;
    moves[s] = static_cast<std::uint8_t>(moves[s] & model.tried[s] & finite);
  }
  moves[static_cast<std::size_t>(model.goal.value)] = 0;
  return moves;
}

std::vector<std::uint8_t> greedy_policy(const Model& model) {
  const std::vector<std::uint8_t> all_candidates = candidate_moves(model);
  std::vector<std::uint8_t> policy = all_candidates;
  for (std::size_t s = 0; s < policy.size(); ++s) {
    const unsigned candidates = policy[s];
    double best = kLowest;
    std::uint8_t choice = kNoAction;
    for (unsigned a = 0; a < kActionCount; ++a) {
      const double q = (candidates >> a & 1U) != 0 ? model.q[s * kActionCount + a] : kLowest;
      choice = q > best ? static_cast<std::uint8_t>(a) : choice;
      best = q > best ? q : best;
    }
    policy[s] = choice;
  }
  if (is_of_imported_rewards(model)) prefer_short_ways(model, all_candidates, policy);
  return policy;
}

}  // namespace trocar::learning
