// What the Rollouts panel draws of many rollouts: their play, axes to brush on, arrivals by step, boxes of deviations.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <string>

#include "tests/support/ui_desk.h"
#include "ui/panels/rollout_brush.h"

namespace trocar::ui {
namespace {

using learning::RolloutMeasure;
using workbench::GhostPace;
using workbench::SetRollouts;

/// As the window is: what is asked for of rollouts is so in the next frame.
struct PlayedDesk : Desk {
  explicit PlayedDesk(const std::string& page, workbench::WorkbenchState of = testing::made_state_with_model())
      : Desk(std::move(of)) {
    click("Menu/Workspaces/Rollouts");
    click("Rollouts/Page/" + page);
    commands.clear();
  }
  void frames(int count) {
    for (int i = 0; i < count; ++i) {
      CHECK(driver().frames(1));
      if (const auto* asked = last<SetRollouts>()) state.rollouts = asked->settings;
    }
  }
  void click(const std::string& path) {
    CHECK(text_of(driver().click(path)) == "");
    frames(2);
  }
  /// A click in each of whose frames the window knows what was asked for before.
  void press(const std::string& path) {
    const Result<Item> item = driver().item(path);
    REQUIRE(item);
    press_at(item->rect.centre_x(), item->rect.centre_y());
  }
  void press_at(float x, float y) {
    window.input().push(MouseMoved{x, y});
    frames(1);
    for (const bool down : {true, false}) {
      window.input().push(MouseButton{0, down});
      frames(2);
    }
  }
  std::string value(const std::string& path) {
    const Result<Item> item = driver().item(path);
    return item ? item->value : item.error().text();
  }
  bool present(const std::string& path) { return static_cast<bool>(driver().expect_present(path, true)); }
  const std::vector<learning::Rollout>& listed() const { return *state.insight->listed; }
  std::string name(const learning::Rollout& one) const {
    const auto c = state.insight->entry->model->grid.coordinates(one.start);
    return std::to_string(c.x) + ", " + std::to_string(c.y) + ", " + std::to_string(c.z);
  }
};

/// Beside a model of the paper's method, which loops from many starts.
workbench::WorkbenchState beside_the_paper() {
  workbench::WorkbenchState state = testing::made_state_with_model();
  auto paper = std::make_shared<workbench::ModelEntry>(*state.insight->entry);
  learning::TrainOptions options;
  options.method = learning::Method::kEgMaxent;
  options.episodes = 2000;
  Progress progress;
  paper->model = std::make_shared<const learning::Model>(
      learning::train(spatial::Grid{}, {testing::sample_demonstrations().front()}, options, progress).value());
  paper->name = "Paper";
  paper->id = {7};
  workbench::InsightRequest request;
  request.entry = state.insight->entry;
  request.second = paper;
  request.rollouts = state.rollouts;
  state.insight = workbench::InsightMaker().make(request);
  return state;
}

}  // namespace

TEST_CASE("rollouts never play by themselves; played, they come further, stop at a click, and end whole") {
  PlayedDesk desk("Paths");
  desk.frames(30);
  CHECK(desk.last<SetRollouts>() == nullptr);
  desk.click("Rollouts/Play/Play");
  desk.frames(20);
  REQUIRE(desk.state.rollouts.reach);
  const double early = *desk.state.rollouts.reach;
  CHECK(early > 0.0);
  desk.frames(20);
  REQUIRE(desk.state.rollouts.reach);
  CHECK(*desk.state.rollouts.reach > early);
  desk.click("Rollouts/Play/Pause");
  const double paused = *desk.state.rollouts.reach;
  desk.frames(20);
  CHECK(*desk.state.rollouts.reach == paused);
  desk.click("Rollouts/Play/Play");
  CHECK(*desk.state.rollouts.reach >= paused);
  for (int i = 0; i < 100 && desk.state.rollouts.reach; ++i) desk.frames(20);
  CHECK_FALSE(desk.state.rollouts.reach);
  CHECK(desk.present("Rollouts/Play/Play"));
}

TEST_CASE("the small pictures say at which step each rollout is, and another pace keeps the place") {
  PlayedDesk desk("Paths");
  const learning::Rollout& first = desk.listed()[learning::sorted_by(desk.listed(), RolloutMeasure::kMaxDeviation, true,
                                                                     desk.state.insight->entry->model->grid, {})[0]];
  const std::string picture = "Rollouts/Small multiples/" + desk.name(first) + "/Rollout";
  CHECK(desk.value(picture).find("step") == std::string::npos);
  desk.state.rollouts.reach = 2.5;
  desk.frames(2);
  CHECK(desk.value(picture).ends_with("step 2 of " + std::to_string(first.cells.size() - 1)));
  CHECK(desk.value("Rollouts/Play/Reached").find("step 2") != std::string::npos);
  desk.click("Rollouts/Play/Pace/By length");
  CHECK(desk.state.rollouts.pace == GhostPace::kLength);
  std::size_t longest = 0;
  for (const auto& one : desk.listed()) longest = std::max(longest, one.cells.size() - 1);
  CHECK(*desk.state.rollouts.reach == doctest::Approx(2.5 / static_cast<double>(longest)));
}

TEST_CASE("ranges keep what lies in all of them, unknown values in none, and let go bring all back") {
  auto state = testing::made_state_with_model();
  RolloutBrush brush;
  brush.update(*state.insight);
  const auto& listed = *state.insight->listed;
  CHECK(brush.kept() == listed.size());
  const int version = brush.version();
  brush.set(RolloutMeasure::kSteps, RolloutBrush::Range{10.0, 14.0});
  brush.set(RolloutMeasure::kMaxDeviation, RolloutBrush::Range{0.0, 0.004});
  CHECK(brush.version() != version);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < listed.size(); ++i) {
    const std::size_t steps = listed[i].cells.size() - 1;
    const bool inside = steps >= 10 && steps <= 14 && listed[i].max_deviation_m <= 0.004;
    REQUIRE(brush.keeps(i) == inside);
    kept += inside ? 1 : 0;
  }
  CHECK(brush.kept() == kept);
  CHECK(kept < listed.size());
  brush.clear();
  CHECK(brush.kept() == listed.size());
  auto blind = *state.insight;
  blind.clearance_m = nullptr;
  blind.listed = std::make_shared<const std::vector<learning::Rollout>>(listed);
  brush.set(RolloutMeasure::kClearance, RolloutBrush::Range{-1.0, 1.0});
  CHECK(brush.kept() == listed.size());
  brush.update(blind);
  CHECK(brush.kept() == 0);
}

