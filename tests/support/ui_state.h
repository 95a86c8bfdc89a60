/// A hand-filled workbench state for tests of the window: two demonstrations, a model, jobs, a log, a history.
#pragma once

#include <algorithm>
#include <memory>
#include <string>
#include <utility>

#include "engine/demonstration/edits.h"
#include "engine/learning/model.h"
#include "engine/learning/rollout.h"
#include "engine/peg_board/obstacles.h"
#include "engine/workbench/workbench.h"
#include "tests/support/lattice_demonstrations.h"

namespace trocar::testing {

/// Five segments of one second each, with a second of rest at either end.
inline std::shared_ptr<const demonstration::Recording> made_recording(std::uint64_t seed) {
  auto recording = std::make_shared<demonstration::Recording>();
  recording->provenance.operator_kind = "scripted";
  recording->provenance.skill = seed % 2 == 1 ? "expert" : "novice";
  recording->provenance.seed = seed;
  recording->provenance.created = "2026-03-01T12:03:41Z";
  recording->outcome = seed % 2 == 1 ? demonstration::Outcome::kSuccess : demonstration::Outcome::kDropped;
  recording->placed = seed % 2 == 1;
  for (std::int64_t i = 0; i <= 1400; ++i) {
    demonstration::Sample sample;
    sample.tick = i * demonstration::kTicksPerSample;
    const double t_s = sample.t_s();
    const double moving_s = std::min(std::max(t_s - 1.0, 0.0), 5.0);
    const auto segment = std::min(static_cast<int>(moving_s), 4);
    sample.segment = static_cast<demonstration::Segment>(segment);
    sample.authority = segment % 2 == 0 ? demonstration::Authority::kAgent : demonstration::Authority::kOperator;
    for (auto& arm : sample.arms) {
      arm.setpoint_p = {0.01 * moving_s, 0.0, 0.02};
      arm.measured = demonstration::CompactPose::from(arm.setpoint());
      arm.jaw_rad = static_cast<float>(segment == 1 || segment == 2 ? 0.1 : 0.6);
    }
    if (segment == 1 || segment == 2) sample.flags |= demonstration::kLeftHolds;
    if (sample.authority == demonstration::Authority::kAgent) sample.flags |= demonstration::kAgentPedal;
    recording->samples.push_back(sample);
  }
  return recording;
}

inline workbench::JobView made_job(std::int64_t id, std::string title, workbench::JobState of, double fraction,
                                   std::string message = "") {
  workbench::JobView job;
  job.id = {id};
  job.title = std::move(title);
  job.state = of;
  job.fraction = fraction;
  job.message = std::move(message);
  return job;
}

inline std::shared_ptr<const workbench::ModelEntry> made_model() {
  auto entry = std::make_shared<workbench::ModelEntry>();
  entry->id = {3};
  entry->name = "exact A";
  learning::TrainOptions options;
  options.method = learning::Method::kExact;
  Progress progress;
  auto model = learning::train(spatial::Grid{}, {sample_demonstrations().front()}, options, progress).value();
  model.seconds = 0.012;  // Of another machine each time.
  entry->model = std::make_shared<learning::Model>(std::move(model));
  entry->demonstrations = {{1}};
  return entry;
}

inline workbench::ModelInsight made_insight(std::shared_ptr<const workbench::ModelEntry> entry) {
  workbench::ModelInsight insight;
  const learning::Model& model = *entry->model;
  insight.entry = entry;
  insight.exploration = learning::exploration(model);
  insight.field = std::make_shared<learning::Field>(learning::field(model, learning::Layer::kReward));
  insight.policy = std::make_shared<std::vector<std::uint8_t>>(learning::greedy_policy(model));
  insight.basin = std::make_shared<learning::Basin>(learning::basin(model, *insight.policy));
  for (int k = 1; k <= 5; ++k) {
    const auto starts = learning::starts_around(model, k);
    insight.around[static_cast<std::size_t>(k - 1)] = learning::summarise(*insight.basin, starts);
    if (k != 3) continue;
    for (std::size_t i = 0; i < 40 && i < starts.size(); ++i) {
      insight.ghosts.push_back(learning::rollout(model, *insight.policy, starts[i * starts.size() / 40]));
    }
  }
  insight.all = insight.around[4];
  insight.starts = learning::starts_around(model, 3);
  insight.chosen = insight.around[2];
  insight.listed = std::make_shared<const std::vector<learning::Rollout>>(insight.ghosts);
  insight.clearance_m = std::make_shared<const std::vector<double>>(peg_board::clearances_m(model.grid));
  insight.spread = std::make_shared<const learning::RolloutSpread>(
      learning::spread_of_rollouts(model, *insight.listed, *insight.clearance_m));
  insight.epochs = insight.epoch = static_cast<int>(model.curve.size());
  return insight;
}

/// What the makers below make: each once, as reviews, curves and models take a third of a second. Use those.
inline workbench::WorkbenchState make_state() {
  auto project = std::make_shared<workbench::Project>();
  for (std::int64_t id = 1; id <= 2; ++id) {
    const std::string name = id == 1 ? "Expert 1" : "Novice 2";
    auto made = demonstration::make_demonstration({id}, name, made_recording(static_cast<std::uint64_t>(id))).value();
    project->demonstrations[{id}] = std::make_shared<demonstration::Demonstration>(std::move(made));
  }
  workbench::WorkbenchState state;
  state.load = workbench::LoadState::kReady;
  state.path = "/data/pegs.trocar";
  state.project = project;
  state.demonstration = {1};
  state.playhead_s = 2.0;
  state.review = workbench::ReviewMaker().make({project->demonstrations.at({1}), nullptr});
  state.history = {{1, 0, "add demonstration", "Record Expert 1", "2026-03-01T12:03:41Z"},
                   {2, 1, "add demonstration", "Record Novice 2", "2026-03-01T12:04:10Z"}};
  state.head = 2;
  state.undoable = true;
  state.library = workbench::LibraryMaker().make({state.project, {}}, 1'000'000);
  return state;
}

/// Ready, with demonstrations 1 ("Expert 1", selected) and 2 ("Novice 2"), and without a model.
inline workbench::WorkbenchState made_state() {
  static const workbench::WorkbenchState state = make_state();
  return state;
}

/// Its curves of every kind, and the other demonstration, raised by 2 mm, beside it, as the workbench would have worked
/// them out.
inline void work_out(workbench::WorkbenchState& state) {
  const auto shown = state.project->demonstrations.at({1});
  const auto before = std::make_shared<const demonstration::Demonstration>(
      demonstration::transformed(*state.project->demonstrations.at({2}),
                                 demonstration::Offset{demonstration::Arms::kBoth, {0.0, 0.0, 0.002}})
          .value());
  workbench::CurvesRequest curves{shown, before, 0};
  for (const auto kind : demonstration::kCurveKinds) curves.kinds |= workbench::bit(kind);
  state.curves = workbench::CurveMaker().make(curves);
  state.curve_kinds = curves.kinds;
  state.comparing.emplace().against = {workbench::Against::Kind::kDemonstration, {2}, 0};
  state.comparison = workbench::comparison_of({before, shown, *state.comparing, ""});
}

inline workbench::WorkbenchState make_state_with_model() {
  workbench::WorkbenchState state = made_state();
  auto project = std::make_shared<workbench::Project>(*state.project);
  const auto entry = made_model();
  project->models[entry->id] = entry;
  state.project = project;
  state.library = workbench::LibraryMaker().make({state.project, {}}, 1'000'000);
  state.model = entry->id;
  state.insight = std::make_shared<workbench::ModelInsight>(made_insight(entry));
  state.history.push_back({3, 2, "add model", "Train exact A", "2026-03-01T12:05:00Z"});
  state.head = 3;
  work_out(state);
  state.jobs = {made_job(2, "Train eg-maxent on segment A", workbench::JobState::kRunning, 0.42),
                made_job(1, "Verify Expert 1", workbench::JobState::kDone, 1.0, "Every state is the same")};
  state.log = {{"12:03:41", workbench::Severity::kInfo, "Opened the project"},
               {"12:05:02", workbench::Severity::kWarning, "The film was shortened"}};
  return state;
}

/// The same with the model 3 selected, curves and a comparison.
inline workbench::WorkbenchState made_state_with_model() {
  static const workbench::WorkbenchState state = make_state_with_model();
  return state;
}

inline workbench::WorkbenchState make_state_with_two_models() {
  workbench::WorkbenchState state = made_state_with_model();
  auto project = std::make_shared<workbench::Project>(*state.project);
  auto entry = std::make_shared<workbench::ModelEntry>(*project->models.at({3}));
  entry->id = {4};
  entry->name = "paper A";
  learning::TrainOptions options;
  options.episodes = 1000;
  Progress progress;
  entry->model = std::make_shared<const learning::Model>(
      learning::train(spatial::Grid{}, {sample_demonstrations().front()}, options, progress).value());
  project->models[entry->id] = entry;
  state.project = project;
  state.learning.second = {4};
  workbench::InsightRequest request;
  request.entry = project->models.at({3});
  request.second = entry;
  state.insight = workbench::InsightMaker().make(request);
  return state;
}

/// Models 3 ("exact A", selected) and 4 ("paper A"), which is the second.
inline workbench::WorkbenchState made_state_with_two_models() {
  static const workbench::WorkbenchState state = make_state_with_two_models();
  return state;
}

}  // namespace trocar::testing
