#include "engine/workbench/rolling.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "engine/peg_board/obstacles.h"

namespace trocar::workbench {

MonteCarloView monte_carlo_view(std::shared_ptr<const ModelEntry> entry, std::string starts,
                                learning::MonteCarlo result) {
  MonteCarloView view;
  view.share = std::make_shared<const learning::Field>(learning::success_share(entry->model->grid, result));
  view.entry = std::move(entry);
  view.starts = std::move(starts);
  view.runs = static_cast<std::int64_t>(result.finished) * result.runs();
  for (std::size_t i = 0; i < static_cast<std::size_t>(result.finished); ++i) view.arrived += result.arrived[i];
  view.interval = statistics::wilson_interval(view.arrived, view.runs);
  view.result = std::move(result);
  return view;
}

PhysicsView physics_view(std::shared_ptr<const ModelEntry> entry, std::string starts,
                         std::vector<spatial::CellIndex> cells, const trial::PhysicsOptions& options,
                         trial::PhysicsRollouts rollouts) {
  PhysicsView view{std::move(entry), std::move(starts), std::move(cells), options, std::move(rollouts)};
  view.finished = trial::finished(view.rollouts);
  for (const auto& rollout : view.rollouts) {
    if (!rollout) continue;
    view.arrived += rollout->end == trial::PhysicsEnd::kArrives ? 1 : 0;
    view.pushed_m = std::max(view.pushed_m, rollout->pushed_m);
  }
  return view;
}

trial::PhysicsOptions physics_options_of(const Project& project, const ModelEntry& entry,
                                         trial::PhysicsOptions options) {
  options.segment = entry.segment;
  if (entry.demonstrations.empty()) return options;
  const auto shown = project.demonstrations.find(entry.demonstrations.front());
  if (shown == project.demonstrations.end()) return options;
  options.block = std::clamp(shown->second->block, 0, peg_board::kBlockCount - 1);
  options.goal = std::clamp(shown->second->goal, 0, peg_board::kBlockCount - 1);
  return options;
}

double steps_taken(const learning::Rollout& rollout, const RolloutSettings& settings) {
  const auto all = static_cast<double>(rollout.cells.size() - 1);
  if (!settings.reach) return all;
  return std::clamp(settings.pace == GhostPace::kLength ? *settings.reach * all : *settings.reach, 0.0, all);
}

std::map<std::string, std::string> about_rollouts(const ModelEntry& entry, const std::string& starts) {
  return {{"model", entry.name},
          {"method", std::string(learning::to_string(entry.model->options.method))},
          {"segment", std::string(1, demonstration::letter(entry.segment))},
          {"starts", starts}};
}

Result<std::string> rollout_rows(const learning::Model& model, const std::vector<spatial::CellIndex>& starts,
                                 const learning::MonteCarlo* monte_carlo, Progress& progress) {
  const std::vector<double> clearance_m = peg_board::clearances_m(model.grid);
  return learning::rollout_csv(model, learning::greedy_policy(model), starts, {clearance_m, monte_carlo}, progress);
}

Result<std::string> band_rows(const learning::Model& model, const std::vector<spatial::CellIndex>& starts,
                              Progress& progress) {
  TROCAR_ASSIGN_OR_RETURN(const learning::RolloutSpread spread,
                          learning::spread_from(model, learning::greedy_policy(model), starts, {}, progress));
  if (!spread.band.count.empty()) return learning::band_csv(spread.band);
  return fail(ErrorCode::kInvalidArgument,
              fmt::format("a band needs {} starts, and there are {}", learning::kLeastInBand, starts.size()));
}

}  // namespace trocar::workbench
