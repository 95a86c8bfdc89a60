/// The verbs of `trocar rollout`, in groups.
#pragma once

#include <initializer_list>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "app/options.h"
#include "engine/core/result.h"
#include "engine/spatial/grid.h"
#include "engine/workbench/project.h"

namespace trocar::app {

void add_rollout_look_commands(CLI::App& noun, Action& chosen);  ///< why, diverge
void add_rollout_physics_command(CLI::App& noun, Action& chosen);
void add_rollout_plot_command(CLI::App& noun, Action& chosen);
void add_rollout_report_command(CLI::App& noun, Action& chosen);

/// The models of a figure or a report, by id or name; warns of those that are stale or unlike the first. Errors:
/// kNotFound.
Result<std::vector<std::shared_ptr<const workbench::ModelEntry>>> find_drawn_models(
    const workbench::Project& project, const std::vector<std::string>& names, Console& console);

/// What rows of rollouts are written as.
inline const std::initializer_list<std::string_view> kRowEndings{".csv", ".json", ".h5", ".hdf5"};

/// What `--starts` takes.
std::string starts_help();

/// "3,4,5" as a cell. Errors: kInvalidArgument for anything else, and for a cell outside of the lattice.
Result<spatial::CellIndex> cell_from(const std::string& text, const spatial::Grid& grid);

}  // namespace trocar::app