TEST_CASE("a drag along an axis brushes table and pictures, a click on it or Show all lets go") {
  PlayedDesk desk("Table");
  const auto shown_rows = [&desk]() {
    int rows = 0;
    for (const auto& one : desk.listed()) rows += desk.present("Rollouts/Table/" + desk.name(one)) ? 1 : 0;
    return rows;
  };
  std::size_t least = 1000;
  std::size_t most = 0;
  for (const auto& one : desk.listed()) {
    least = std::min(least, one.cells.size() - 1);
    most = std::max(most, one.cells.size() - 1);
  }
  CHECK(desk.value("Rollouts/Measures/Steps") == std::to_string(least) + " to " + std::to_string(most));
  CHECK_FALSE(desk.present("Rollouts/Measures/Brushed"));
  const int before = shown_rows();
  // From its middle up beyond its end.
  CHECK(text_of(desk.driver().drag("Rollouts/Measures/Steps", 0, -400)) == "");
  desk.frames(2);
  CHECK(desk.value("Rollouts/Measures/Steps").ends_with(" to " + std::to_string(most)));
  const std::string told = desk.value("Rollouts/Measures/Steps");
  REQUIRE(told.find("brushed ") != std::string::npos);
  const auto low = static_cast<std::size_t>(std::stoi(told.substr(told.find("brushed ") + 8)));
  const std::string brushed = desk.value("Rollouts/Measures/Brushed");
  const int kept = std::stoi(brushed);
  CHECK(brushed == std::to_string(kept) + " of 40 brushed");
  CHECK(std::count_if(desk.listed().begin(), desk.listed().end(),
                      [low](const auto& one) { return one.cells.size() - 1 >= low; }) == kept);
  CHECK(kept > 0);
  CHECK(kept < 40);
  CHECK(shown_rows() <= std::min(before, kept));
  for (const auto& one : desk.listed()) {
    if (one.cells.size() - 1 == least) CHECK_FALSE(desk.present("Rollouts/Table/" + desk.name(one)));
  }
  desk.click("Rollouts/Page/Paths");
  CHECK(desk.value("Rollouts/Small multiples/Brushed") == brushed);
  for (const auto& one : desk.listed()) {
    if (one.cells.size() - 1 == least)
      CHECK_FALSE(desk.present("Rollouts/Small multiples/" + desk.name(one) + "/Rollout"));
  }
  desk.click("Rollouts/Small multiples/Show all");
  CHECK_FALSE(desk.present("Rollouts/Small multiples/Brushed"));
  desk.click("Rollouts/Page/Table");
  CHECK(text_of(desk.driver().drag("Rollouts/Measures/Worst", 0, 40)) == "");
  desk.frames(2);
  CHECK(desk.present("Rollouts/Measures/Brushed"));
  desk.click("Rollouts/Measures/Worst");
  CHECK_FALSE(desk.present("Rollouts/Measures/Brushed"));
}

