#include "engine/workbench/seed_insight.h"

#include <doctest/doctest.h>

#include <cmath>

#include "tests/support/lattice_demonstrations.h"

using namespace trocar;
using namespace trocar::workbench;

namespace {

std::shared_ptr<const ModelEntry> trained(learning::Method method, double epsilon) {
  learning::TrainOptions options;
  options.method = method;
  options.epsilon = epsilon;
  options.episodes = 1000;
  options.seed = 5;
  Progress progress;
  auto entry = std::make_shared<ModelEntry>();
  entry->model = std::make_shared<const learning::Model>(
      learning::train(spatial::Grid{}, {testing::sample_demonstrations().front()}, options, progress).value());
  return entry;
}

}  // namespace

TEST_CASE("a model is the first of its seeds, and its field lies within what they spread over") {
  const auto entry = trained(learning::Method::kEgMaxent, 0.1);
  const auto seeds = seed_insight({entry, learning::Layer::kReward, 4});
  REQUIRE(seeds);
  CHECK(seeds->error.empty());
  REQUIRE(seeds->seeds.size() == 4);
  CHECK(seeds->seeds[0].seed == 5);
  CHECK(seeds->seeds[3].seed == 8);
  CHECK(seeds->seeds[0].mismatch == entry->model->curve.back());
  CHECK(seeds->findings.size() == 3);
  CHECK(seeds->exploration.pairs.size() == 4);
  // Of n values none is farther from their mean than sqrt(n - 1) standard deviations.
  const auto field = learning::field(*entry->model, learning::Layer::kReward);
  int compared = 0;
  for (std::size_t s = 0; s < field.values.size(); ++s) {
    if (!std::isfinite(field.values[s]) || !std::isfinite(seeds->spread->values[s])) continue;
    ++compared;
    CHECK(std::abs(field.values[s] - seeds->mean->values[s]) <= 2.0 * seeds->spread->values[s] + 1e-9);
  }
  CHECK(compared > 100);
}

TEST_CASE("beside a model that does not explore stands the paper's ε, and the exact method has no seeds") {
  const auto greedy = seed_insight({trained(learning::Method::kEgMaxent, 0.0), learning::Layer::kReward, 2});
  CHECK(greedy->exploration.epsilon == 0.1);
  const auto exact = seed_insight({trained(learning::Method::kExact, 0.0), learning::Layer::kReward, 2});
  CHECK(exact->error.find("every seed gives this model") != std::string::npos);
  CHECK(exact->mean == nullptr);
  CHECK(seed_insight({}) == nullptr);
}
