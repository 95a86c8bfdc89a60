/// log Z of the cells outside of the safe set, from which `exact` walks in.
#pragma once

#include <vector>

#include "engine/learning/model.h"

namespace trocar::learning {

/// Completes `log_partition` (by CellIndex, given on the safe set) on the rest of the lattice, where every move on the
/// lattice is allowed and θ is the prior θ₀: Z(s) = e^θ₀ Σ Z(s'), to a relative change of 1e-12 a sweep.
///
/// The sweeps follow the order in which a walk of equal steps spreads from the safe set, so four or five are enough.
/// Memory: 18 bytes for each cell of the lattice. Precondition: θ₀ ≤ `exact_reward_limit()`.
void complete_partition(const Model& model, std::vector<double>& log_partition);

}  // namespace trocar::learning