TEST_CASE("arrivals end at the share that arrives at all, of both models if there are two") {
  PlayedDesk desk("Spread");
  const std::string alone = desk.value("Rollouts/Arrivals/Curve");
  CHECK(alone.starts_with("within "));
  CHECK(alone.ends_with(" steps: 100 % (294)"));
  desk.state = beside_the_paper();
  desk.frames(3);
  const auto& insight = *desk.state.insight;
  const int b = learning::summarise(insight.second->comparison->basin_b, insight.starts).arrived;
  REQUIRE(b < 294);
  const std::string both = desk.value("Rollouts/Arrivals/Curve");
  CHECK(both.find("A 100 % (294), B ") != std::string::npos);
  CHECK(both.ends_with("(" + std::to_string(b) + ")"));
}

TEST_CASE("each end has its box of a measure, told apart by model, with the spread of its rollouts") {
  PlayedDesk desk("Spread");
  const auto deviations = [](const learning::RolloutSpread& of, learning::RolloutEnd end) {
    return of.of(learning::RolloutMeasure::kMaxDeviation, end).spread;
  };
  const auto spread = deviations(*desk.state.insight->spread, learning::RolloutEnd::kArrives);
  CHECK(desk.value("Rollouts/Boxes/Arrives").starts_with(std::to_string(spread.count) + ": "));
  CHECK_FALSE(desk.present("Rollouts/Boxes/Loops"));
  desk.state = beside_the_paper();
  desk.frames(3);
  CHECK(desk.present("Rollouts/Boxes/A arrives"));
  CHECK_FALSE(desk.present("Rollouts/Boxes/A loops"));
  const auto loops = deviations(*desk.state.insight->second->spread, learning::RolloutEnd::kLoops);
  REQUIRE(loops.count > 0);
  CHECK(desk.value("Rollouts/Boxes/B loops").starts_with(std::to_string(loops.count) + ": "));
}

TEST_CASE("boxes are of the measure that is chosen, and written as the figure that is shown") {
  PlayedDesk desk("Spread");
  desk.click("Rollouts/Boxes/Measure");
  desk.click("Rollouts/Boxes/Measure/Steps");
  std::vector<double> steps;
  for (const learning::Rollout& rollout : desk.listed()) {
    if (rollout.end == learning::RolloutEnd::kArrives) steps.push_back(static_cast<double>(rollout.cells.size()) - 1);
  }
  const learning::Spread spread = learning::spread_of(steps);
  const std::string value = desk.value("Rollouts/Boxes/Arrives");
  CHECK(value.find("to " + std::to_string(static_cast<int>(spread.most)) + ", middle") != std::string::npos);
  desk.click("Rollouts/Export boxes…");
  CHECK(text_of(desk.driver().click("Export figure/Kind of file/PDF")) == "");
  CHECK(text_of(desk.driver().click("Export figure/Width/88 mm")) == "");
  CHECK(text_of(desk.driver().type("Export figure/File", "steps.pdf")) == "");
  desk.frames(2);
  CHECK(text_of(desk.driver().click("Export figure/Copy as command")) == "");
  CHECK(desk.window.clipboard() ==
        "trocar rollout plot /data/pegs.trocar 3 --starts around:3 --kind boxes --measure steps --preset column --out "
        "steps.pdf");
  CHECK(text_of(desk.driver().click("Export figure/Export")) == "");
  const auto* plot = desk.last<workbench::ExportPlot>();
  REQUIRE(plot != nullptr);
  CHECK(plot->settings.kind == workbench::PlotKind::kBoxes);
  CHECK(plot->settings.measures == std::vector{learning::RolloutMeasure::kSteps});
  CHECK(plot->settings.preset == "column");
  CHECK(plot->path == "steps.pdf");
}

TEST_CASE("every page of rollouts opens the form on the figure that it shows") {
  const std::vector<std::array<std::string, 3>> pages{{"Spread", "Export arrivals…", "arrivals"},
                                                      {"Spread", "Export deviations…", "band"},
                                                      {"Table", "Export axes…", "axes"},
                                                      {"Paths", "Export pictures…", "multiples"},
                                                      {"Outcomes", "Export map…", "map"}};
  for (const auto& [page, label, kind] : pages) {
    CAPTURE(label);
    PlayedDesk desk(page);
    desk.click("Rollouts/" + label);
    CHECK(text_of(desk.driver().type("Export figure/File", "f.svg")) == "");
    desk.frames(2);
    CHECK(text_of(desk.driver().click("Export figure/Copy as command")) == "");
    CHECK(desk.window.clipboard().find(" --kind " + kind) != std::string::npos);
    CHECK(text_of(desk.driver().click("Export figure/Export")) == "");
    const auto* plot = desk.last<workbench::ExportPlot>();
    REQUIRE(plot != nullptr);
    CHECK(workbench::to_string(plot->settings.kind) == kind);
  }
}

