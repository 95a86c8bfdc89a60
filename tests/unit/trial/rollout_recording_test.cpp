// A rollout as something that can be seen: what is recorded is the run that the tables tell of.
#include "engine/trial/rollout_recording.h"

#include <doctest/doctest.h>

#include "engine/demonstration/demonstration.h"
#include "engine/learning/rollout.h"
#include "tests/support/lattice_demonstrations.h"

using namespace trocar;
using namespace trocar::trial;

namespace {

const learning::Model& filmed_model() {
  static const learning::Model kModel = [] {
    learning::TrainOptions options;
    options.method = learning::Method::kExact;
    Progress progress;
    return learning::train(spatial::Grid{}, {testing::sample_demonstrations().front()}, options, progress).value();
  }();
  return kModel;
}

RecordedRollout recorded_from(spatial::CellIndex start) {
  Progress progress;
  const auto recorded = record_rollout(filmed_model(), start, {}, progress);
  REQUIRE_MESSAGE(recorded, (recorded ? "" : recorded.error().text()));
  return *recorded;
}

}  // namespace

TEST_CASE("the recording begins in the start, ends in the goal, and is of the rollout that runs without it") {
  const learning::Model& model = filmed_model();
  const RecordedRollout recorded = recorded_from(model.start);
  CHECK(recorded.result == physics_rollout(model, learning::greedy_policy(model), model.start, {}));
  REQUIRE(recorded.result.end == PhysicsEnd::kArrives);
  const std::vector<demonstration::Sample>& samples = recorded.recording->samples;
  // Half a second is seen after its end.
  CHECK(samples.back().t_s() == doctest::Approx(recorded.result.duration_s + 0.5).epsilon(1e-9));
  CHECK(samples.front().tick == 0);
  const auto cell = [&](const demonstration::Sample& sample) {
    return model.grid.cell_at(sample.arms[0].measured.pose().p).value();
  };
  CHECK(cell(samples.front()) == model.start);
  CHECK(cell(samples.back()) == model.goal);
  for (const demonstration::Sample& sample : samples) CHECK(sample.authority == demonstration::Authority::kAgent);
  CHECK(recorded.recording->provenance.operator_kind == "agent");
  CHECK(demonstration::make_demonstration({1}, "rollout", recorded.recording));
}

TEST_CASE("recorded twice it is the same, and one that begins in the goal stands still") {
  const learning::Model& model = filmed_model();
  const RecordedRollout first = recorded_from(model.start);
  const RecordedRollout again = recorded_from(model.start);
  REQUIRE(first.recording->samples.size() == again.recording->samples.size());
  CHECK(first.recording->samples.back().arms[0].joints == again.recording->samples.back().arms[0].joints);
  CHECK(first.result == again.result);
  const RecordedRollout still = recorded_from(model.goal);
  CHECK(still.result.steps == 0);
  CHECK(still.recording->samples.size() > 2);
}

TEST_CASE("a rollout of C has the block in its jaws from the first sample on") {
  learning::TrainOptions training;
  training.method = learning::Method::kExact;
  const spatial::Grid grid;
  Progress progress;
  // Sideways at the height of a carried block.
  const auto model =
      learning::train(grid, {testing::approach_from_above(grid, {9, 8, 14}, {11, 9, 12}, 3, 1)}, training, progress);
  REQUIRE_MESSAGE(model, (model ? "" : model.error().text()));
  PhysicsOptions options;
  options.segment = demonstration::Segment::kC;
  const auto recorded = record_rollout(*model, model->start, options, progress);
  REQUIRE_MESSAGE(recorded, (recorded ? "" : recorded.error().text()));
  CHECK((recorded->recording->samples.front().flags & demonstration::kLeftHolds) != 0);
  CHECK(recorded->recording->samples.front().segment == demonstration::Segment::kC);
}
