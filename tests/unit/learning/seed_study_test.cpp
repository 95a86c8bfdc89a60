#include "engine/learning/seed_study.h"

#include <doctest/doctest.h>

#include <cmath>

#include "tests/support/lattice_demonstrations.h"

using namespace trocar;
using namespace trocar::learning;

namespace {

TrainOptions short_training(Method method) {
  TrainOptions options;
  options.method = method;
  options.episodes = 1500;
  return options;
}

const std::vector<CellSequence>& expert() {
  static const std::vector<CellSequence> cells{testing::sample_demonstrations()[3]};
  return cells;
}

}  // namespace

TEST_CASE("a study of seeds is the trainings with these seeds, on one and two threads") {
  const TrainOptions options = short_training(Method::kEgMaxent);
  Progress progress;
  const SeedStudy one = study_seeds({}, expert(), options, Layer::kReward, {5, 4, 1}, progress).value();
  const SeedStudy two = study_seeds({}, expert(), options, Layer::kReward, {5, 4, 2}, progress).value();
  REQUIRE(one.seeds.size() == 4);
  std::vector<Field> fields;
  for (std::size_t i = 0; i < 4; ++i) {
    TrainOptions own = options;
    own.seed = 5 + i;
    const Model model = train({}, expert(), own, progress).value();
    CHECK(one.seeds[i].seed == own.seed);
    CHECK(one.seeds[i].exploration.fully_explored == exploration(model).fully_explored);
    CHECK(two.seeds[i].all.arrived == one.seeds[i].all.arrived);
    fields.push_back(field(model, Layer::kReward));
  }
  for (std::size_t s = 0; s < one.mean.values.size(); ++s) {
    double sum = 0.0;
    int known = 0;
    for (const Field& each : fields) {
      if (!std::isfinite(each.values[s])) continue;
      sum += each.values[s];
      ++known;
    }
    REQUIRE(std::isnan(one.mean.values[s]) == (known == 0));
    REQUIRE(std::isnan(one.spread.values[s]) == (known < 2));
    if (known > 0) REQUIRE(one.mean.values[s] == doctest::Approx(sum / known));
    if (known > 1) REQUIRE(one.spread.values[s] == two.spread.values[s]);
  }
}

TEST_CASE("of classes the commonest is shown, and how many seeds differ from it") {
  Progress progress;
  const SeedStudy study =
      study_seeds({}, expert(), short_training(Method::kEgMaxent), Layer::kExplored, {1, 5, 2}, progress).value();
  CHECK(study.mean.categorical);
  CHECK_FALSE(study.spread.categorical);
  for (std::size_t s = 0; s < study.mean.values.size(); ++s) {
    if (std::isnan(study.mean.values[s])) continue;
    REQUIRE(study.mean.values[s] == std::floor(study.mean.values[s]));
    REQUIRE(study.spread.values[s] >= 0.0);
    REQUIRE(study.spread.values[s] <= 0.81);
  }
}

TEST_CASE("section V.A: the sign of exploration holds for every seed, robustness does not") {
  TrainOptions options = short_training(Method::kEgMaxent);
  options.episodes = 10000;
  Progress progress;
  const EpsilonStudy study = study_epsilon({}, expert(), options, {1, 6, 2}, progress).value();
  CHECK(study.explored_rose == 6);
  CHECK(study.unexplored_fell == 6);
  CHECK(study.explored_mean > 0.0);
  CHECK(study.unexplored_mean < 0.0);
  CHECK(study.near_exploring < 0.5);
  const std::vector<std::string> sentences = findings(study);
  REQUIRE(sentences.size() == 3);
  CHECK(sentences[0].starts_with("Holds: more states"));
  CHECK(sentences[1].starts_with("Holds: fewer states"));
  CHECK(sentences[2].starts_with("Does not hold"));
}

TEST_CASE("a study that makes no sense is refused, and one that is cancelled ends") {
  Progress progress;
  const TrainOptions options = short_training(Method::kEgMaxent);
  CHECK_FALSE(study_seeds({}, expert(), options, Layer::kReward, {1, 1, 1}, progress));
  CHECK_FALSE(study_seeds({}, expert(), options, Layer::kReward, {1, 3, 0}, progress));
  CHECK_FALSE(study_epsilon({}, expert(), short_training(Method::kExact), {1, 3, 1}, progress));
  CHECK_FALSE(study_seeds({}, {{}}, options, Layer::kReward, {1, 3, 2}, progress));
  Progress cancelled;
  cancelled.cancel();
  CHECK(study_epsilon({}, expert(), options, {1, 3, 1}, cancelled).error().code() == ErrorCode::kCancelled);
}
