/// The best a frozen reward allows: Q and V over the moves that were tried and respect the safe set.
#pragma once

#include "engine/learning/model.h"

namespace trocar::learning {

/// Replaces Q and V by the solution of Q(s,a) = θ(s) + γ V(s'), V(s) = max over the tried and allowed moves, V(goal) =
/// 0.
///
/// The fixed point is reached exactly: with θ < 0 and γ ≤ 1 a best path visits no cell twice. Minus infinity says that
/// there is no way to the goal: Q of a move that was not tried, is not allowed or leads nowhere, V of a cell with only
/// such moves. `tried` stays as it was learned. Precondition: θ < 0 everywhere but at the goal, or θ ≤ 0 and γ = 1.
void iterate_values(Model& model);

}  // namespace trocar::learning
