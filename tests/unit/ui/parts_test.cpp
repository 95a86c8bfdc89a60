#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <optional>

#include "engine/core/file.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/ui_state.h"
#include "ui/command_table.h"
#include "ui/command_text.h"
#include "ui/driver/script.h"
#include "ui/format.h"
#include "ui/panels/time_range.h"
#include "ui/panels/time_snap.h"
#include "ui/settings.h"
#include "ui/shortcut.h"
#include "ui/theme.h"
#include "ui/tile_tree.h"
#include "ui/timeline_steps.h"
#include "ui/window/input.h"

namespace trocar::ui {

TEST_CASE("text on every ground of every theme has a contrast of at least 4.5 to 1") {
  for (const ThemeKind kind : kThemeKinds) {
    const Theme theme = make_theme(kind);
    CAPTURE(name_of(kind));
    for (const Rgba ground : {theme.panel, theme.header, theme.raised, theme.selection}) {
      CHECK(contrast(theme.text, ground) >= 4.5);
    }
    for (const Rgba words : {theme.text_dim, theme.good, theme.warning, theme.danger}) {
      CHECK(contrast(words, theme.panel) >= 4.5);
      CHECK(contrast(words, mix(theme.panel, words, kBadgeTint)) >= 4.5);
      CHECK(contrast(words, mix(theme.panel, theme.raised, 0.35F)) >= 4.5);  // forms and the palette
    }
    CHECK(contrast(theme.text_dim, theme.header) >= 4.5);
    CHECK(contrast(theme.on_accent, theme.accent_fill) >= 4.5);
    CHECK(contrast(theme.on_accent, theme.danger_fill) >= 4.5);
  }
  for (int i = 0; i < demonstration::kSegmentCount; ++i) {
    CHECK(contrast({16, 18, 21, 255}, segment_colour(static_cast<demonstration::Segment>(i))) >= 4.5);
  }
}

TEST_CASE("contrast of black and white is 21, of equals 1") {
  CHECK(contrast({0, 0, 0, 255}, {255, 255, 255, 255}) == doctest::Approx(21.0));
  CHECK(contrast({90, 90, 90, 255}, {90, 90, 90, 255}) == doctest::Approx(1.0));
}

TEST_CASE("a chord is the same after being written and read") {
  for (const char* words : {"Ctrl+Shift+T", "Space", "Alt+1", "F12", "Ctrl+=", "Shift+Delete", "Ctrl+-", "Left"}) {
    CHECK(to_text(chord_from(words).value()) == words);
  }
  CHECK_FALSE(chord_from("Ctrl+Nothing"));
  CHECK_FALSE(chord_from("Super+A"));
  CHECK_FALSE(chord_from(""));
}

TEST_CASE("every key of the command table is a chord and means one command in each context") {
  std::map<std::string_view, std::vector<Chord>> seen_in;
  for (const CommandRow& row : command_table()) {
    std::vector<Chord>& seen = seen_in[row.context];
    for (const std::string_view keys : row.keys) {
      CAPTURE(keys);
      const Result<Chord> chord = chord_from(keys);
      REQUIRE(chord);
      CHECK(std::find(seen.begin(), seen.end(), *chord) == seen.end());
      seen.push_back(*chord);
    }
  }
}

TEST_CASE("a press and a release that arrive together are seen in two frames") {
  ImGuiContext* context = ImGui::CreateContext();
  ImGui::SetCurrentContext(context);
  InputQueue input;
  input.push(MouseButton{0, true});
  input.push(MouseButton{0, false});
  input.apply(ImGui::GetIO());
  CHECK(input.pending());
  CHECK(ImGui::GetIO().MouseDown[0]);
  input.apply(ImGui::GetIO());
  CHECK_FALSE(ImGui::GetIO().MouseDown[0]);
  CHECK_FALSE(input.pending());
  ImGui::DestroyContext(context);
}

TEST_CASE("tiles and gaps fill the window without overlap") {
  for (std::size_t i = 0; i < kWorkspaceCount; ++i) {
    Tile root = default_layout(static_cast<Workspace>(i));
    const Placement placement = place(root, {0, 0, 1600, 900}, {});
    double area = 0.0;
    for (const PlacedTile& placed : placement.tiles)
      area += static_cast<double>(placed.rect.width()) * placed.rect.height();
    for (const PlacedSplitter& bar : placement.splitters)
      area += static_cast<double>(bar.rect.width()) * bar.rect.height();
    CHECK(area == doctest::Approx(1600.0 * 900.0));
  }
}

TEST_CASE("tiles keep their least size, and neighbours without room for it become one tab group") {
  const PlaceOptions options{4.0F, 250.0F, 160.0F};
  for (std::size_t i = 0; i < kWorkspaceCount; ++i) {
    for (const Rect window :
         {Rect{0, 0, 1600, 800}, Rect{0, 0, 800, 340}, Rect{0, 0, 533, 190}, Rect{0, 0, 260, 170}}) {
      Tile root = default_layout(static_cast<Workspace>(i));
      const Placement placement = place(root, window, options);
      std::size_t panels = 0;
      for (const PlacedTile& placed : placement.tiles) {
        CHECK(placed.rect.width() >= 249.0F);
        CHECK(placed.rect.height() >= 159.0F);
        panels += placed.tile->panels.size();
      }
      CHECK(panels == kPanelCount);  // none is lost
      CHECK(placement.merged.empty() == (window.width() > 760.0F));
    }
  }
}

TEST_CASE("with little room the panels at the sides become tabs, and view and timeline stay in sight") {
  const PlaceOptions options{4.0F, 250.0F, 160.0F, 420.0F, 110.0F};
  // A window of 1280 by 800 at 200 % and at 150 %, without its bars.
  for (const Rect window : {Rect{0, 0, 640, 296}, Rect{0, 0, 853, 425}}) {
    for (const Workspace workspace : {Workspace::kAuthor, Workspace::kFields, Workspace::kRollouts}) {
      Tile root = default_layout(workspace);
      const Placement placement = place(root, window, options);
      std::optional<Rect> view;
      std::optional<Rect> timeline;
      std::size_t panels = 0;
      for (const PlacedTile& placed : placement.tiles) {
        panels += placed.tile->panels.size();
        if (placed.tile->panels.front() == PanelId::kView) view = placed.rect;
        if (placed.tile->panels.front() == PanelId::kTimeline) timeline = placed.rect;
      }
      CHECK(panels == kPanelCount);
      REQUIRE(view);
      REQUIRE(timeline);
      CHECK(view->y1 <= timeline->y0);
      CHECK(view->height() >= 110.0F);
      CHECK(timeline->height() >= 159.0F);
      CHECK(timeline->width() >= 420.0F);
      // All that was at the sides is one tab group beside them, or joins the timeline where even that has no room.
      CHECK(placement.tiles.size() == (window.width() > 700.0F ? 3 : 2));
    }
  }
}

TEST_CASE("a splitter moves to the mouse and keeps room for both sides") {
  Tile root = default_layout(Workspace::kAuthor);
  Placement placement = place(root, {0, 0, 1600, 900}, {});
  const auto first_column = [&root] { return place(root, {0, 0, 1600, 900}, {}).tiles.front().rect.x1; };
  const auto& bar = *std::find_if(placement.splitters.begin(), placement.splitters.end(),
                                  [&](const PlacedSplitter& s) { return s.parent == &root && s.index == 0; });
  move_splitter(bar, 500.0F, 200.0F);
  CHECK(first_column() == doctest::Approx(500.0F).epsilon(0.01));
  move_splitter(bar, 10.0F, 200.0F);
  CHECK(first_column() == doctest::Approx(200.0F).epsilon(0.02));
}

TEST_CASE("a layout survives being written and read, and a broken one is refused") {
  for (std::size_t i = 0; i < kWorkspaceCount; ++i) {
    const std::string json = to_json(default_layout(static_cast<Workspace>(i)));
    CHECK(to_json(tile_from_json(json).value()) == json);
  }
  for (const char* broken : {"", "[]", "{}", R"({"tabs":[]})", R"({"tabs":["Nothing"]})",
                             R"({"row":[{"tabs":["View"]}],"shares":[0.5,0.5]})", R"({"row":[],"shares":[]})"}) {
    CHECK_FALSE(tile_from_json(broken));
  }
}

TEST_CASE("a computation's time has a unit in which it is not nought") {
  CHECK(elapsed(0.0052) == "5.2 ms");
  CHECK(elapsed(0.34) == "340 ms");
  CHECK(elapsed(12.4) == "12.40 s");
}

TEST_CASE("settings survive being written and read, and nonsense keeps the defaults") {
  Settings settings;
  settings.scale = 1.5F;
  settings.theme = ThemeKind::kHighContrast;
  settings.workspace = Workspace::kFields;
  settings.window = {1280, 800};
  settings.recent = {"/a.trocar"};
  settings.hidden_lanes = 0b100101;
  settings.keys = with_chords({KeyPreset::kNle, {}}, "edit.undo", {chord_from("F5").value()});
  settings.layouts[1] = closed(settings.layouts[1], PanelId::kLog);
  settings.named[1] = {{"Wide", with_side_toggled(settings.layouts[1], Side::kLeft)}};
  Diagnostics odd;
  CHECK(settings_from_json(to_json(settings), odd).value().hidden_lanes == 0b100101);
  CHECK(to_json(settings_from_json(to_json(settings), odd).value()) == to_json(settings));
  CHECK(to_json(
            settings_from_json(R"({"scale":"big","theme":7,"layouts":[],"window":[1],"workspace":9})", odd).value()) ==
        to_json(Settings{}));
  CHECK(odd.warnings().empty());
  CHECK_FALSE(settings_from_json("no", odd));
}

TEST_CASE("settings that cannot be read are kept beside, and said to be broken") {
  const testing::ScratchFolder folder;
  const std::filesystem::path path = folder / "workbench.json";
  std::ofstream(path) << "{\"scale\": 2,}";
  Diagnostics odd;
  CHECK(to_json(load_settings(path, odd)) == to_json(Settings{}));
  REQUIRE(odd.warnings().size() == 1);
  CHECK(odd.warnings().front().find("workbench.json.broken") != std::string::npos);
  CHECK(read_file((folder / "workbench.json.broken").string()).value() == "{\"scale\": 2,}");
  std::ofstream(path) << R"({"theme":"light","layouts":{"Author":{"tabs":["Nothing"]}}})";
  Diagnostics layout;
  CHECK(load_settings(path, layout).theme == ThemeKind::kLight);
  CHECK(layout.warnings() == std::vector<std::string>{"in the settings, of the workspace Author, the layout is broken: "
                                                      "an unknown panel; it was left out"});
}

TEST_CASE("a script is parsed with quotes and comments, and an error names its line") {
  const auto lines = parse_script("# first\nclick \"Library/Record…\"  # then\n\nwait idle 30\nkey Ctrl+P").value();
  REQUIRE(lines.size() == 3);
  CHECK(lines[0].number == 2);
  CHECK(lines[0].words == std::vector<std::string>{"click", "Library/Record…"});
  CHECK(lines[2].number == 5);
  for (const char* broken : {"klick x", "click", "drag a b c", "expect a value", "wait", "frames many", "click \"a"}) {
    CAPTURE(broken);
    const auto parsed = parse_script(std::string("\n") + broken);
    REQUIRE_FALSE(parsed);
    CHECK(parsed.error().text().find("line 2") != std::string::npos);
  }
}

TEST_CASE("zooming a time range keeps the time under the mouse in place") {
  TimeRange range{0.0, 10.0};
  const float before = range.x_of(7.0, 100.0F, 500.0F);
  range.zoom(7.0, 0.5);
  CHECK(range.x_of(7.0, 100.0F, 500.0F) == doctest::Approx(before));
  CHECK(range.span_s() == doctest::Approx(5.0));
  CHECK(range.time_at(before, 100.0F, 500.0F) == doctest::Approx(7.0));
  range.zoom(0.0, 1000.0);
  range.keep_within(10.0);
  CHECK(range.span_s() == doctest::Approx(10.6));
}

TEST_CASE("marks of the ruler are round and not too close") {
  CHECK(ruler_step({0.0, 10.0}, 500.0F, 60.0F) == doctest::Approx(2.0));
  CHECK(ruler_step({0.0, 1.0}, 500.0F, 60.0F) == doctest::Approx(0.2));
}

TEST_CASE("the playhead steps by samples, within the gates") {
  const auto state = testing::made_state();
  const auto& shown = *state.project->demonstrations.at({1});
  CHECK(stepped(shown, 1.0, 1) == doctest::Approx(1.005));
  CHECK(stepped(shown, 0.0, -1) == 0.0);
  CHECK(stepped(shown, 7.0, 10) == doctest::Approx(7.0));
}

TEST_CASE("a shuttle turns about at once and goes faster with each press") {
  CHECK(shuttled(0.0, 1) == 1.0);
  CHECK(shuttled(0.25, 1) == 1.0);
  CHECK(shuttled(1.0, 1) == 2.0);
  CHECK(shuttled(32.0, 1) == 32.0);
  CHECK(shuttled(4.0, -1) == -1.0);
  CHECK(shuttled(-1.0, -1) == -2.0);
}

TEST_CASE("what is dragged goes to the nearest place within reach, else to a sample") {
  const std::vector<double> places{1.0, 1.1, 3.0};
  CHECK(nearest_place(places, 1.06, 0.1) == 1.1);
  CHECK(nearest_place(places, 1.04, 0.1) == 1.0);
  CHECK_FALSE(nearest_place(places, 2.0, 0.5));
  CHECK(at_sample(1.2362) == doctest::Approx(1.235));
}

TEST_CASE("numbers read as people write them") {
  CHECK(count(2480) == "2,480");
  CHECK(count(-1234567) == "−1,234,567");
  CHECK(time_code(59.96) == "1:00.0");
  CHECK(time_code(3723.4) == "1:02:03.4");
  CHECK(percent(1, 3) == "33 %");
  CHECK(percent(1, 1) == "100 %");
  CHECK(percent(293, 294) == "99.7 %");
  CHECK(percent(10646, 10648) == ">99.9 %");
  CHECK(percent(1, 10648) == "<0.1 %");
  CHECK(percent(0, 0) == "–");
  CHECK(number(-0.5) == "−0.5");
  CHECK(number(std::nan("")) == "–");
}

TEST_CASE("an act is said as the command line would say it") {
  const auto state = testing::made_state();
  workbench::RecordScripted record;
  record.options.seed = 7;
  record.name = "it's mine";
  CHECK(command_text(workbench::Command{record}, state) ==
        "trocar demo record /data/pegs.trocar --operator scripted --skill expert --seed 7 --block 0 --goal 0 --name "
        "'it'\\''s mine'");
  CHECK(command_text(workbench::Command{workbench::GoToHistory{7}}, state) ==
        "trocar history /data/pegs.trocar --go 7");
  CHECK(command_text(workbench::Command{workbench::Play{1.0}}, state).empty());
}

}  // namespace trocar::ui
