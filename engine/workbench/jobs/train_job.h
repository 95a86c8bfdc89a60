/// Trains a model on demonstrations of a project: cells from paths, then the learning itself.
#pragma once

#include "engine/core/progress.h"
#include "engine/core/result.h"
#include "engine/workbench/command.h"
#include "engine/workbench/project.h"

namespace trocar::workbench {

/// The cells of the segment in each of these demonstrations. Errors: those of `discretise`, naming the demonstration.
Result<std::vector<learning::CellSequence>> expert_cells(
    const std::vector<std::shared_ptr<const demonstration::Demonstration>>& demonstrations,
    demonstration::Segment segment, const spatial::Grid& grid);

/// Errors: kInvalidArgument for a number of cells that is none.
Result<spatial::Grid> training_grid(const TrainModel& request);

/// "exact A": method and segment, with ε where it is used.
std::string model_name(const TrainModel& request);

/// Threads: any; `project` is not changed. The entry has no id yet: store it, then commit `AddModel`.
/// Errors: kNotFound for a demonstration; those of `discretise` and `learning::train`.
Result<ModelEntry> train_model(const Project& project, const TrainModel& request, Progress& progress);

}  // namespace trocar::workbench
