/// What was learned: reward weights θ, Q, V, visits, explored actions, policy; and how.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/progress.h"
#include "engine/core/result.h"
#include "engine/spatial/grid.h"

namespace trocar::learning {

/// `eg-maxent` is the paper's Algorithm 1, `eg-maxent+` the product's variant, `exact` has no sampling; `imported` is
/// what another program learned (`imported_model.h`), and trains nothing.
enum class Method : std::uint8_t { kEgMaxent, kEgMaxentPlus, kExact, kImported };
std::string_view to_string(Method method);
/// Of those that train. Errors: kInvalidArgument with the names that there are.
Result<Method> method_from(std::string_view text);
/// Learns from episodes with random draws, and so explores: the two of EG.
bool is_sampled(Method method);

/// Table I's values are the defaults; the rest is in ARCHITECTURE.md, "Choices where the paper is silent".
struct TrainOptions {
  Method method = Method::kEgMaxent;
  double theta_rate = 0.3;  ///< β, equation (1).
  double q_rate = 0.3;      ///< α, equation (2).
  double discount = 0.99;   ///< γ, equation (2).
  double epsilon = 0.1;     ///< ε, 0 … 0.1 in the paper.
  int episodes = 10000;     ///< N.
  std::uint64_t seed = 1;
  int safe_radius = 4;           ///< Chebyshev, in cells.
  int start_spread = 6;          ///< Training starts within ± this many cells (eg-maxent+, exact).
  double theta_prior = -6.0;     ///< θ₀ of `exact`.
  double regularisation = 0.02;  ///< λ of `exact`.
  bool operator==(const TrainOptions&) const = default;
};

/// What the paper has (Table I), what the product learns with, and what needs no sampling.
enum class Preset : std::uint8_t { kPaper, kProduct, kExact };
std::string_view to_string(Preset preset);  ///< "paper", "product", "exact"
/// Errors: kInvalidArgument with the names that there are.
Result<Preset> preset_from(std::string_view text);
/// On a lattice of `cells` a side: lengths in cells keep their metres.
TrainOptions options_of(Preset preset, int cells = 22);

/// One expert trajectory as cells, first to last; consecutive cells differ by one action.
using CellSequence = std::vector<spatial::CellIndex>;

/// Immutable. Vectors are by CellIndex; `q`, 6 for each cell in the order of `spatial::Action`.
///
/// In `eg-maxent` V = max Q, and an untried action has Q = 0, where learning began. In the others Q = minus infinity
/// says that the agent has no such move (untried, off the lattice, out of the safe set, or no way to the goal).
struct Model {
  TrainOptions options;
  spatial::Grid grid;
  std::vector<CellSequence> experts;
  spatial::CellIndex start;  ///< First cell of the first expert.
  spatial::CellIndex goal;   ///< Its last cell.
  spatial::CellSet safe;
  std::vector<double> theta;  ///< Reward of each cell; NaN where an imported table says none.
  std::vector<double> q;
  std::vector<double> value;
  std::vector<std::uint32_t> visits;  ///< Times entered in training; rounded expectation × 1000 for `exact`.
  /// Bit a is set if action a was tried in the cell; for `exact`, which knows every move without trying, if the move
  /// stays on the lattice and, from a safe cell, in the safe set.
  std::vector<std::uint8_t> tried;
  std::vector<double> curve;  ///< Per epoch: feature mismatch ‖f − D‖₁ / ‖f‖₁ (mean of the last 100 episodes), or of
                              ///< the solver's iteration.
  double seconds = 0.0;  ///< Wall time of the training; not part of the hash.

  /// Of everything but `seconds`: the same for the same seed on every run and thread count.
  std::uint64_t hash() const;
  double q_at(spatial::CellIndex cell, spatial::Action action) const {
    return q[6 * static_cast<std::size_t>(cell.value) + static_cast<std::size_t>(action)];
  }
};

/// Trains; the first expert gives start and goal. Reports the fraction done and stops when cancelled.
/// Errors: kInvalidArgument naming the option or the sequence at fault; kCancelled.
Result<Model> train(const spatial::Grid& grid, const std::vector<CellSequence>& experts, const TrainOptions& options,
                    Progress& progress);

/// As `train` on the grid of `previous`, but `exact` starts from what `previous` learned: for a demonstration that was
/// moved a little, the same result (within the solver's tolerance) in a fraction of the time. Other methods start anew.
/// Errors: as `train`.
Result<Model> train_warm(const Model& previous, const std::vector<CellSequence>& experts, const TrainOptions& options,
                         Progress& progress);

/// How much of the state space has been explored (paper, section V.A): the goal is left out.
struct Exploration {
  int fully_explored = 0;  ///< All six actions tried.
  int partly_explored = 0;
  int fully_unexplored = 0;  ///< None tried.
};
Exploration exploration(const Model& model);

}  // namespace trocar::learning
