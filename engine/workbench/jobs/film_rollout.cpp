#include "engine/workbench/jobs/film_rollout.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "engine/trial/rollout_recording.h"
#include "engine/workbench/rolling.h"

namespace trocar::workbench {
namespace {

constexpr std::size_t kMostKept = 9;  // As many as a film has sources.

Result<spatial::CellIndex> start_of(const ModelEntry& entry, const std::optional<std::array<int, 3>>& start) {
  const learning::Model& model = *entry.model;
  if (!start) return model.start;
  const spatial::CellCoordinates cell{(*start)[0], (*start)[1], (*start)[2]};
  if (model.grid.contains(cell)) return model.grid.index(cell);
  return fail(ErrorCode::kInvalidArgument,
              fmt::format("the cell {},{},{} is outside of the lattice of \"{}\"", cell.x, cell.y, cell.z, entry.name));
}

}  // namespace

Result<FilmedRollout> RolloutShelf::rollout(const Project& project, const ModelEntry& entry,
                                            const std::optional<std::array<int, 3>>& start) {
  TROCAR_ASSIGN_OR_RETURN(const spatial::CellIndex cell, start_of(entry, start));
  const trial::PhysicsOptions options = physics_options_of(project, entry, {});
  // One that was read has no hash beside it: it is its own.
  const std::uint64_t model_hash = entry.model->hash();
  const auto found = std::find_if(kept_.begin(), kept_.end(), [&](const Kept& kept) {
    return kept.model_hash == model_hash && kept.start == cell && same_runs(kept.options, options);
  });
  if (found != kept_.end()) {
    std::rotate(found, found + 1, kept_.end());
    return kept_.back().rollout;
  }
  if (progress_ != nullptr && progress_->cancelled()) return fail(ErrorCode::kCancelled, "stopped by the user");
  Progress alone;
  TROCAR_ASSIGN_OR_RETURN(const trial::RecordedRollout recorded,
                          trial::record_rollout(*entry.model, cell, options, alone));
  const spatial::CellCoordinates at = entry.model->grid.coordinates(cell);
  FilmedRollout rollout;
  rollout.start = {at.x, at.y, at.z};
  rollout.result = recorded.result;
  TROCAR_ASSIGN_OR_RETURN(demonstration::Demonstration shown,
                          demonstration::make_demonstration(
                              {0}, fmt::format("{} from {},{},{}", entry.name, at.x, at.y, at.z), recorded.recording));
  rollout.shown = std::make_shared<const demonstration::Demonstration>(std::move(shown));
  if (kept_.size() == kMostKept) kept_.erase(kept_.begin());
  kept_.push_back({model_hash, cell, options, rollout});
  return rollout;
}

}  // namespace trocar::workbench
