#include "engine/learning/learning_history.h"

#include <doctest/doctest.h>

#include <cmath>

#include "engine/learning/field.h"
#include "tests/support/lattice_demonstrations.h"

using namespace trocar;
using namespace trocar::learning;

namespace {

Model played(Method method, int episodes = 1000) {
  TrainOptions options;
  options.method = method;
  options.episodes = episodes;
  Progress progress;
  return train(spatial::Grid{}, {testing::sample_demonstrations()[1]}, options, progress).value();
}

Model at(const Model& model, int epoch) {
  Progress progress;
  return model_at_epoch(model, epoch, progress).value();
}

}  // namespace

TEST_CASE("an epoch of a sampled training is what a training that ends there gives") {
  for (const Method method : {Method::kEgMaxent, Method::kEgMaxentPlus}) {
    const Model model = played(method);
    CHECK(epoch_count(model) == 10);
    const Model shorter = played(method, 300);
    const Model early = at(model, 3);
    CHECK(early.theta == shorter.theta);
    CHECK(early.q == shorter.q);
    CHECK(early.visits == shorter.visits);
    CHECK(early.curve == shorter.curve);
  }
}

TEST_CASE("the last epoch is the model itself, and beyond it there is none") {
  for (const Method method : {Method::kEgMaxent, Method::kEgMaxentPlus, Method::kExact}) {
    const Model model = played(method);
    CHECK(at(model, epoch_count(model)).hash() == model.hash());
    CHECK(at(model, 1000000).hash() == model.hash());
    CHECK(at(model, -5).curve.empty());
  }
}

TEST_CASE("the iterations of the exact method begin as the training began, and come nearer to its end") {
  const Model model = played(Method::kExact);
  REQUIRE(epoch_count(model) > 3);
  double before = 1e9;
  for (int epoch = 1; epoch < epoch_count(model); epoch += 2) {
    const Model early = at(model, epoch);
    REQUIRE(epoch_count(early) == epoch);
    for (int i = 0; i < epoch; ++i) {
      CHECK(early.curve[static_cast<std::size_t>(i)] == model.curve[static_cast<std::size_t>(i)]);
    }
    double apart = 0.0;
    for (std::size_t s = 0; s < model.theta.size(); ++s) apart += std::abs(early.theta[s] - model.theta[s]);
    CHECK(apart < before);
    before = apart;
  }
}

TEST_CASE("the layer of change holds what the last epoch added to the reward") {
  const Model model = played(Method::kEgMaxent);
  const Field change = field(model, Layer::kThetaChange);
  const Model before = at(model, 9);
  int changed = 0;
  for (std::size_t s = 0; s < change.values.size(); ++s) {
    if (std::isnan(change.values[s])) continue;
    REQUIRE(change.values[s] == model.theta[s] - before.theta[s]);
    changed += change.values[s] != 0.0 ? 1 : 0;
  }
  CHECK(changed > 10);
}

TEST_CASE("playing the learning can be stopped") {
  const Model model = played(Method::kEgMaxent);
  Progress progress;
  progress.cancel();
  CHECK(model_at_epoch(model, 5, progress).error().code() == ErrorCode::kCancelled);
}
