#include "engine/learning/training_input.h"

#include <doctest/doctest.h>

#include <functional>
#include <limits>
#include <string>

#include "tests/support/lattice_demonstrations.h"

using namespace trocar;
using namespace trocar::learning;

namespace {

const spatial::Grid kGrid;

std::string refusal(const std::vector<CellSequence>& experts, const TrainOptions& options = {}) {
  Progress progress;
  const auto model = train(kGrid, experts, options, progress);
  REQUIRE_FALSE(model.has_value());
  CHECK(model.error().code() == ErrorCode::kInvalidArgument);
  return model.error().text();
}

bool mentions(const std::string& text, const char* word) {
  return text.find(word) != std::string::npos;
}

}  // namespace

TEST_CASE("each option out of its range is refused by name") {
  const std::vector<CellSequence> experts{testing::sample_demonstrations()[0]};
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto refused = [&](const std::function<void(TrainOptions&)>& spoil) {
    TrainOptions options;
    spoil(options);
    return refusal(experts, options);
  };
  CHECK(mentions(refused([](TrainOptions& o) { o.theta_rate = -0.3; }), "θ learning rate"));
  CHECK(mentions(refused([&](TrainOptions& o) { o.q_rate = nan; }), "Q learning rate"));
  CHECK(mentions(refused([](TrainOptions& o) { o.discount = 1.01; }), "discount"));
  CHECK(mentions(refused([](TrainOptions& o) { o.epsilon = -1e-9; }), "epsilon"));
  CHECK(mentions(refused([](TrainOptions& o) { o.episodes = 0; }), "episodes"));
  CHECK(mentions(refused([](TrainOptions& o) { o.episodes = 2'000'000'000; }), "episodes"));
  CHECK(mentions(refused([](TrainOptions& o) { o.safe_radius = -1; }), "safe radius"));
  CHECK(mentions(refused([](TrainOptions& o) { o.start_spread = -1; }), "start spread"));
  CHECK(mentions(refused([](TrainOptions& o) { o.theta_prior = 0.0; }), "prior"));
  CHECK(mentions(refused([&](TrainOptions& o) { o.regularisation = nan; }), "regularisation"));
}

TEST_CASE("no expert, one cell, cells apart, cells off the lattice and a closed path are each refused") {
  CHECK(mentions(refusal({}), "no expert"));
  CHECK(mentions(refusal({{{5}}}), "at least 2"));
  CHECK(mentions(refusal({{{5}, {7}}}), "not neighbours"));
  CHECK(mentions(refusal({{{5}, {5}}}), "not neighbours"));
  CHECK(mentions(refusal({{{-1}, {0}}}), "not on the lattice"));
  CHECK(mentions(refusal({{{10647}, {10648}}}), "not on the lattice"));
  CHECK(mentions(refusal({{{5}, {6}, {5}}}), "ends where it starts"));
  // 21 and 22 have consecutive numbers but lie at opposite faces.
  CHECK(mentions(refusal({{{21}, {22}}}), "not neighbours"));
}

TEST_CASE("a second expert that ends elsewhere is refused, within the safe radius it is accepted") {
  const CellSequence first = testing::approach_from_above(kGrid, {11, 12, 19}, {6, 10, 10}, 4, 1);
  const CellSequence near = testing::approach_from_above(kGrid, {11, 12, 19}, {6, 12, 10}, 4, 2);
  const CellSequence far = testing::approach_from_above(kGrid, {11, 12, 19}, {15, 12, 10}, 4, 2);
  CHECK(mentions(refusal({first, far}), "ends 9 cells from the goal"));
  CHECK(check_training(kGrid, {first, near}, TrainOptions{}).has_value());
}

TEST_CASE("a cancelled training returns kCancelled in every method") {
  for (const Method method : {Method::kEgMaxent, Method::kEgMaxentPlus, Method::kExact}) {
    TrainOptions options;
    options.method = method;
    Progress progress;
    progress.cancel();
    const auto model = train(kGrid, {testing::sample_demonstrations()[0]}, options, progress);
    REQUIRE_FALSE(model.has_value());
    CHECK(model.error().code() == ErrorCode::kCancelled);
  }
}

TEST_CASE("a finished training has reported its whole progress") {
  for (const Method method : {Method::kEgMaxent, Method::kEgMaxentPlus, Method::kExact}) {
    TrainOptions options;
    options.method = method;
    options.episodes = 300;
    Progress progress;
    CHECK(train(kGrid, {testing::sample_demonstrations()[0]}, options, progress).has_value());
    CHECK(progress.fraction() == 1.0);
  }
}

TEST_CASE("methods have their names in both directions") {
  for (const Method method : {Method::kEgMaxent, Method::kEgMaxentPlus, Method::kExact}) {
    CHECK(method_from(to_string(method)).value() == method);
  }
  CHECK_FALSE(method_from("Exact").has_value());
}
