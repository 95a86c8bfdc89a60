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

/// The usual cube in `cells` a side. Errors: kInvalidArgument for a number of cells that is none.
Result<spatial::Grid> training_grid(int cells);

/// A model's entry before there is a model: name (numbered where `suggested` is taken; `name` as it is), segment and
/// the demonstrations as they are now; and their cells. Errors: kInvalidArgument for no demonstration, kNotFound for
/// one; those of `discretise`.
struct ModelSource {
  ModelEntry entry;
  std::vector<learning::CellSequence> experts;
};
Result<ModelSource> model_source(const Project& project, const std::vector<DemonstrationId>& demonstrations,
                                 demonstration::Segment segment, const spatial::Grid& grid, const std::string& name,
                                 const std::string& suggested);

/// "exact A": method and segment, with ε where it is used.
std::string model_name(const TrainModel& request);

/// Threads: any; `project` is not changed. The entry has no id yet: store it, then commit `AddModel`.
/// Errors: those of `model_source` and `learning::train`.
Result<ModelEntry> train_model(const Project& project, const TrainModel& request, Progress& progress);

/// A model of a table in a file, named as the file if the request names none; as `train_model` in all else.
/// Errors: those of `model_source`, `exchange::read_table` and `learning::imported_model`.
Result<ModelEntry> import_table(const Project& project, const ImportTable& request);

}  // namespace trocar::workbench
