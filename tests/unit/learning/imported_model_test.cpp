#include "engine/learning/imported_model.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "engine/learning/field.h"
#include "engine/learning/model_codec.h"
#include "engine/learning/policy.h"
#include "engine/learning/rollout.h"

using namespace trocar;
using namespace trocar::learning;

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

const spatial::Grid& small_grid() {
  static const spatial::Grid grid = spatial::Grid::with_cells(8);
  return grid;
}

CellSequence walked() {
  CellSequence cells;
  for (int x = 1; x < 6; ++x) cells.push_back(small_grid().index({x, 3, 4}));
  for (int z = 3; z > 1; --z) cells.push_back(small_grid().index({5, 3, z}));
  return cells;
}

Model learned_by(Method method) {
  TrainOptions options;
  options.method = method;
  options.safe_radius = 2;
  options.start_spread = 2;
  options.episodes = 500;
  Progress progress;
  return train(small_grid(), {walked()}, options, progress).value();
}

bool same(const std::vector<double>& a, const std::vector<double>& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (std::isnan(a[i]) != std::isnan(b[i])) return false;
    if (!std::isnan(a[i]) && a[i] != b[i]) return false;
  }
  return true;
}

bool same(const Model& a, const Model& b, Layer layer) {
  return same(field(a, layer).values, field(b, layer).values);
}

}  // namespace

TEST_CASE("a Q-table taken out of a model and imported again has the same fields and goes the same ways") {
  for (const Method method : {Method::kExact, Method::kEgMaxentPlus}) {
    const Model model = learned_by(method);
    const std::vector<double> table = table_of(model, TableKind::kQ);
    const Model again = imported_model(small_grid(), {walked()}, 2, TableKind::kQ, table).value();
    CHECK(again.options.method == Method::kImported);
    for (const Layer layer :
         {Layer::kQPlusX, Layer::kQMinusX, Layer::kQPlusY, Layer::kQMinusY, Layer::kQPlusZ, Layer::kQMinusZ,
          Layer::kMargin, Layer::kPolicy, Layer::kBasin, Layer::kSteps, Layer::kSafe, Layer::kExpert}) {
      CAPTURE(to_string(method));
      CAPTURE(to_string(layer));
      CHECK(same(model, again, layer));
    }
    CHECK(same(table_of(again, TableKind::kQ), table));
  }
}

TEST_CASE("the paper's method chooses among untried moves, too, and its imported Q-table goes the same ways") {
  const Model model = learned_by(Method::kEgMaxent);
  const std::vector<double> table = table_of(model, TableKind::kQ);
  const Model again = imported_model(small_grid(), {walked()}, 2, TableKind::kQ, table).value();
  for (const Layer layer : {Layer::kPolicy, Layer::kBasin, Layer::kSteps}) CHECK(same(model, again, layer));
}

TEST_CASE("of an imported Q-table V is the largest Q, 0 at the goal, and the reward is unknown") {
  std::vector<double> table(6 * 512, kNan);
  const std::size_t s = static_cast<std::size_t>(small_grid().index({2, 3, 4}).value);
  table[6 * s + 1] = -3.0;
  table[6 * s + 4] = -2.0;
  table[6 * s + 5] = -kInfinity;
  const Model model = imported_model(small_grid(), {walked()}, 2, TableKind::kQ, table).value();
  CHECK(model.value[s] == -2.0);
  CHECK(model.tried[s] == (1U << 1U | 1U << 4U));
  CHECK(greedy_policy(model)[s] == 4);
  CHECK(model.value[static_cast<std::size_t>(model.goal.value)] == 0.0);
  const std::vector<double> reward = field(model, Layer::kReward).values;
  CHECK(std::all_of(reward.begin(), reward.end(), [](double value) { return std::isnan(value); }));
}

TEST_CASE("imported rewards are the same field, and the agent takes the cheapest way") {
  const Model model = learned_by(Method::kExact);
  const std::vector<double> table = table_of(model, TableKind::kTheta);
  const Model again = imported_model(small_grid(), {walked()}, 2, TableKind::kTheta, table).value();
  CHECK(same(model, again, Layer::kReward));
  const Basin basin = learning::basin(again, greedy_policy(again));
  CHECK(basin.end[static_cast<std::size_t>(again.start.value)] == RolloutEnd::kArrives);

  std::vector<double> even(512, -1.0);
  const Model straight = imported_model(small_grid(), {walked()}, 2, TableKind::kTheta, even).value();
  // Seven cells, of which the goal is not paid for.
  CHECK(straight.value[static_cast<std::size_t>(straight.start.value)] == -6.0);
  // One cell that is not to be entered does not change what the others are worth.
  even[0] = -1e12;
  const Model warned = imported_model(small_grid(), {walked()}, 2, TableKind::kTheta, even).value();
  CHECK(greedy_policy(warned) == greedy_policy(straight));
  CHECK(warned.value[static_cast<std::size_t>(straight.start.value)] == -6.0);
}

