#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "engine/learning/model.h"
#include "engine/learning/rollout.h"
#include "tests/support/lattice_demonstrations.h"

using namespace trocar;
using namespace trocar::learning;
using trocar::testing::sample_demonstrations;

namespace {

TrainOptions exact() {
  TrainOptions options;
  options.method = Method::kExact;
  return options;
}

Model trained(const CellSequence& expert, const TrainOptions& options = exact()) {
  Progress progress;
  return train(spatial::Grid{}, {expert}, options, progress).value();
}

}  // namespace

TEST_CASE("an exact model arrives from all 10,648 cells") {
  for (const CellSequence& expert : sample_demonstrations()) {
    const Model model = trained(expert);
    const Basin all = basin(model, greedy_policy(model));
    CHECK(std::count(all.end.begin(), all.end.end(), RolloutEnd::kArrives) == 10648);
  }
}

TEST_CASE("an exact model approaches from above, as it was shown") {
  for (const CellSequence& expert : sample_demonstrations()) {
    const Model model = trained(expert);
    const RolloutSummary near = summarise(basin(model, greedy_policy(model)), starts_around(model, 3));
    CHECK(near.from_above >= 0.95 * near.count);
  }
}

TEST_CASE("an exact model has the same bytes on every run") {
  const CellSequence expert = sample_demonstrations()[4];
  CHECK(trained(expert).hash() == trained(expert).hash());
}
