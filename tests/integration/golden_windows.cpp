// Every panel in every state, in two themes and at two scales, against tests/golden/windows/*.png.
// Run with TROCAR_BLESS=1 to write them anew, look at them, and say why.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "engine/core/file.h"
#include "engine/media/picture_file.h"
#include "tests/support/ui_state.h"
#include "ui/driver/driver.h"
#include "ui/session.h"
#include "ui/window/osmesa_window.h"

using namespace trocar;
using namespace trocar::ui;
using workbench::LoadState;

namespace {

// Pictures were the same to the byte on one CPU; another one may round the edge of a letter differently.
constexpr double kMeanLimit = 0.25;
constexpr int kWorstLimit = 64;

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

Image picture_of(PanelId panel, const WorkbenchState& state, ThemeKind theme, float scale) {
  const auto px = [scale](int at_100) { return static_cast<int>(scale * static_cast<float>(at_100)); };
  auto window = OsmesaWindow::create({px(640), px(560)});
  REQUIRE(window);
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
  return session->window().capture().value();
}

void compare(const std::string& name, const Image& image) {
  CAPTURE(name);
  const std::filesystem::path path = share_path("tests/golden/windows") / (name + ".png");
  if (std::getenv("TROCAR_BLESS") != nullptr) REQUIRE(media::write_png(path, image));
  const Result<Image> golden = media::read_picture(path);
  REQUIRE(golden);
  const ImageDifference apart = difference(image, *golden);
  CHECK(apart.mean <= kMeanLimit);
  CHECK(apart.worst <= kWorstLimit);
}

}  // namespace

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
  const ImageDifference apart = difference(right, wrong);
  CHECK((apart.mean > kMeanLimit || apart.worst > kWorstLimit));
}
