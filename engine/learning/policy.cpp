#include "engine/learning/policy.h"

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
  std::vector<std::uint8_t> policy = candidate_moves(model);
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
  return policy;
}

}  // namespace trocar::learning
