#include "engine/workbench/jobs/train_job.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <utility>

#include "engine/demonstration/discretise.h"

namespace trocar::workbench {

namespace {

/// The window finds models by their name as well: what is not asked for by name must not repeat one.
std::string free_name(const Project& project, const std::string& wanted) {
  const auto taken = [&project](const std::string& name) {
    return std::any_of(project.models.begin(), project.models.end(),
                       [&name](const auto& item) { return item.second->name == name; });
  };
  std::string name = wanted;
  for (int number = 2; taken(name); ++number) name = fmt::format("{} {}", wanted, number);
  return name;
}

}  // namespace

Result<std::vector<learning::CellSequence>> expert_cells(
    const std::vector<std::shared_ptr<const demonstration::Demonstration>>& demonstrations,
    demonstration::Segment segment, const spatial::Grid& grid) {
  std::vector<learning::CellSequence> experts;
  for (const auto& shown : demonstrations) {
    auto path = demonstration::discretise(*shown, segment, grid);
    if (!path) return tl::unexpected(std::move(path).error().in("learn from \"" + shown->name + "\""));
    experts.push_back(std::move(path->cells));
  }
  return experts;
}

Result<spatial::Grid> training_grid(const TrainModel& request) {
  constexpr int kMostCells = 176;
  if (request.grid >= 4 && request.grid <= kMostCells) return spatial::Grid::with_cells(request.grid);
  return fail(ErrorCode::kInvalidArgument,
              fmt::format("the grid must have 4 to {} cells a side, not {}", kMostCells, request.grid));
}

std::string model_name(const TrainModel& request) {
  std::string name =
      fmt::format("{} {}", learning::to_string(request.options.method), demonstration::letter(request.segment));
  if (request.options.method != learning::Method::kExact) name += fmt::format(" ε={:g}", request.options.epsilon);
  return name;
}

Result<ModelEntry> train_model(const Project& project, const TrainModel& request, Progress& progress) {
  TROCAR_ASSIGN_OR_RETURN(const spatial::Grid grid, training_grid(request));
  if (request.demonstrations.empty()) return fail(ErrorCode::kInvalidArgument, "no demonstration to learn from");
  ModelEntry entry;
  std::vector<std::shared_ptr<const demonstration::Demonstration>> demonstrations;
  for (const DemonstrationId id : request.demonstrations) {
    const auto found = project.demonstrations.find(id);
    if (found == project.demonstrations.end()) {
      return fail(ErrorCode::kNotFound, fmt::format("there is no demonstration {}", id.value));
    }
    demonstrations.push_back(found->second);
    entry.demonstrations.push_back(id);
    entry.demonstration_hashes.push_back(found->second->hash());
  }
  TROCAR_ASSIGN_OR_RETURN(const std::vector<learning::CellSequence> experts,
                          expert_cells(demonstrations, request.segment, grid));
  TROCAR_ASSIGN_OR_RETURN(learning::Model model, learning::train(grid, experts, request.options, progress));
  entry.name = request.name.empty() ? free_name(project, model_name(request)) : request.name;
  entry.segment = request.segment;
  entry.model = std::make_shared<const learning::Model>(std::move(model));
  return entry;
}

}  // namespace trocar::workbench
