/// From what was asked for to what a session needs: the world of an overdub or a punch-in, and how to get there.
#pragma once

#include <string>

#include "engine/core/result.h"
#include "engine/workbench/command.h"
#include "engine/workbench/project.h"
#include "engine/workbench/take_writer.h"

namespace trocar::workbench {

struct TakePlan {
  trial::HandOptions options;
  std::string name;
  std::optional<TakeTarget> target;
};

/// With an overdub the take begins in the world of the demonstration that is replayed, at its begin gate; with a
/// punch-in at the beginning of the span. Where that world is not known, as of imports, the arms are led there.
/// Errors: kNotFound if it names a demonstration that there is not; kInvalidArgument for a span without samples, or one
/// that both arms only replay.
Result<TakePlan> plan_take(const Project& project, const RecordByHand& request);

/// The middle of the cell, in W. Errors: kInvalidArgument for a lattice or cell that there is not; kOutOfReach if the
/// left tool, turned as when it is ready, cannot be there.
Result<Eigen::Vector3d> place_of(const FromCell& from);

/// To be driven in the same way once more: without a name, and in place of nothing.
RecordByHand another_take(RecordByHand request);

/// "By hand 3": the first number that is free.
std::string take_name(const Project& project, const std::string& word);

}  // namespace trocar::workbench
