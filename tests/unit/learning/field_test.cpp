#include "engine/learning/field.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/learning/rollout.h"
#include "tests/support/lattice_demonstrations.h"

using namespace trocar;
using namespace trocar::learning;

namespace {

Model trained(Method method) {
  TrainOptions options;
  options.method = method;
  options.episodes = 1000;
  Progress progress;
  return train(spatial::Grid{}, {testing::sample_demonstrations()[0]}, options, progress).value();
}

}  // namespace

TEST_CASE("the value of a cell is shown where an action that was tried has it, and not where the agent only hopes") {
  const Model model = trained(Method::kEgMaxent);
  const Field value = field(model, Layer::kValue);
  int hoped = 0;
  for (std::size_t s = 0; s < value.values.size(); ++s) {
    if (static_cast<std::int32_t>(s) == model.goal.value) continue;
    double best = -std::numeric_limits<double>::infinity();
    for (std::size_t a = 0; a < spatial::kActionCount; ++a) {
      if ((model.tried[s] >> a & 1) != 0) best = std::max(best, model.q[s * spatial::kActionCount + a]);
    }
    const bool known = std::isfinite(value.values[s]);
    CHECK(known == known_value(model, Layer::kValue, spatial::CellIndex{static_cast<std::int32_t>(s)}).has_value());
    if (known) CHECK(value.values[s] == best);
    hoped += !known && model.tried[s] != 0 ? 1 : 0;
  }
  CHECK(hoped > 0);
  CHECK(value.values[static_cast<std::size_t>(model.goal.value)] == 0.0);
}

TEST_CASE("every layer of every method has one value for each cell, a title, and names where it is categorical") {
  for (const Method method : {Method::kEgMaxent, Method::kEgMaxentPlus, Method::kExact}) {
    const Model model = trained(method);
    for (const Layer layer : all_layers()) {
      const Field shown = field(model, layer);
      CAPTURE(to_string(layer));
      REQUIRE(shown.values.size() == 10648);
      CHECK_FALSE(shown.title.empty());
      CHECK(std::isfinite(shown.low()));
      CHECK(shown.low() <= shown.high());
      CHECK(shown.categorical == !shown.categories.empty());
      if (shown.categorical) CHECK(shown.high() < static_cast<double>(shown.categories.size()));
      for (const double value : shown.values) REQUIRE_FALSE(std::isinf(value));
    }
  }
}

TEST_CASE("what the paper's method never visited is unknown in the layers it learns") {
  const Model model = trained(Method::kEgMaxent);
  for (const Layer layer : {Layer::kValue, Layer::kQPlusX, Layer::kMargin, Layer::kPolicy}) {
    const Field shown = field(model, layer);
    for (std::size_t s = 0; s < shown.values.size(); ++s) {
      if (model.visits[s] == 0) REQUIRE(std::isnan(shown.values[s]));
    }
  }
}

TEST_CASE("an action that was not tried has no Q to show") {
  const Model model = trained(Method::kEgMaxent);
  const Field down = field(model, Layer::kQMinusZ);
  for (std::size_t s = 0; s < down.values.size(); ++s) {
    REQUIRE(std::isnan(down.values[s]) == ((model.tried[s] >> 5 & 1) == 0));
  }
}

TEST_CASE("layers agree with the functions they show") {
  const Model model = trained(Method::kExact);
  const Basin all = basin(model, greedy_policy(model));
  const Field outcome = field(model, Layer::kBasin);
  const Field steps = field(model, Layer::kSteps);
  for (std::size_t s = 0; s < all.end.size(); ++s) {
    REQUIRE(outcome.values[s] == static_cast<double>(all.end[s]));
    REQUIRE(steps.values[s] == all.steps[s]);
  }
  CHECK(field(model, Layer::kVisits).values[static_cast<std::size_t>(model.goal.value)] == 1.0);
}

TEST_CASE("explored classes are counted of a method that tries actions, and unknown of one that does not") {
  const Model paper = trained(Method::kEgMaxent);
  const Field explored = field(paper, Layer::kExplored);
  const auto fully = std::count(explored.values.begin(), explored.values.end(), 2.0);
  CHECK(fully > 0);
  CHECK(fully == exploration(paper).fully_explored);
  const Field exact = field(trained(Method::kExact), Layer::kExplored);
  CHECK(std::all_of(exact.values.begin(), exact.values.end(), [](double value) { return std::isnan(value); }));
}

TEST_CASE("the margin is the best known Q less the second") {
  const Model model = trained(Method::kExact);
  const Field margin = field(model, Layer::kMargin);
  const auto s = static_cast<std::size_t>(model.start.value);
  std::vector<double> q(model.q.begin() + static_cast<std::ptrdiff_t>(6 * s),
                        model.q.begin() + static_cast<std::ptrdiff_t>(6 * s + 6));
  std::sort(q.rbegin(), q.rend());
  CHECK(margin.values[s] == q[0] - q[1]);
}

TEST_CASE("layers have their names in both directions, and an unknown name lists them") {
  CHECK(all_layers().size() == 18);
  for (const Layer layer : all_layers()) CHECK(layer_from(to_string(layer)).value() == layer);
  CHECK(layer_from("q-z").value() == Layer::kQMinusZ);
  CHECK(layer_from("height").error().text().find("margin") != std::string::npos);
}

TEST_CASE("a field that knows nothing ranges from 0 to 1") {
  Field nothing;
  nothing.values.assign(8, std::nan(""));
  CHECK(nothing.low() == 0.0);
  CHECK(nothing.high() == 1.0);
}

TEST_CASE("one cell of a layer is what the layer has there") {
  for (const Method method : {Method::kEgMaxent, Method::kEgMaxentPlus, Method::kExact}) {
    TrainOptions options;
    options.method = method;
    options.episodes = 1000;
    Progress progress;
    const Model model =
        train(spatial::Grid{}, {trocar::testing::sample_demonstrations()[1]}, options, progress).value();
    for (const Layer layer : {Layer::kReward, Layer::kValue, Layer::kQPlusX, Layer::kQMinusX, Layer::kQPlusY,
                              Layer::kQMinusY, Layer::kQPlusZ, Layer::kQMinusZ}) {
      CAPTURE(to_string(layer));
      const Field whole = field(model, layer);
      for (std::size_t s = 0; s < whole.values.size(); ++s) {
        const auto value = known_value(model, layer, {static_cast<std::int32_t>(s)});
        REQUIRE(value.has_value() == std::isfinite(whole.values[s]));
        if (value) CHECK(*value == whole.values[s]);
      }
    }
  }
}
