// The policy in the simulator: what it comes to there, the same on one thread and on two, and taken up again.
#include "engine/trial/physics_rollout.h"

#include <doctest/doctest.h>

#include "engine/learning/rollout.h"
#include "tests/support/lattice_demonstrations.h"

using namespace trocar;
using namespace trocar::trial;
using learning::Model;

namespace {

const Model& driven() {
  static const Model kModel = [] {
    learning::TrainOptions options;
    options.method = learning::Method::kExact;
    Progress progress;
    return learning::train(spatial::Grid{}, {testing::sample_demonstrations().front()}, options, progress).value();
  }();
  return kModel;
}

std::vector<spatial::CellIndex> few() {
  const auto all = learning::starts_around(driven(), 1);
  return {all[0], all[all.size() / 2], all[all.size() - 1], all[3]};
}

PhysicsRollouts run(const PhysicsOptions& options) {
  PhysicsRollouts rollouts(few().size());
  Progress progress;
  REQUIRE(run_physics(driven(), few(), options, rollouts, progress));
  return rollouts;
}

}  // namespace

TEST_CASE("where the tool meets nothing that it cannot reach, it goes as many cells as the exact rollout") {
  const auto policy = learning::greedy_policy(driven());
  for (const auto start : few()) {
    const PhysicsRollout physical = physics_rollout(driven(), policy, start, {});
    const learning::Rollout exact = learning::rollout(driven(), policy, start);
    if (physical.end != PhysicsEnd::kArrives) continue;
    CHECK(physical.steps == static_cast<int>(exact.cells.size()) - 1);
    CHECK(physical.length_m == doctest::Approx(exact.length_m).epsilon(0.02));
    CHECK(physical.duration_s > 0.0);
  }
  // From the expert's own start, at least.
  CHECK(physics_rollout(driven(), policy, driven().start, {}).end == PhysicsEnd::kArrives);
}

TEST_CASE("two threads give the bits of one") {
  PhysicsOptions options;
  options.threads = 1;
  const PhysicsRollouts serial = run(options);
  CHECK(finished(serial) == 4);
  options.threads = 2;
  CHECK(run(options) == serial);
  options.continuous = true;
  CHECK(run(options) != serial);
}

TEST_CASE("what was stopped goes on where it stood, through a file too, to the same end") {
  PhysicsOptions options;
  options.threads = 1;
  const PhysicsRollouts whole = run(options);
  PhysicsRollouts half = whole;
  half[1].reset();
  half[3].reset();
  const std::string csv = physics_csv(driven(), few(), options, half);
  auto kept = parse_physics_csv(csv, driven(), few(), options);
  REQUIRE(kept);
  CHECK(*kept == half);
  Progress progress;
  REQUIRE(run_physics(driven(), few(), options, *kept, progress));
  CHECK(*kept == whole);
  CHECK(physics_csv(driven(), few(), options, *kept) == physics_csv(driven(), few(), options, whole));
}

TEST_CASE("one that is cancelled at once runs nothing and is no error") {
  PhysicsRollouts rollouts(few().size());
  Progress progress;
  progress.cancel();
  CHECK(run_physics(driven(), few(), {}, rollouts, progress));
  CHECK(finished(rollouts) == 0);
}

TEST_CASE("a file of another seed or another table is refused, with its line") {
  PhysicsOptions options;
  PhysicsRollouts rollouts(few().size());
  rollouts[0] = PhysicsRollout{PhysicsEnd::kLoops, 3, 0, 0.5, 0.01, 0.0, 77};
  const std::string csv = physics_csv(driven(), few(), options, rollouts);
  PhysicsOptions other;
  other.seed = 2;
  CHECK(parse_physics_csv(csv, driven(), few(), other).error().text().find("line 2") != std::string::npos);
  CHECK(parse_physics_csv("i,j,k\n", driven(), few(), options).error().code() == ErrorCode::kCorrupt);
  CHECK(parse_physics_csv(csv + "1,2\n", driven(), few(), options).error().text().find("line 3") != std::string::npos);
}

TEST_CASE("what is perturbed changes rollouts, the same way for a seed on one thread and on two") {
  PhysicsOptions ideal;
  const PhysicsRollouts plain = run(ideal);
  for (const Perturbation& perturbed :
       {Perturbation{0.3, 0.0, 0.0}, Perturbation{0.0, 0.2, 0.0}, Perturbation{0.0, 0.0, 0.002}}) {
    PhysicsOptions options;
    options.perturbed = perturbed;
    options.time_limit_s = 10.0;
    options.threads = 1;
    const PhysicsRollouts serial = run(options);
    CHECK(serial != plain);
    options.threads = 2;
    CHECK(run(options) == serial);
    CHECK_FALSE(same_runs(options, ideal));
    const std::string csv = physics_csv(driven(), few(), options, serial);
    CHECK(parse_physics_csv(csv, driven(), few(), options).value() == serial);
    CHECK_FALSE(parse_physics_csv(csv, driven(), few(), ideal));
  }
}

TEST_CASE("a late view of the tool makes it overshoot: it comes by cells again and takes longer, if it arrives") {
  PhysicsOptions options;
  options.time_limit_s = 10.0;
  options.perturbed.delay_s = 0.25;
  const auto policy = learning::greedy_policy(driven());
  const PhysicsRollout late = physics_rollout(driven(), policy, driven().start, options);
  const PhysicsRollout ideal = physics_rollout(driven(), policy, driven().start, {});
  REQUIRE(ideal.end == PhysicsEnd::kArrives);
  CHECK((late.end == PhysicsEnd::kTimeUp || late.steps > ideal.steps));
}

TEST_CASE("rollouts of one block or segment are not those of another") {
  PhysicsOptions options;
  PhysicsOptions other = options;
  other.block = 3;
  CHECK_FALSE(same_runs(options, other));
  PhysicsRollouts rollouts(few().size());
  rollouts[0] = PhysicsRollout{PhysicsEnd::kLoops, 3, 0, 0.5, 0.01, 0.0, 77};
  CHECK_FALSE(parse_physics_csv(physics_csv(driven(), few(), options, rollouts), driven(), few(), other));
}

TEST_CASE("options out of range are refused") {
  PhysicsRollouts rollouts(few().size());
  Progress progress;
  PhysicsOptions options;
  options.threads = 0;
  CHECK_FALSE(run_physics(driven(), few(), options, rollouts, progress));
  options.threads = 1;
  options.perturbed.noise_m = 1.0;
  CHECK_FALSE(run_physics(driven(), few(), options, rollouts, progress));
  PhysicsRollouts fewer(1);
  CHECK_FALSE(run_physics(driven(), few(), {}, fewer, progress));
}
