// Every panel in every state, in two themes and at two scales, against tests/golden/windows/*.png.
// Run with TROCAR_BLESS=1 to write them anew, look at them, and say why.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "engine/core/file.h"
#include "engine/workbench/importing.h"
#include "tests/support/golden_picture.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/ui_take.h"
#include "ui/driver/driver.h"
#include "ui/session.h"
#include "ui/window/osmesa_window.h"

using namespace trocar;
using namespace trocar::ui;
using workbench::LoadState;

namespace {

struct PanelState {
  std::string name;
  WorkbenchState shown;
};

WorkbenchState emptied() {
  WorkbenchState state = testing::made_state();
  state.project = std::make_shared<workbench::Project>();
  state.demonstration = {};
  state.review = nullptr;
  state.history.clear();
  state.head = 0;
  state.jobs.clear();
  state.log.clear();
  return state;
}

WorkbenchState loading() {
  WorkbenchState state;
  state.load = LoadState::kLoading;
  state.path = "/data/pegs.trocar";
  return state;
}

WorkbenchState failed() {
  WorkbenchState state = loading();
  state.load = LoadState::kFailed;
  state.load_error = "the file is no Trocar project: /data/pegs.trocar";
  return state;
}

/// Everything that is worked out behind the window has been asked for and is not there yet.
WorkbenchState pending() {
  WorkbenchState state = testing::made_state_with_model();
  state.insight.reset();
  state.insight_pending = true;
  state.review = nullptr;
  state.review_pending = true;
  state.curves = nullptr;
  state.curves_pending = true;
  state.comparison = nullptr;
  state.comparing = workbench::ComparisonSettings{};
  state.comparison_pending = true;
  state.picture_pending = true;
  return state;
}

/// With a model whose demonstration had this hash when it was trained.
WorkbenchState with_model_of(std::uint64_t hash) {
  WorkbenchState state = testing::made_state_with_model();
  auto project = std::make_shared<workbench::Project>(*state.project);
  auto entry = std::make_shared<workbench::ModelEntry>(*project->models.at(state.model));
  entry->demonstration_hashes.assign(entry->demonstrations.size(), hash);
  project->models[state.model] = entry;
  state.project = project;
  auto insight = std::make_shared<workbench::ModelInsight>(*state.insight);
  insight->entry = entry;
  insight->stale = project->stale(*entry);
  state.insight = insight;
  return state;
}

std::vector<PanelState> panel_states() {
  const std::uint64_t now = testing::made_state().project->demonstrations.at({1})->hash();
  return {{"no_project", {}},           {"loading", loading()}, {"failed", failed()},
          {"empty", emptied()},         {"pending", pending()}, {"stale", with_model_of(now + 1)},
          {"ready", with_model_of(now)}};
}

/// "history_empty_dark_100"
std::string file_name(PanelId panel, const std::string& state, ThemeKind theme, float scale) {
  std::string name = fmt::format("{}_{}_{}_{:.0f}", title(panel), state, name_of(theme), 100.0F * scale);
  for (char& c : name) c = c == ' ' || c == '-' ? '_' : static_cast<char>(std::tolower(c));
  return name;
}

/// What is done in the window before the picture is taken; it may put into the state what the workbench would answer.
using Prepare = std::function<void(Driver&, WorkbenchState&)>;

Image picture_of(PanelId panel, WorkbenchState state, ThemeKind theme, float scale, const Prepare& prepare = {},
                 WindowSize size = {640, 560}) {
  const auto px = [scale](int at_100) { return static_cast<int>(scale * static_cast<float>(at_100)); };
  auto window = OsmesaWindow::create({px(size.width), px(size.height)});
  REQUIRE(window);
  state.light_backdrop = theme == ThemeKind::kLight;
  Settings settings;
  settings.scale = scale;
  settings.theme = theme;
  Tile only;
  only.panels = {panel};
  settings.layout() = only;
  const auto session = Session::create(**window, settings).value();
  Driver driver(*session, [&]() -> Status {
    (*window)->poll(0.0);
    TROCAR_ASSIGN_OR_RETURN([[maybe_unused]] const ShellResult result, session->frame(state));
    return {};
  });
  REQUIRE(driver.frames(6));
  if (prepare) {
    prepare(driver, state);
    REQUIRE(driver.frames(8));
  }
  return session->window().capture().value();
}

void compare(const std::string& name, const Image& image) {
  CAPTURE(name);
  const auto apart = testing::golden_difference(image, share_path("tests/golden/windows") / (name + ".png"));
  REQUIRE(apart);
  CHECK(apart->mean <= testing::kMeanLimit);
  CHECK(apart->worst <= testing::kWorstLimit);
}

struct Scene {
  const char* name;
  PanelId panel;
  WorkbenchState state;
  Prepare prepare;
  WindowSize size{640, 560};
};

Prepare press(const char* keys) {
  return [keys](Driver& driver, WorkbenchState&) { REQUIRE(driver.key(keys)); };
}

Prepare begin_edit(const char* title) {
  return [title](Driver& driver, WorkbenchState& state) {
    state.selection = workbench::TimeSpan{2.0, 3.5};
    REQUIRE(driver.click("Edits/Kind of edit"));
    REQUIRE(driver.click(std::string("Edits/Kind of edit/") + title));
    REQUIRE(driver.click("Edits/Add edit…"));
  };
}

void drop_bad_table(Driver& driver, WorkbenchState& state) {
  const testing::ScratchFolder folder;
  REQUIRE(write_file(folder / "hand.csv", "time_s,left_x_mm,left_y_mm\n0,1,2\n0.1,1,2\n0.2,1,2\n"));
  workbench::ImportSettings settings;
  settings.path = folder / "hand.csv";
  Progress progress;
  auto view = *workbench::view_of_import(settings, "2026-03-01T12:00:00Z", progress);
  REQUIRE_FALSE(view.error.empty());
  const std::string real = settings.path.string();
  view.settings.path = "/data/hand.csv";
  if (const auto at = view.error.find(real); at != std::string::npos) {
    view.error.replace(at, real.size(), "/data/hand.csv");
  }
  REQUIRE(driver.drop("/data/hand.csv"));
  state.import = std::make_shared<const workbench::ImportView>(std::move(view));
}

Prepare open(const char* path) {
  return [path](Driver& driver, WorkbenchState&) { REQUIRE(driver.click(path)); };
}

/// Other seeds beside the model of the paper.
WorkbenchState with_seeds() {
  WorkbenchState state = testing::made_state_with_two_models();
  workbench::InsightRequest request;
  request.entry = state.project->models.at({4});
  state.model = {4};
  state.insight = workbench::InsightMaker().make(request);
  state.learning.seeds = 5;
  state.seeds = workbench::seed_insight({request.entry, learning::Layer::kReward, 5});
  return state;
}

/// Of the model of the paper, from which not every start arrives, beside the exact one.
WorkbenchState with_failures() {
  WorkbenchState state = testing::made_state_with_two_models();
  workbench::InsightRequest request;
  request.entry = state.project->models.at({4});
  request.second = state.project->models.at({3});
  state.model = {4};
  state.learning.second = {3};
  state.insight = workbench::InsightMaker().make(request);
  return state;
}

WorkbenchState with_cloud() {
  WorkbenchState state = testing::made_state_with_model();
  state.field.volume = true;
  state.field.opacity_curve = plot::OpacityCurve{{{0.0, 0.05}, {0.55, 0.1}, {0.8, 0.7}, {1.0, 1.0}}};
  return state;
}

WorkbenchState with_brush() {
  WorkbenchState state = with_failures();
  state.rollouts.brushed = {{learning::RolloutMeasure::kSteps, 12.0, 20.0}};
  return state;
}

/// A film of two demonstrations and a field, at an instant; one is being rendered, one waits, two have ended.
WorkbenchState with_film() {
  WorkbenchState state = testing::made_state_with_model();
  workbench::FilmDraft& draft = state.film;
  film::Source field = film::recording_of("3");
  field.kind = film::SourceKind::kField;
  draft = with_source(std::move(draft), film::recording_of("2"));
  draft = with_source(std::move(draft), std::move(field));
  draft = with_source(std::move(draft), film::recording_of("1"));
  draft.at_s = 1.5;
  draft = with_key(std::move(draft), state.orbit);
  draft.at_s = 3.2;
  draft = with_key(std::move(draft), state.orbit);
  draft.film.path = "/tmp/pair.mp4";
  draft.job = "/tmp/pair.json";
  auto preview = std::make_shared<workbench::FilmPreview>();
  preview->of = workbench::look_of(draft.film);
  Image picture(640, 360, {214, 220, 228, 255});
  for (int y = 120; y < 300; ++y) {
    for (int x = 60; x < 580; ++x) picture.set(x, y, {120, static_cast<std::uint8_t>(90 + y / 3), 160, 255});
  }
  preview->picture = std::make_shared<const Image>(std::move(picture));
  preview->number = 1;
  preview->frame = 96;
  preview->frames = 300;
  preview->length_s = 9.967;
  state.film_preview = preview;
  const auto job = [](std::int64_t id, const char* path, workbench::JobState of) {
    workbench::JobView view;
    view.id = {id};
    view.film = path;
    view.title = "Film " + view.film.filename().string();
    view.state = of;
    return view;
  };
  workbench::JobView held = job(13, "/data/pair.mp4", workbench::JobState::kRunning);
  held.fraction = 0.5;
  held.done = 150;
  held.of = 300;
  held.paused = true;
  workbench::JobView done = job(11, "/data/slide.mp4", workbench::JobState::kDone);
  done.message = "300 frames in 9.8 s";
  workbench::JobView failed = job(10, "/full/disk.mp4", workbench::JobState::kFailed);
  failed.message = "could not write the film: /full/disk.mp4";
  state.jobs = {job(14, "/data/next.mp4", workbench::JobState::kQueued), held,
                job(12, "/data/given_up.mp4", workbench::JobState::kCancelled), done, failed};
  return state;
}

void type_in_palette(Driver& driver, WorkbenchState&) {
  REQUIRE(driver.key("Ctrl+P"));
  REQUIRE(driver.frames(3));
  REQUIRE(driver.hover("Palette/Command"));
}

std::vector<Scene> scenes() {
  const WorkbenchState ready = testing::made_state();
  return {{"edit_smooth", PanelId::kEdits, ready, begin_edit("Smooth")},
          {"edit_bridge", PanelId::kEdits, ready, begin_edit("Bridge")},
          {"record_form", PanelId::kView, ready, press("Shift+R"), {720, 640}},
          {"import_problem", PanelId::kLibrary, ready, drop_bad_table, {960, 660}},
          {"palette", PanelId::kLibrary, ready, type_in_palette},
          {"shortcuts", PanelId::kLibrary, ready, press("Shift+/"), {800, 560}},
          {"help", PanelId::kTimeline, ready, press("F1")},
          {"take_countdown", PanelId::kView, testing::take_state(trial::Phase::kCountdown), {}},
          {"take_recording", PanelId::kView, testing::take_state(), {}},
          {"take_lanes", PanelId::kTimeline, testing::take_state(), {}, {640, 300}},
          {"take_review", PanelId::kView, testing::verdict_state(), {}},
          {"models_two", PanelId::kModels, testing::made_state_with_two_models(), {}, {640, 1000}},
          {"models_difference",
           PanelId::kModels,
           testing::made_state_with_two_models(),
           open("Models/Mode/Difference"),
           {640, 1000}},
          {"models_seeds", PanelId::kModels, with_seeds(), {}, {640, 1120}},
          {"fields_montage",
           PanelId::kFields,
           testing::made_state_with_two_models(),
           open("Fields/Mode/Montage"),
           {640, 900}},
          {"fields_cloud", PanelId::kFields, with_cloud(), {}, {640, 900}},
          {"rollouts_spread", PanelId::kRollouts, with_failures(), open("Rollouts/Page/Spread"), {640, 1100}},
          {"rollouts_brushed", PanelId::kRollouts, with_brush(), open("Rollouts/Page/Table"), {640, 900}},
          {"rollouts_map", PanelId::kRollouts, with_failures(), {}, {640, 1100}},
          {"rollouts_table", PanelId::kRollouts, with_failures(), open("Rollouts/Page/Table"), {640, 900}},
          {"rollouts_paths", PanelId::kRollouts, with_failures(), open("Rollouts/Page/Paths"), {640, 1100}},
          {"export_sources", PanelId::kExport, with_film(), {}, {640, 900}},
          {"export_look", PanelId::kExport, with_film(), open("Export/Page/Look"), {640, 900}},
          {"export_file", PanelId::kExport, with_film(), open("Export/Page/File"), {640, 900}},
          {"export_queue", PanelId::kExport, with_film(), open("Export/Page/Queue")},
          {"rollouts_pair", PanelId::kRollouts, with_failures(), open("Rollouts/Page/Two models"), {640, 900}}};
}

}  // namespace

