#include "engine/workbench/jobs/train_job.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <utility>

#include "engine/demonstration/discretise.h"
#include "engine/exchange/lattice_table.h"

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

Result<spatial::Grid> training_grid(int cells) {
  constexpr int kMostCells = 176;
  if (cells >= 4 && cells <= kMostCells) return spatial::Grid::with_cells(cells);
  return fail(ErrorCode::kInvalidArgument,
              fmt::format("the grid must have 4 to {} cells a side, not {}", kMostCells, cells));
}

Result<ModelSource> model_source(const Project& project, const std::vector<DemonstrationId>& demonstrations,
                                 demonstration::Segment segment, const spatial::Grid& grid, const std::string& name,
                                 const std::string& suggested) {
  if (demonstrations.empty()) return fail(ErrorCode::kInvalidArgument, "no demonstration to learn from");
  ModelSource source;
  std::vector<std::shared_ptr<const demonstration::Demonstration>> found;
  for (const DemonstrationId id : demonstrations) {
    const auto one = project.demonstrations.find(id);
    if (one == project.demonstrations.end()) {
      return fail(ErrorCode::kNotFound, fmt::format("there is no demonstration {}", id.value));
    }
    found.push_back(one->second);
    source.entry.demonstrations.push_back(id);
    source.entry.demonstration_hashes.push_back(one->second->hash());
  }
  TROCAR_ASSIGN_OR_RETURN(source.experts, expert_cells(found, segment, grid));
  source.entry.name = name.empty() ? free_name(project, suggested) : name;
  source.entry.segment = segment;
  return source;
}

std::string model_name(const TrainModel& request) {
  std::string name =
      fmt::format("{} {}", learning::to_string(request.options.method), demonstration::letter(request.segment));
  if (request.options.method != learning::Method::kExact) name += fmt::format(" ε={:g}", request.options.epsilon);
  return name;
}

Result<ModelEntry> train_model(const Project& project, const TrainModel& request, Progress& progress) {
  TROCAR_ASSIGN_OR_RETURN(const spatial::Grid grid, training_grid(request.grid));
  TROCAR_ASSIGN_OR_RETURN(ModelSource source, model_source(project, request.demonstrations, request.segment, grid,
                                                           request.name, model_name(request)));
  TROCAR_ASSIGN_OR_RETURN(learning::Model model, learning::train(grid, source.experts, request.options, progress));
  source.entry.model = std::make_shared<const learning::Model>(std::move(model));
  return std::move(source.entry);
}

Result<ModelEntry> import_table(const Project& project, const ImportTable& request) {
  TROCAR_ASSIGN_OR_RETURN(const spatial::Grid grid, training_grid(request.grid));
  TROCAR_ASSIGN_OR_RETURN(ModelSource source, model_source(project, request.demonstrations, request.segment, grid,
                                                           request.name, request.path.stem().string()));
  TROCAR_ASSIGN_OR_RETURN(const std::vector<double> table, exchange::read_table(request.path, request.kind, grid));
  auto model = learning::imported_model(grid, source.experts, request.safe_radius, request.kind, table);
  if (!model) return tl::unexpected(std::move(model).error().at(request.path.string()));
  source.entry.model = std::make_shared<const learning::Model>(std::move(*model));
  return std::move(source.entry);
}

}  // namespace trocar::workbench
