/// Models made of tables that another program learned: of Q, or of the reward's weights θ.
#pragma once

#include "engine/learning/model.h"

namespace trocar::learning {

enum class TableKind : std::uint8_t { kQ, kTheta };
std::string_view to_string(TableKind kind);  ///< "q", "theta"
/// Errors: kInvalidArgument with the names that there are.
Result<TableKind> table_kind_from(std::string_view text);
/// Numbers for each cell: 6 of Q, in the order of `spatial::Action`; 1 of θ.
int table_width(TableKind kind);

/// `table` is by CellIndex, `table_width` numbers for each cell; NaN (of Q minus infinity, too) where nothing is known.
/// The experts give start, goal and, with `safe_radius`, the safe set, as in training. Nothing was visited.
///
/// Q: V is the largest Q of a cell, 0 at the goal; θ is unknown (NaN). A move without a Q is one that the agent does
/// not have. θ: Q(s,a) = θ(s) + V(s'), V(s) = max over the moves that lattice and safe set allow, V(goal) = 0. Errors:
/// kInvalidArgument for experts that `train` would refuse, a table of another size or without any number, an infinite
/// number, and a θ above 0 anywhere but at the goal.
Result<Model> imported_model(const spatial::Grid& grid, const std::vector<CellSequence>& experts, int safe_radius,
                             TableKind kind, const std::vector<double>& table);

/// The table that `imported_model` takes. Q: of every move that the policy may choose or the agent tried, NaN of all
/// others, and with `eg-maxent` outside of the safe set; so an imported Q has the same policy. θ: of every cell that
/// the agent knows.
std::vector<double> table_of(const Model& model, TableKind kind);

}  // namespace trocar::learning
