/// A gap that is bridged as the agent would go: the way of a learned policy, found once and then kept in the edit.
#pragma once

#include "engine/demonstration/edit.h"
#include "engine/workbench/edit.h"
#include "engine/workbench/project.h"

namespace trocar::workbench {

/// The bridge with its way: from the cell that the (left or only) arm is in at the begin, by the greedy policy, as far
/// as that comes nearer to where the arm is at the end; its corners are rounded. The model that was taken is named in
/// it. Any other bridge, and one that has its way, is returned as it is.
/// Errors: kNotFound if there is no such model, or none of the segment at the begin, or it was not read; kOutOfReach if
/// the arm is outside of the model's lattice; kCheckFailed if the policy does not lead towards the end.
Result<demonstration::Bridge> with_policy_way(demonstration::Bridge bridge,
                                              const demonstration::Demonstration& document, const Project& project);

/// Any edit of a demonstration, its bridges by policy with their way; `entry` not 0: it replaces that one of the stack.
/// Errors: kNotFound for the demonstration or entry; those of `with_policy_way`.
Result<demonstration::Edit> with_ways(demonstration::Edit edit, DemonstrationId demonstration, std::int64_t entry,
                                      const Project& project);
/// The same for an edit of the project: what goes into the journal.
Result<Edit> with_ways(Edit edit, const Project& project);

}  // namespace trocar::workbench
