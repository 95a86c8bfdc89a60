// Two models beside each other, and the training panel with its curve.
#include <doctest/doctest.h>

#include <cmath>

#include "tests/support/ui_desk.h"

namespace trocar::ui {
namespace {

using testing::made_state_with_two_models;

}  // namespace

TEST_CASE("two models stand beside each other in every mode, and say in how many cells the policy changed") {
  for (const float scale : {0.75F, 1.0F, 2.0F}) {
    CAPTURE(scale);
    Desk desk(made_state_with_two_models(), scale);
    Driver driver = desk.driver();
    CHECK(driver.key("Ctrl+3"));
    CHECK(driver.frames(3));
    CHECK(text_of(driver.click("Tabs/Models")) == "");
    CHECK(driver.frames(3));
    for (const char* mode : {"Side by side", "Swipe", "Blink", "Difference", "Policy", "Outcomes"}) {
      CAPTURE(mode);
      CHECK(text_of(driver.click(std::string("Models/Mode/") + mode)) == "");
      CHECK(driver.frames(3));
      const Item* change = desk.session->items().find("Models/Policy change");
      REQUIRE(change != nullptr);
      const auto& comparison = *desk.state.insight->second->comparison;
      CHECK(change->value.find(std::to_string(comparison.policy_changed % 1000)) != std::string::npos);
    }
    CHECK(desk.session->items().find("Models/Measures/Arrive within ±3") != nullptr);
  }
}

TEST_CASE("the second model is chosen, and taken back") {
  Desk desk(made_state_with_two_models());
  Driver driver = desk.driver();
  CHECK(driver.key("Ctrl+3"));
  CHECK(driver.frames(3));
  CHECK(text_of(driver.click("Tabs/Models")) == "");
  CHECK(text_of(driver.click("Models/Model B")) == "");
  CHECK(driver.frames(2));
  CHECK(text_of(driver.click("Models/Model B/None")) == "");
  REQUIRE(desk.last<workbench::SetLearning>() != nullptr);
  CHECK(desk.last<workbench::SetLearning>()->settings.second.value == 0);
}

TEST_CASE("a training that runs shows its curve so far, and can be stopped") {
  Desk desk(made_state_with_two_models());
  Driver driver = desk.driver();
  CHECK(driver.key("Ctrl+3"));
  CHECK(driver.frames(3));
  CHECK(text_of(driver.click("Tabs/Train")) == "");
  CHECK(desk.session->items().find("Train/Running/Learning curve") == nullptr);
  workbench::TrainingView running{workbench::JobId{7}, "paper A 2", {0.9, 0.7, 0.65}, 100};
  desk.state.training = std::make_shared<const workbench::TrainingView>(running);
  desk.state.jobs = {testing::made_job(7, "Train paper A 2", workbench::JobState::kRunning, 0.03)};
  CHECK(driver.frames(3));
  const Item* curve = desk.session->items().find("Train/Running/Learning curve");
  REQUIRE(curve != nullptr);
  CHECK(curve->value == "epoch 3 of 100");
  CHECK(text_of(driver.click("Train/Running/Stop")) == "");
  REQUIRE(desk.last<workbench::CancelJob>() != nullptr);
  CHECK(desk.last<workbench::CancelJob>()->id == workbench::JobId{7});
  running.epochs = 0;  // of a method that ends when it has converged
  desk.state.training = std::make_shared<const workbench::TrainingView>(running);
  CHECK(driver.frames(2));
  CHECK(desk.session->items().find("Train/Running/Learning curve")->value == "epoch 3");
}

TEST_CASE("both models are asked for in the view, whose halves then say whose they are") {
  Desk desk(made_state_with_two_models());
  Driver driver = desk.driver();
  CHECK(driver.key("Ctrl+3"));
  CHECK(driver.frames(3));
  CHECK(text_of(driver.click("Tabs/Models")) == "");
  CHECK(text_of(driver.click("Models/Both models")) == "");
  REQUIRE(desk.last<workbench::SetLearning>() != nullptr);
  CHECK(desk.last<workbench::SetLearning>()->settings.second_in_view);
  desk.state.picture_models = {"exact A", "paper A"};
  CHECK(driver.frames(3));
  CHECK(text_of(driver.expect_value("View/Model of the left half", "A  exact A")) == "");
  CHECK(text_of(driver.expect_value("View/Model of the right half", "B  paper A")) == "");
}

TEST_CASE("other seeds stand beside a model with their mean, spread, table and what they say of section V.A") {
  workbench::WorkbenchState state = made_state_with_two_models();
  auto paper = std::make_shared<workbench::ModelEntry>(*state.project->models.at({4}));
  state.learning.seeds = 3;
  state.seeds = workbench::seed_insight({paper, learning::Layer::kReward, 3});
  for (const float scale : {0.75F, 1.0F, 2.0F}) {
    CAPTURE(scale);
    Desk desk(state, scale);
    Driver driver = desk.driver();
    CHECK(driver.key("Ctrl+3"));
    CHECK(driver.frames(3));
    CHECK(text_of(driver.click("Tabs/Models")) == "");
    CHECK(driver.frames(3));
    for (std::size_t i = 0; i < state.seeds->findings.size(); ++i) {
      CHECK(text_of(driver.expect_value("Models/Findings/" + std::to_string(i + 1), state.seeds->findings[i])) == "");
    }
    const auto& second = state.seeds->seeds[1];
    const Item* row = desk.session->items().find("Models/Seeds/" + std::to_string(second.seed));
    REQUIRE(row != nullptr);
    CHECK(row->value.find(std::to_string(second.exploration.fully_explored % 1000)) != std::string::npos);
    CHECK(text_of(driver.click("Models/Beside it/Another model")) == "");
    CHECK(desk.last<workbench::SetLearning>()->settings.seeds == 0);
  }
}

TEST_CASE("a preset fills in the parameters, and every one of them is trained with") {
  Desk desk(testing::made_state_with_model());
  Driver driver = desk.driver();
  CHECK(driver.key("Ctrl+3"));
  CHECK(driver.frames(3));
  CHECK(text_of(driver.click("Tabs/Train")) == "");
  CHECK(text_of(driver.click("Train/Preset/Paper")) == "");
  CHECK(driver.frames(2));
  CHECK(text_of(driver.click("Train/All parameters")) == "");
  CHECK(driver.frames(2));
  CHECK(text_of(driver.type("Train/Epsilon", "0.05")) == "");
  CHECK(text_of(driver.type("Train/Discount", "0.9")) == "");
  CHECK(text_of(driver.type("Train/Safe radius", "5")) == "");
  CHECK(text_of(driver.click("Train/Train")) == "");
  const auto* train = desk.last<workbench::TrainModel>();
  REQUIRE(train != nullptr);
  CHECK(train->options.method == learning::Method::kEgMaxent);
  CHECK(train->options.epsilon == 0.05);
  CHECK(train->options.discount == 0.9);
  CHECK(train->options.safe_radius == 5);
  CHECK(train->options.theta_rate == 0.3);
}

TEST_CASE("the learning is gone through epoch by epoch") {
  Desk desk(testing::made_state_with_model());
  Driver driver = desk.driver();
  CHECK(driver.key("Ctrl+3"));
  CHECK(driver.frames(3));
  CHECK(text_of(driver.click("Tabs/Train")) == "");
  CHECK(driver.frames(2));
  CHECK(text_of(driver.click("Train/Learning/Learning curve")) == "");
  REQUIRE(desk.last<workbench::SetLearning>() != nullptr);
  CHECK(desk.last<workbench::SetLearning>()->settings.epoch > 0);
  CHECK(desk.last<workbench::SetLearning>()->settings.epoch < desk.state.insight->epochs);
  CHECK(text_of(driver.click("Train/Learning/Play the learning")) == "");
  CHECK(driver.frames(3));
  CHECK(desk.last<workbench::SetLearning>()->settings.epoch >= 0);
}

TEST_CASE("the learning curve is exported from where it is drawn, by the command that draws it") {
  Desk desk(testing::made_state_with_model());
  Driver driver = desk.driver();
  CHECK(driver.key("Ctrl+3"));
  CHECK(driver.frames(3));
  CHECK(text_of(driver.click("Tabs/Train")) == "");
  CHECK(driver.frames(2));
  CHECK(text_of(driver.click("Train/Learning/Export curve…")) == "");
  CHECK(text_of(driver.click("Export figure/Kind of file/CSV")) == "");
  CHECK(text_of(driver.expect_enabled("Export figure/Width/88 mm", false)) == "");  // numbers have none
  CHECK(text_of(driver.type("Export figure/File", "curve.csv")) == "");
  CHECK(driver.frames(2));
  CHECK(text_of(driver.click("Export figure/Copy as command")) == "");
  CHECK(desk.window.clipboard() == "trocar model curve /data/pegs.trocar 3 --out curve.csv");
  CHECK(text_of(driver.click("Export figure/Export")) == "");
  const auto* plot = desk.last<workbench::ExportPlot>();
  REQUIRE(plot != nullptr);
  CHECK(plot->settings.kind == workbench::PlotKind::kCurve);
  CHECK(plot->path == "curve.csv");
}

TEST_CASE("a model that follows says so, with what changed, and can be kept once the edit is made") {
  workbench::WorkbenchState state = testing::made_state_with_model();
  auto insight = std::make_shared<workbench::ModelInsight>(*state.insight);
  insight->following = workbench::Following{0.009, 12, 345, ""};
  state.insight = insight;
  Desk desk(state);
  Driver driver = desk.driver();
  CHECK(driver.key("Ctrl+3"));
  CHECK(driver.frames(3));
  CHECK(text_of(driver.click("Tabs/Models")) == "");
  CHECK(driver.frames(3));
  CHECK(text_of(driver.click("Models/Model state/Keep as a model")) == "");
  const auto* train = desk.last<workbench::TrainModel>();
  REQUIRE(train != nullptr);
  CHECK(train->options.method == learning::Method::kExact);
  CHECK(train->demonstrations.size() == 1);
}

}  // namespace trocar::ui
