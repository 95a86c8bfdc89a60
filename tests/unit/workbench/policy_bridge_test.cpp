#include "engine/workbench/policy_bridge.h"

#include <doctest/doctest.h>

#include "engine/workbench/batch.h"
#include "tests/support/project_fixture.h"
#include "tests/support/ui_state.h"

using namespace trocar;
using namespace trocar::workbench;
using demonstration::Bridge;
using demonstration::BridgeShape;

namespace {

/// The left tool stands at the model's start for a second, then at its goal: what is to be bridged lies between.
demonstration::Demonstration jumping(const learning::Model& model) {
  auto recording = std::make_shared<demonstration::Recording>();
  for (int i = 0; i <= 600; ++i) {
    demonstration::Sample sample;
    sample.tick = i * demonstration::kTicksPerSample;
    sample.segment = demonstration::Segment::kA;
    spatial::Pose X_WT = sample.arms[0].setpoint();
    X_WT.p = model.grid.centre(i <= 200 ? model.start : model.goal);
    sample.arms[0].set_setpoint(X_WT, 0.3);
    sample.arms[0].measured = demonstration::CompactPose::from(X_WT);
    recording->samples.push_back(sample);
  }
  return demonstration::make_demonstration({1}, "Jump", recording).value();
}

Project project_of(const std::shared_ptr<const ModelEntry>& entry, demonstration::Demonstration document) {
  Project project;
  project.models[entry->id] = entry;
  project.demonstrations[{1}] = std::make_shared<const demonstration::Demonstration>(std::move(document));
  return project;
}

Bridge by_policy(double from_s, double to_s, std::int64_t model = 0) {
  Bridge bridge;
  bridge.from_s = from_s;
  bridge.to_s = to_s;
  bridge.arms = demonstration::Arms::kLeft;
  bridge.shape = BridgeShape::kPolicy;
  bridge.model = model;
  return bridge;
}

}  // namespace

TEST_CASE("a bridge by policy goes through the cells that the policy goes through") {
  const auto entry = testing::made_model();
  const learning::Model& model = *entry->model;
  const Project project = project_of(entry, jumping(model));
  const demonstration::Demonstration& document = *project.demonstrations.at({1});
  const auto found = with_policy_way(by_policy(0.5, 2.5), document, project);
  REQUIRE(found);
  CHECK(found->model == 3);
  REQUIRE(found->via_m.size() > 4);
  const learning::Rollout agent = learning::rollout(model, learning::greedy_policy(model), model.start);
  const demonstration::Demonstration bridged = demonstration::apply(document, *found).value();
  // Rounding a corner leaves the way through the middles of cells by less than half a cell along each axis.
  for (const demonstration::Sample& sample : bridged.samples) {
    const Eigen::Vector3d p_WT = sample.arms[0].measured.pose().p;
    double nearest_m = 1.0;
    for (const spatial::CellIndex cell : agent.cells) {
      nearest_m = std::min(nearest_m, (model.grid.centre(cell) - p_WT).norm());
    }
    CHECK(nearest_m < model.grid.cell_m);
  }
}

TEST_CASE("the way is found when the edit is committed, and is the same without the model") {
  const testing::ScratchFolder folder;
  std::uint64_t hash = 0;
  {
    ProjectFile file = testing::created(folder / "p.trocar");
    const auto entry = testing::made_model();
    const demonstration::Demonstration jumps = jumping(*entry->model);
    const auto recording = file.store_recording(*jumps.recording, jumps.recorded);
    REQUIRE(recording);
    const DemonstrationId id{file.commit(AddDemonstration{*recording, "Jump"}).value()};
    const Edit edit = EditDemonstration{id, by_policy(0.5, 2.5)};
    CHECK(file.commit(edit).error().text() == "the project has no model of segment A");
    ModelEntry stored = *entry;
    stored.demonstrations.clear();
    const std::int64_t model = file.add_model(stored, Progress()).value();
    REQUIRE(file.commit(edit));
    const auto& made = std::get<Bridge>(*file.project()->demonstrations.at(id)->stack->back().edit);
    CHECK(made.model == model);
    CHECK(made.via_m.size() > 4);
    REQUIRE(file.commit(RemoveModel{ModelId{model}}));
    // Made anew from the recording, in another order, it still goes the same way.
    const std::int64_t bridge = file.project()->demonstrations.at(id)->stack->back().id;
    REQUIRE(file.commit(EnableStackEntry{id, bridge, false}));
    REQUIRE(file.commit(EnableStackEntry{id, bridge, true}));
    hash = file.project()->hash();
  }
  CHECK(testing::opened(folder / "p.trocar").project()->hash() == hash);
}

TEST_CASE("a policy that cannot be followed says why") {
  const auto entry = testing::made_model();
  const Project project = project_of(entry, jumping(*entry->model));
  const demonstration::Demonstration& document = *project.demonstrations.at({1});
  const auto error = [&](const Bridge& bridge, const demonstration::Demonstration& of) {
    const auto found = with_policy_way(bridge, of, project);
    return found ? std::string() : found.error().text();
  };
  CHECK(error(by_policy(0.5, 2.5, 9), document) == "the project has no model 9");
  CHECK(error(by_policy(1.5, 2.5), document).find("does not lead") != std::string::npos);
  demonstration::Demonstration unlabelled = document;
  unlabelled.segments.clear();
  CHECK(error(by_policy(0.5, 2.5), unlabelled).find("no segment is labelled at 0.50 s") == 0);
}

TEST_CASE("a batch of bridges by policy holds the way of each, and leaves out where none leads") {
  const auto entry = testing::made_model();
  Project project = project_of(entry, jumping(*entry->model));
  demonstration::Demonstration unlabelled = *project.demonstrations.at({1});
  unlabelled.id = {2};
  unlabelled.segments.clear();
  project.demonstrations[{2}] = std::make_shared<const demonstration::Demonstration>(std::move(unlabelled));
  Progress progress;
  const auto plan = plan_batch({std::make_shared<const Project>(project),
                                {{1}, {2}},
                                {"bridge", "--from", "0.5", "--to", "2.5", "--arms", "left", "--shape", "policy"}},
                               progress);
  REQUIRE(plan->error.empty());
  REQUIRE(plan->lines.size() == 2);
  CHECK(plan->lines[0].problem.empty());
  CHECK(plan->lines[1].problem.find("no segment is labelled at 0.50 s") == 0);
  REQUIRE(plan->edit.edits.size() == 1);
  const auto& bridge = std::get<Bridge>(std::get<EditDemonstration>(plan->edit.edits[0]).edit);
  const Bridge alone = with_policy_way(by_policy(0.5, 2.5), *project.demonstrations.at({1}), project).value();
  CHECK(demonstration::to_json(bridge) == demonstration::to_json(alone));
}
