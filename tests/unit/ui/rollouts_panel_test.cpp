// The Rollouts panel: choose and paint starts, pick one out by table, pictures and map, err at random, compare,
// correct.
#include <doctest/doctest.h>

#include <string>

#include "engine/learning/start_set.h"
#include "tests/support/ui_desk.h"

namespace trocar::ui {
namespace {

using workbench::SetRollouts;

/// Two of whose models fail from some starts: the exact one with its policy taken away in one cell.
workbench::WorkbenchState with_a_dead_end() {
  workbench::WorkbenchState state = testing::made_state_with_model();
  auto insight = std::make_shared<workbench::ModelInsight>(*state.insight);
  auto policy = std::make_shared<std::vector<std::uint8_t>>(*insight->policy);
  const spatial::CellIndex lost = insight->starts.front();
  (*policy)[static_cast<std::size_t>(lost.value)] = learning::kNoAction;
  insight->policy = policy;
  insight->selected = learning::rollout(*insight->entry->model, *policy, lost);
  insight->why = learning::explain(*insight->entry->model, *policy, lost);
  state.rollouts.selected = lost;
  state.insight = insight;
  return state;
}

struct RolloutsDesk : Desk {
  explicit RolloutsDesk(workbench::WorkbenchState of = testing::made_state_with_model()) : Desk(std::move(of)) {
    click("Menu/Workspaces/Rollouts");
    commands.clear();
  }
  void click(const std::string& path) {
    CHECK(text_of(driver().click(path)) == "");
    CHECK(driver().frames(2));
  }
  std::string value(const std::string& path) {
    const Result<Item> item = driver().item(path);
    return item ? item->value : item.error().text();
  }
  const learning::Model& model() const { return *state.insight->entry->model; }
};

std::string words(const spatial::Grid& grid, spatial::CellIndex cell) {
  const auto c = grid.coordinates(cell);
  return std::to_string(c.x) + ", " + std::to_string(c.y) + ", " + std::to_string(c.z);
}

}  // namespace

TEST_CASE("each kind of starts is chosen by its word") {
  RolloutsDesk desk;
  const std::vector<std::pair<std::string, std::string>> kinds{{"All cells", "all"},
                                                               {"Box", "box:0-21,0-21,0-21"},
                                                               {"Face", "face:z1"},
                                                               {"Sphere", "sphere:11,11,11,3"},
                                                               {"Gaussian", "gaussian:5,200,1"}};
  for (const auto& [name, starts] : kinds) {
    desk.click("Rollouts/Starts");
    desk.click("Rollouts/Starts/" + name);
    const auto* asked = desk.last<SetRollouts>();
    REQUIRE(asked != nullptr);
    CHECK(asked->settings.starts == starts);
    CHECK(learning::starts_from(asked->settings.starts, desk.model()));
  }
}

TEST_CASE("a row of the table and a small picture bring out the rollout from their start") {
  RolloutsDesk desk;
  const auto& listed = *desk.state.insight->listed;
  desk.click("Rollouts/Page/Table");
  desk.click("Rollouts/Table/" + words(desk.model().grid, listed[1].start));
  REQUIRE(desk.last<SetRollouts>() != nullptr);
  CHECK(desk.last<SetRollouts>()->settings.selected == listed[1].start);
  desk.click("Rollouts/Page/Paths");
  const auto order = learning::sorted_by(listed, learning::RolloutMeasure::kMaxDeviation, true, desk.model().grid, {});
  desk.click("Rollouts/Small multiples/" + words(desk.model().grid, listed[order[2]].start) + "/Rollout");
  CHECK(desk.last<SetRollouts>()->settings.selected == listed[order[2]].start);
}

TEST_CASE("24 small pictures are shown of more rollouts, in the order of the chosen measure") {
  RolloutsDesk desk;
  desk.click("Rollouts/Page/Paths");
  const auto& listed = *desk.state.insight->listed;
  const auto order = learning::sorted_by(listed, learning::RolloutMeasure::kMaxDeviation, true, desk.model().grid, {});
  for (std::size_t i : {std::size_t{0}, std::size_t{23}}) {
    const std::string path =
        "Rollouts/Small multiples/" + words(desk.model().grid, listed[order[i]].start) + "/Rollout";
    CHECK(text_of(desk.driver().expect_present(path, true)) == "");
  }
  const std::string beyond =
      "Rollouts/Small multiples/" + words(desk.model().grid, listed[order[24]].start) + "/Rollout";
  CHECK(text_of(desk.driver().expect_present(beyond, false)) == "");
}

TEST_CASE(
    "a click on the map selects the start there; painting makes cells the starts, with one request for a stroke") {
  RolloutsDesk desk;
  desk.click("Rollouts/Success map/Cells");
  REQUIRE(desk.last<SetRollouts>() != nullptr);
  REQUIRE(desk.last<SetRollouts>()->settings.selected);
  CHECK(desk.model().grid.coordinates(*desk.last<SetRollouts>()->settings.selected).x ==
        desk.model().grid.coordinates(desk.model().start).x);
  desk.click("Rollouts/Success map/Mouse/Paint");
  desk.commands.clear();
  CHECK(text_of(desk.driver().drag("Rollouts/Success map/Cells", 60, 0)) == "");
  CHECK(desk.driver().frames(3));
  int strokes = 0;
  for (const auto& command : desk.commands) strokes += std::get_if<SetRollouts>(&command) != nullptr ? 1 : 0;
  CHECK(strokes == 1);
  const std::string starts = desk.last<SetRollouts>()->settings.starts;
  CHECK(starts.starts_with("cells:"));
  const auto cells = learning::starts_from(starts, desk.model());
  REQUIRE(cells);
  CHECK(cells->size() >= 3);
}

TEST_CASE("a start that fails says why, and its correction is recorded from there in Author") {
  RolloutsDesk desk(with_a_dead_end());
  CHECK(desk.value("Rollouts/Selected/End") != "arrives");
  const spatial::CellIndex lost = *desk.state.rollouts.selected;
  CHECK(desk.value("Rollouts/Selected/Why/Lost in") == words(desk.model().grid, lost));
  desk.click("Rollouts/Selected/Record a corrective demonstration from here");
  const auto* take = desk.last<workbench::RecordByHand>();
  REQUIRE(take != nullptr);
  REQUIRE(take->from);
  CHECK(take->from->cell == desk.model().grid.coordinates(lost));
  CHECK(take->from->grid == desk.model().grid.n);
  CHECK(text_of(desk.driver().expect_present("Tabs/Timeline", true)) == "");
}

TEST_CASE("of a model of segment C a take begins with the block in the jaws") {
  workbench::WorkbenchState state = with_a_dead_end();
  auto insight = std::make_shared<workbench::ModelInsight>(*state.insight);
  auto entry = std::make_shared<workbench::ModelEntry>(*insight->entry);
  entry->segment = demonstration::Segment::kC;
  insight->entry = entry;
  state.insight = insight;
  RolloutsDesk desk(state);
  desk.click("Rollouts/Selected/Record a corrective demonstration from here");
  const auto* take = desk.last<workbench::RecordByHand>();
  REQUIRE(take != nullptr);
  REQUIRE(take->from);
  CHECK(take->from->segment == demonstration::Segment::kC);
}

TEST_CASE("erring at random is asked for as set, and what was stopped says how far it came") {
  RolloutsDesk desk;
  desk.click("Rollouts/Page/Chance");
  desk.click("Rollouts/Err at random/Run");
  const auto* run = desk.last<workbench::RunMonteCarlo>();
  REQUIRE(run != nullptr);
  CHECK(run->options.epsilon == 0.1);
  CHECK(run->options.runs == 100);
  Progress progress;
  learning::MonteCarlo half =
      learning::monte_carlo(desk.model(), desk.state.insight->starts, run->options, progress).value();
  half.finished = static_cast<int>(half.starts.size()) * 37 / 100;
  const auto view = workbench::monte_carlo_view(desk.state.insight->entry, desk.state.rollouts.starts, half);
  desk.state.monte_carlo = std::make_shared<const workbench::MonteCarloView>(view);
  CHECK(desk.driver().frames(3));
  const int shown = 100 * half.finished / static_cast<int>(half.starts.size());
  CHECK(text_of(desk.driver().expect_present("Rollouts/Err at random/" + std::to_string(shown) + " %", true)) == "");
  CHECK(desk.value("Rollouts/Err at random/Share").find("95 % interval") != std::string::npos);
  desk.state.jobs = {testing::made_job(9, "Err at random, ε = 0.1", workbench::JobState::kRunning, 0.2)};
  CHECK(desk.driver().frames(3));
  desk.click("Rollouts/Err at random/Stop");
  REQUIRE(desk.last<workbench::CancelJob>() != nullptr);
  CHECK(desk.last<workbench::CancelJob>()->id == workbench::JobId{9});
}

TEST_CASE("rows are exported under the name that was typed, and copied as the command that writes them") {
  RolloutsDesk desk;
  desk.click("Rollouts/Page/Chance");
  CHECK(text_of(desk.driver().type("Rollouts/Export/File", "mine.csv")) == "");
  CHECK(desk.driver().frames(2));
  desk.click("Rollouts/Export/Export");
  REQUIRE(desk.last<workbench::ExportRollouts>() != nullptr);
  CHECK(desk.last<workbench::ExportRollouts>()->path == "mine.csv");
  desk.click("Rollouts/Export/Copy as command");
  CHECK(desk.window.clipboard() == "trocar rollout run /data/pegs.trocar 3 --starts around:3 --out mine.csv");
  desk.click("Rollouts/Export/Kind of file/HDF5");
  desk.click("Rollouts/Export/Copy as command");
  CHECK(desk.window.clipboard() == "trocar rollout run /data/pegs.trocar 3 --starts around:3 --out mine.h5");
  desk.click("Rollouts/Export/Export");
  CHECK(desk.last<workbench::ExportRollouts>()->path == "mine.h5");
  desk.click("Rollouts/Export/Kind of file/CSV");
  desk.click("Rollouts/Export/Rows/Band");
  desk.click("Rollouts/Export/Export");
  CHECK(desk.last<workbench::ExportRollouts>()->rows == workbench::RolloutRows::kBand);
  desk.click("Rollouts/Export/Copy as command");
  CHECK(desk.window.clipboard() == "trocar rollout run /data/pegs.trocar 3 --starts around:3 --band mine.csv");
}

TEST_CASE("rows of erring and of the simulator are offered once they are known of these starts, with their commands") {
  RolloutsDesk desk;
  desk.click("Rollouts/Page/Chance");
  const auto reason = [&desk](const std::string& rows) {
    desk.click("Rollouts/Export/Rows/" + rows);
    return desk.driver().item("Rollouts/Export/Export").value().reason;
  };
  const auto copied = [&desk]() {
    desk.click("Rollouts/Export/Copy as command");
    return desk.window.clipboard();
  };
  CHECK(reason("Erring").find("err at random first") != std::string::npos);
  CHECK(reason("Simulator").find("simulate the rollouts first") != std::string::npos);
  Progress progress;
  learning::MonteCarloOptions erring;
  erring.runs = 7;
  erring.seed = 9;
  auto view = workbench::monte_carlo_view(
      desk.state.insight->entry, desk.state.rollouts.starts,
      learning::monte_carlo(desk.model(), desk.state.insight->starts, erring, progress).value());
  desk.state.monte_carlo = std::make_shared<const workbench::MonteCarloView>(view);
  trial::PhysicsOptions options;
  options.seed = 4;
  options.continuous = true;
  desk.state.physics = std::make_shared<const workbench::PhysicsView>(
      workbench::physics_view(desk.state.insight->entry, desk.state.rollouts.starts, desk.state.insight->starts,
                              options, trial::PhysicsRollouts(desk.state.insight->starts.size())));
  CHECK(desk.driver().frames(3));
  CHECK(reason("Erring").empty());
  CHECK(copied() ==
        "trocar rollout run /data/pegs.trocar 3 --starts around:3 --epsilon 0.1 --runs 7 --seed 9 --out rollouts.csv");
  desk.click("Rollouts/Export/Export");
  CHECK(desk.last<workbench::ExportRollouts>()->rows == workbench::RolloutRows::kErring);
  CHECK(reason("Simulator").empty());
  CHECK(copied() ==
        "trocar rollout physics /data/pegs.trocar 3 --starts around:3 --seed 4 --continuous --out rollouts.csv");
  desk.click("Rollouts/Export/Export");
  CHECK(desk.last<workbench::ExportRollouts>()->rows == workbench::RolloutRows::kSimulated);
  view.starts = "all";
  desk.state.monte_carlo = std::make_shared<const workbench::MonteCarloView>(view);
  CHECK(desk.driver().frames(3));
  CHECK(reason("Erring").find("other starts") != std::string::npos);
}

TEST_CASE("a second model is chosen in the panel, and its pairs are told with their p") {
  workbench::WorkbenchState state = testing::made_state_with_model();
  auto project = std::make_shared<workbench::Project>(*state.project);
  auto other = std::make_shared<workbench::ModelEntry>(*state.insight->entry);
  other->id = {7};
  other->name = "Other";
  project->models[other->id] = other;
  state.project = project;
  RolloutsDesk desk(state);
  desk.click("Rollouts/Page/Two models");
  desk.click("Rollouts/Two models/Second model");
  desk.click("Rollouts/Two models/Second model/Other");
  REQUIRE(desk.last<workbench::SetLearning>() != nullptr);
  CHECK(desk.last<workbench::SetLearning>()->settings.second == workbench::ModelId{7});
  workbench::InsightRequest request;
  request.entry = desk.state.insight->entry;
  request.second = other;
  request.rollouts = desk.state.rollouts;
  desk.state.insight = workbench::InsightMaker().make(request);
  desk.state.learning.second = {7};
  CHECK(desk.driver().frames(3));
  CHECK(desk.value("Rollouts/Two models/Chosen starts/McNemar") == "p = 1.000");
  CHECK(desk.value("Rollouts/Two models/Chosen starts/Ties") == "100 %  (294)");
}

}  // namespace trocar::ui