TEST_CASE("what cannot be written is said in the form, which stays open") {
  PlayedDesk desk("Spread");
  desk.click("Rollouts/Export arrivals…");
  const auto reason = [&desk](const std::string& file) {
    CHECK(text_of(desk.driver().type("Export figure/File", file)) == "");
    desk.frames(2);
    return desk.driver().item("Export figure/Export").value().reason;
  };
  CHECK(reason("/no/such/folder/a.png") == "There is no folder /no/such/folder");
  CHECK(reason("a.npy").find(".csv") != std::string::npos);
  CHECK(reason("A.PNG").empty());
  CHECK(reason("a.csv").empty());
}

TEST_CASE("what is brushed is so in the 3-D view, also while a play goes on, and comes back from there") {
  PlayedDesk desk("Table");
  CHECK(text_of(desk.driver().drag("Rollouts/Measures/Steps", 0, -400)) == "");
  desk.frames(2);
  REQUIRE(desk.state.rollouts.brushed.size() == 1);
  CHECK(desk.state.rollouts.brushed[0].measure == RolloutMeasure::kSteps);
  const std::string brushed = desk.value("Rollouts/Measures/Brushed");
  desk.commands.clear();
  desk.state.rollouts.brushed.clear();
  desk.frames(2);
  CHECK_FALSE(desk.present("Rollouts/Measures/Brushed"));
  desk.state.rollouts.brushed = {{RolloutMeasure::kSteps, 0.0, 1000.0}};
  desk.frames(2);
  CHECK(desk.value("Rollouts/Measures/Brushed") == "40 of 40 brushed");
  desk.click("Rollouts/Page/Paths");
  desk.click("Rollouts/Play/Play");
  desk.frames(5);
  desk.press("Rollouts/Small multiples/Show all");
  CHECK(desk.state.rollouts.brushed.empty());
  CHECK(desk.state.rollouts.reach);
}

TEST_CASE("a click on a line makes its rollout stand out, and leaves ranges alone") {
  PlayedDesk desk("Table");
  CHECK_FALSE(desk.state.rollouts.selected);
  CHECK(text_of(desk.driver().drag("Rollouts/Measures/Steps", 0, -400)) == "");
  desk.frames(2);
  // The axis of all that arrive: every line meets it where the top one does.
  const Result<Item> item = desk.driver().item("Rollouts/Measures/End");
  REQUIRE(item);
  bool found = false;
  for (float y = item->rect.y1 - 4.0F; y > item->rect.y0 && !found; y -= 3.0F) {
    desk.press_at(item->rect.centre_x(), y);
    found = desk.state.rollouts.selected.has_value();
  }
  REQUIRE(found);
  CHECK(std::any_of(desk.listed().begin(), desk.listed().end(),
                    [&](const auto& one) { return one.start == *desk.state.rollouts.selected; }));
  CHECK(desk.state.rollouts.brushed.size() == 1);
}

TEST_CASE("Space plays and pauses the rollouts where they are shown, and the demonstration elsewhere") {
  PlayedDesk desk("Paths");
  CHECK(text_of(desk.driver().hover("Rollouts/Play/Pace/By step")) == "");
  desk.frames(2);
  CHECK(text_of(desk.driver().key("Space")) == "");
  desk.frames(10);
  CHECK(desk.present("Rollouts/Play/Pause"));
  CHECK(desk.state.rollouts.reach);
  CHECK(desk.last<workbench::Play>() == nullptr);
  CHECK(text_of(desk.driver().key("Space")) == "");
  desk.frames(2);
  CHECK(desk.present("Rollouts/Play/Play"));
  desk.click("Rollouts/Page/Table");
  CHECK(text_of(desk.driver().key("Space")) == "");
  CHECK(desk.last<workbench::Play>() != nullptr);
}

TEST_CASE("the band says how many of all still go on") {
  PlayedDesk desk("Spread");
  const auto& band = desk.state.insight->spread->band;
  CHECK(desk.value("Rollouts/Deviation/Band").ends_with("40 of 40 go on"));
  const Result<Item> item = desk.driver().item("Rollouts/Deviation/Band");
  REQUIRE(item);
  // From its middle far to the right: the last step.
  CHECK(text_of(desk.driver().drag("Rollouts/Deviation/Band", 0.48F * item->rect.width(), 0)) == "");
  desk.frames(2);
  const std::string last = std::to_string(band.count.size() - 1);
  CHECK(desk.value("Rollouts/Deviation/Band").starts_with("step " + last + ": "));
  CHECK(desk.value("Rollouts/Deviation/Band").ends_with(", " + std::to_string(band.count.back()) + " of 40 go on"));
}

}  // namespace trocar::ui
