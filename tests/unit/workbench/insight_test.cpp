#include "engine/workbench/insight.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "engine/demonstration/edits.h"
#include "engine/workbench/jobs/train_job.h"
#include "tests/support/recorded_transfer.h"

using namespace trocar;
using namespace trocar::workbench;

namespace {

std::shared_ptr<const demonstration::Demonstration> expert() {
  static const auto shown = std::make_shared<const demonstration::Demonstration>(testing::transfer(1));
  return shown;
}

std::shared_ptr<const ModelEntry> learned(learning::Method method, double epsilon = 0.1, int id = 7) {
  Project project;
  project.demonstrations[expert()->id] = expert();
  TrainModel request;
  request.demonstrations = {expert()->id};
  request.options.method = method;
  request.options.epsilon = epsilon;
  request.options.episodes = 1000;
  Progress progress;
  ModelEntry entry = train_model(project, request, progress).value();
  entry.id = {id};
  return std::make_shared<const ModelEntry>(std::move(entry));
}

/// A waypoint of the approach moved aside by `mm`.
std::shared_ptr<const demonstration::Demonstration> moved(double mm) {
  demonstration::MoveTool move;
  const auto span = expert()->segment(demonstration::Segment::kA);
  move.at_s = 0.5 * (span->begin_s + span->end_s);
  move.by_m = {0.0, 1e-3 * mm, 0.0};
  return std::make_shared<const demonstration::Demonstration>(demonstration::transformed(*expert(), move, 0).value());
}

}  // namespace

TEST_CASE("an exact model follows its demonstration as one that is trained on it anew") {
  const auto entry = learned(learning::Method::kExact);
  InsightMaker maker;
  InsightRequest request;
  request.entry = entry;
  request.experts = {moved(5.0)};
  const auto followed = maker.make(request);
  REQUIRE(followed->following);
  CHECK(followed->following->error.empty());
  CHECK(followed->following->cells_changed > 0);
  CHECK(followed->following->policy_changed > 0);
  const auto experts = expert_cells(request.experts, entry->segment, entry->model->grid).value();
  Progress progress;
  const learning::Model anew = learning::train(entry->model->grid, experts, entry->model->options, progress).value();
  const learning::Model& warm = *followed->entry->model;
  CHECK(warm.experts == anew.experts);
  double worst = 0.0;
  for (std::size_t s = 0; s < warm.theta.size(); ++s) worst = std::max(worst, std::abs(warm.theta[s] - anew.theta[s]));
  CHECK(worst < 0.05);
  CHECK(followed->all.arrived == 10648);
  // The stored one is untouched, and shown again when the edit is taken back.
  request.experts = {expert()};
  const auto back = maker.make(request);
  CHECK(back->entry == entry);
  CHECK(back->following->cells_changed == 0);
}

TEST_CASE("what cannot be followed shows the stored model and says why") {
  const auto entry = learned(learning::Method::kExact);
  InsightMaker maker;
  InsightRequest request;
  request.entry = entry;
  request.experts = {nullptr};
  const auto insight = maker.make(request);
  CHECK(insight->entry == entry);
  REQUIRE(insight->following);
  CHECK(insight->following->error.find("is gone") != std::string::npos);
}

TEST_CASE("a model is shown at an epoch of its training, and at its end by default") {
  const auto entry = learned(learning::Method::kEgMaxent);
  InsightMaker maker;
  InsightRequest request;
  request.entry = entry;
  CHECK(maker.make(request)->epoch == 10);
  request.epoch = 2;
  const auto early = maker.make(request);
  CHECK(early->epoch == 2);
  CHECK(early->epochs == 10);
  CHECK(early->entry->model->curve.size() == 2);
  request.epoch = -1;
  CHECK(early->exploration.fully_unexplored > maker.make(request)->exploration.fully_unexplored);
}

TEST_CASE("beside a second model stand its field, the difference, the outcomes and the measures") {
  const auto a = learned(learning::Method::kEgMaxent, 0.0, 7);
  const auto b = learned(learning::Method::kEgMaxent, 0.1, 8);
  InsightMaker maker;
  InsightRequest request;
  request.entry = a;
  request.second = b;
  const auto insight = maker.make(request);
  REQUIRE(insight->second);
  CHECK(insight->second->entry == b);
  CHECK(insight->second->comparison->policy_changed > 0);
  CHECK(insight->second->difference->title.find("B \u2212 A") != std::string::npos);
  CHECK(insight->second->outcomes->categorical);
  request.second = nullptr;
  CHECK_FALSE(maker.make(request)->second);
}

TEST_CASE("starts that are none are said, and nothing is rolled out") {
  InsightMaker maker;
  InsightRequest request;
  request.entry = learned(learning::Method::kExact);
  request.rollouts.starts = "around:99";
  const auto insight = maker.make(request);
  CHECK_FALSE(insight->starts_error.empty());
  CHECK(insight->ghosts.empty());
  request.rollouts.starts = "face:z1";
  CHECK(maker.make(request)->chosen.count == 22 * 22);
}

TEST_CASE("every layer of a model has a field, the pegs too") {
  const auto entry = learned(learning::Method::kExact);
  for (const learning::Layer layer : learning::all_layers()) {
    if (layer == learning::Layer::kExplored) continue;  // It tries no action.
    CAPTURE(learning::to_string(layer));
    const learning::Field field = field_of(*entry->model, layer);
    CHECK(std::any_of(field.values.begin(), field.values.end(), [](double v) { return std::isfinite(v); }));
  }
  const learning::Field pegs = field_of(*entry->model, learning::Layer::kObstacles);
  const auto count = std::count(pegs.values.begin(), pegs.values.end(), 1.0);
  CHECK(count > 100);
  CHECK(count < 2000);
}