TEST_CASE("forms, palette, help and a take look as in their golden pictures, dark at 100 % and light at 200 %") {
  for (const Scene& scene : scenes()) {
    for (const auto& [theme, scale] : {std::pair{ThemeKind::kDark, 1.0F}, std::pair{ThemeKind::kLight, 2.0F}}) {
      compare(fmt::format("{}_{}_{:.0f}", scene.name, name_of(theme), 100.0F * scale),
              picture_of(scene.panel, scene.state, theme, scale, scene.prepare, scene.size));
    }
  }
}

TEST_CASE("so does a handful of windows in high contrast") {
  constexpr ThemeKind kTheme = ThemeKind::kHighContrast;
  const WorkbenchState ready = with_model_of(testing::made_state().project->demonstrations.at({1})->hash());
  for (const PanelId panel : {PanelId::kLibrary, PanelId::kTimeline, PanelId::kEdits, PanelId::kFields}) {
    compare(file_name(panel, "ready", kTheme, 1.0F), picture_of(panel, ready, kTheme, 1.0F));
  }
  for (const Scene& scene : scenes()) {
    const std::string name = scene.name;
    if (name != "record_form" && name != "palette" && name != "take_recording" && name != "take_review") continue;
    compare(name + "_high_contrast_100", picture_of(scene.panel, scene.state, kTheme, 1.0F, scene.prepare, scene.size));
  }
}

TEST_CASE("every panel looks in every state as in its golden picture, dark at 100 % and light at 200 %") {
  for (std::size_t i = 0; i < kPanelCount; ++i) {
    const auto panel = static_cast<PanelId>(i);
    for (const PanelState& state : panel_states()) {
      for (const auto& [theme, scale] : {std::pair{ThemeKind::kDark, 1.0F}, std::pair{ThemeKind::kLight, 2.0F}}) {
        compare(file_name(panel, state.name, theme, scale), picture_of(panel, state.shown, theme, scale));
      }
    }
  }
}

TEST_CASE("the golden test can fail: another selected demonstration is outside of the tolerance") {
  WorkbenchState other = testing::made_state_with_model();
  const Image right = picture_of(PanelId::kLibrary, other, ThemeKind::kDark, 1.0F);
  other.demonstration = {2};
  const Image wrong = picture_of(PanelId::kLibrary, other, ThemeKind::kDark, 1.0F);
  CHECK_FALSE(testing::alike(difference(right, wrong)));
}