TEST_CASE("where imported rewards are 0 the agent takes the shortest way, and never goes round") {
  std::vector<double> table(512, 0.0);
  const Model model = imported_model(small_grid(), {walked()}, 2, TableKind::kTheta, table).value();
  CHECK(same(field(model, Layer::kReward).values, table));
  const Basin ends = basin(model, greedy_policy(model));
  for (std::int32_t s = 0; s < 512; ++s) {
    if (!model.safe.contains({s})) continue;
    REQUIRE(ends.end[static_cast<std::size_t>(s)] == RolloutEnd::kArrives);
  }
  CHECK(ends.steps[static_cast<std::size_t>(model.start.value)] == walked().size() - 1);
  // Those of the paper's method are 0 wherever it never came.
  const Model paper = learned_by(Method::kEgMaxent);
  const Model again =
      imported_model(small_grid(), {walked()}, 2, TableKind::kTheta, table_of(paper, TableKind::kTheta)).value();
  const Basin of_paper = basin(again, greedy_policy(again));
  CHECK(std::count(of_paper.end.begin(), of_paper.end.end(), RolloutEnd::kLoops) == 0);
}

TEST_CASE("how often an imported table's cells were visited, and what was tried in them, nobody knows") {
  const Model model =
      imported_model(small_grid(), {walked()}, 2, TableKind::kTheta, std::vector<double>(512, -1.0)).value();
  for (const Layer layer : {Layer::kVisits, Layer::kExplored}) {
    const std::vector<double> values = field(model, layer).values;
    CHECK(std::all_of(values.begin(), values.end(), [](double value) { return std::isnan(value); }));
  }
}

TEST_CASE("where rewards are unknown the agent has no way") {
  std::vector<double> table(512, -1.0);
  for (int y = 0; y < 8; ++y) {
    for (int z = 0; z < 8; ++z) table[static_cast<std::size_t>(small_grid().index({3, y, z}).value)] = kNan;
  }
  const Model model = imported_model(small_grid(), {walked()}, 2, TableKind::kTheta, table).value();
  CHECK(std::isinf(model.value[static_cast<std::size_t>(model.start.value)]));
  CHECK(std::isnan(field(model, Layer::kReward).values[static_cast<std::size_t>(small_grid().index({3, 3, 4}).value)]));
}

TEST_CASE("tables that cannot be are refused with what is wrong") {
  const auto refusal = [](TableKind kind, const std::vector<double>& table) {
    const auto made = imported_model(small_grid(), {walked()}, 2, kind, table);
    REQUIRE_FALSE(made);
    CHECK(made.error().code() == ErrorCode::kInvalidArgument);
    return made.error().text();
  };
  CHECK(refusal(TableKind::kQ, std::vector<double>(512, 0.0)).find("needs 3072") != std::string::npos);
  CHECK(refusal(TableKind::kQ, std::vector<double>(3072, kNan)).find("all is NaN") != std::string::npos);
  std::vector<double> rewards(512, -1.0);
  rewards[10] = 0.5;
  CHECK(refusal(TableKind::kTheta, rewards).find("0.5 in cell (0, 1, 2)") != std::string::npos);
  rewards[10] = -kInfinity;
  CHECK(refusal(TableKind::kTheta, rewards).find("infinite") != std::string::npos);
}

TEST_CASE("an imported model is stored and read again, and cannot be trained") {
  std::vector<double> table(512, -1.0);
  table[7] = kNan;
  const Model model = imported_model(small_grid(), {walked()}, 2, TableKind::kTheta, table).value();
  const Model read = decode_model(encode_model(model)).value();
  CHECK(read.hash() == model.hash());
  Progress progress;
  CHECK(train(small_grid(), {walked()}, model.options, progress).error().code() == ErrorCode::kInvalidArgument);
  CHECK(method_from("imported").error().code() == ErrorCode::kInvalidArgument);
}
