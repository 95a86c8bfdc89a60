// Rollouts that take a while: erring at random, in the simulator, and into a file.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <thread>
#include <utility>

#include "engine/core/file.h"
#include "engine/exchange/rollout_file.h"
#include "engine/learning/start_file.h"
#include "engine/workbench/jobs/plot_job.h"
#include "engine/workbench/jobs/report_job.h"
#include "engine/workbench/workbench_impl.h"

namespace trocar::workbench {
namespace {

/// Of what came to an end; "37 % were run before it was stopped" of what did not.
std::string so_far(std::string words, int finished, std::size_t all) {
  if (static_cast<std::size_t>(finished) == all) return words;
  return fmt::format("{}; stopped at {} %, which is kept", std::move(words),
                     100 * static_cast<std::size_t>(finished) / std::max<std::size_t>(all, 1));
}

int cores() {
  return static_cast<int>(std::clamp(std::thread::hardware_concurrency(), 1U, 64U));
}

}  // namespace

void Workbench::Impl::on(const RunMonteCarlo& command) {
  if (!state.insight || !state.insight->entry) return log(Severity::kError, "no model is selected");
  const auto work = [this, entry = state.insight->entry, starts = state.rollouts.starts, options = command.options,
                     owner = file](Progress& progress) mutable -> Result<JobResult> {
    TROCAR_ASSIGN_OR_RETURN(const std::vector<spatial::CellIndex> cells, learning::read_starts(starts, *entry->model));
    options.threads = cores();
    TROCAR_ASSIGN_OR_RETURN(learning::MonteCarlo result,
                            learning::monte_carlo(*entry->model, cells, options, progress));
    auto found = std::make_shared<const MonteCarloView>(monte_carlo_view(entry, starts, std::move(result)));
    const std::string words = fmt::format("{} of {} arrive", found->arrived, found->runs);
    return JobResult{so_far(words, found->result.finished, cells.size()), [this, found, owner]() -> Status {
                       if (owner == file) state.monte_carlo = found;
                       dirty = true;
                       return {};
                     }};
  };
  jobs.start(fmt::format("Err at random, \u03b5 = {:g}", command.options.epsilon), work);
}

void Workbench::Impl::on(const RunPhysics& command) {
  if (!state.insight || !state.insight->entry) return log(Severity::kError, "no model is selected");
  const auto work = [this, entry = state.insight->entry, starts = state.rollouts.starts,
                     options = physics_options_of(*state.project, *state.insight->entry, command.options),
                     kept = state.physics, owner = file](Progress& progress) mutable -> Result<JobResult> {
    TROCAR_ASSIGN_OR_RETURN(std::vector<spatial::CellIndex> cells, learning::read_starts(starts, *entry->model));
    options.threads = cores();
    trial::PhysicsRollouts rollouts(cells.size());
    const bool goes_on = kept && kept->entry->model->hash() == entry->model->hash() && kept->cells == cells &&
                         trial::same_runs(kept->options, options);
    if (goes_on) rollouts = kept->rollouts;
    TROCAR_RETURN_IF_ERROR(trial::run_physics(*entry->model, cells, options, rollouts, progress));
    const std::size_t all = cells.size();
    auto found = std::make_shared<const PhysicsView>(
        physics_view(entry, starts, std::move(cells), options, std::move(rollouts)));
    const std::string words = fmt::format("{} of {} arrive", found->arrived, found->finished);
    return JobResult{so_far(words, found->finished, all), [this, found, owner]() -> Status {
                       if (owner == file) state.physics = found;
                       dirty = true;
                       return {};
                     }};
  };
  jobs.start("Rollouts in the simulator", work);
}

void Workbench::Impl::on(const ExportRollouts& command) {
  if (!is_output(command.path)) return;
  if (!state.insight || !state.insight->entry) return log(Severity::kError, "no model is selected");
  const auto work = [entry = state.insight->entry, starts = state.rollouts.starts, erred = state.monte_carlo,
                     simulated = state.physics, command](Progress& progress) -> Result<JobResult> {
    TROCAR_ASSIGN_OR_RETURN(const std::vector<spatial::CellIndex> cells, learning::read_starts(starts, *entry->model));
    if (command.rows == RolloutRows::kSimulated) {
      if (!simulated || simulated->entry != entry || simulated->cells != cells) {
        return fail(ErrorCode::kInvalidArgument, "these starts of this model were not run in the simulator");
      }
      TROCAR_RETURN_IF_ERROR(exchange::write_rollout_rows(
          trial::physics_csv(*entry->model, cells, simulated->options, simulated->rollouts),
          about_rollouts(*entry, starts), command.path));
      return JobResult{fmt::format("{} rollouts of the simulator written", simulated->finished), {}};
    }
    if (command.rows == RolloutRows::kBand) {
      TROCAR_ASSIGN_OR_RETURN(const std::string rows, band_rows(*entry->model, cells, progress));
      TROCAR_RETURN_IF_ERROR(write_file(command.path, rows));
      return JobResult{fmt::format("the band of {} rollouts written", cells.size()), {}};
    }
    const bool erring = command.rows == RolloutRows::kErring;
    if (erring && (!erred || erred->entry != entry || erred->result.starts != cells)) {
      return fail(ErrorCode::kInvalidArgument, "from these starts this model did not err at random");
    }
    TROCAR_ASSIGN_OR_RETURN(const std::string rows,
                            rollout_rows(*entry->model, cells, erring ? &erred->result : nullptr, progress));
    TROCAR_RETURN_IF_ERROR(exchange::write_rollout_rows(rows, about_rollouts(*entry, starts), command.path));
    return JobResult{fmt::format("{} rollouts written", cells.size()), {}};
  };
  jobs.start("Export " + command.path.filename().string(), work);
}

void Workbench::Impl::on(const ExportPlot& command) {
  if (!is_output(command.path)) return;
  PlotExport wanted;
  wanted.settings = command.settings;
  wanted.path = command.path;
  wanted.starts = state.rollouts.starts;
  if (command.settings.kind == PlotKind::kCurve) {
    // Of the whole training, whichever epoch is looked at.
    for (const ModelId id : {state.model, state.learning.second}) {
      if (const auto entry = id == ModelId{} ? nullptr : model(id)) wanted.models.push_back(entry);
    }
  } else if (state.insight && state.insight->entry) {
    wanted.models.push_back(state.insight->entry);
    if (state.insight->second) wanted.models.push_back(state.insight->second->entry);
  }
  if (wanted.models.empty()) return log(Severity::kError, "no model is selected");
  const auto work = [request = std::move(wanted)](Progress& progress) -> Result<JobResult> {
    if (request.settings.kind == PlotKind::kReport) {
      TROCAR_RETURN_IF_ERROR(write_report({request.models, request.starts, request.path}, progress));
      return JobResult{"the report is written", {}};
    }
    TROCAR_ASSIGN_OR_RETURN(const PlotReport report, export_plot(request, progress));
    if (report.starts == 0) return JobResult{"written", {}};
    return JobResult{fmt::format("written, from {} starts", report.starts), {}};
  };
  jobs.start("Export " + command.path.filename().string(), work);
}

}  // namespace trocar::workbench
