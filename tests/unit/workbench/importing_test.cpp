#include "engine/workbench/importing.h"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include "engine/core/file.h"
#include "tests/support/project_fixture.h"

using namespace trocar;
using namespace trocar::workbench;
using testing::created;
using testing::opened;
using testing::ScratchFolder;

namespace {

/// 30 Hz in millimetres, with a second missing in the middle.
std::string table() {
  std::string text = "time_s,left_x_mm,left_y_mm,left_z_mm\n";
  for (int i = 0; i < 60; ++i) {
    text += fmt::format("{:.4f},{},-20,30\n", i / 30.0 + (i > 30 ? 1.0 : 0.0), 0.1 * i);
  }
  return text;
}

ImportSettings settings_of(const std::filesystem::path& path) {
  ImportSettings settings;
  settings.path = path;
  return settings;
}

std::shared_ptr<const ImportView> looked_at(ImportSettings settings) {
  Progress progress;
  return view_of_import(std::move(settings), "2026-03-01T12:00:00Z", progress);
}

}  // namespace

TEST_CASE("a foreign table is shown with its columns, a proposed map and what was found in it") {
  const ScratchFolder folder;
  REQUIRE(write_file(folder / "hand.csv", table()));
  const auto view = looked_at(settings_of(folder / "hand.csv"));
  CHECK(view->error.empty());
  CHECK(view->columns.size() == 4);
  CHECK(view->layout.proposed);
  REQUIRE(view->parts.size() == 1);
  CHECK(view->parts[0].name == "hand");
  const auto& found = view->parts[0].found;
  CHECK(
      std::any_of(found.begin(), found.end(), [](const auto& one) { return one.find("1 gap") != std::string::npos; }));
}

TEST_CASE("a table that nothing is recognised in has an empty map to be filled in") {
  const ScratchFolder folder;
  REQUIRE(write_file(folder / "odd.csv", "p,q,r\n3,1,2\n2,2,2\n4,1,3\n"));
  auto view = looked_at(settings_of(folder / "odd.csv"));
  CHECK_FALSE(view->error.empty());
  CHECK(view->parts.empty());
  REQUIRE(view->layout.columns);
  CHECK(view->columns.size() == 3);
  ImportSettings settings = view->settings;
  settings.map = view->layout.columns->map;
  settings.map->arms[0].position = exchange::PositionColumns{{"p", "q", "r"}, "mm"};
  view = looked_at(settings);
  CHECK(view->error == "");
  CHECK(view->parts.size() == 1);
}

TEST_CASE("a file that cannot be read says why, and where") {
  const ScratchFolder folder;
  REQUIRE(write_file(folder / "bad.csv", "time_s,left_x_mm,left_y_mm,left_z_mm\n0,1,2,3\n1,here,2,3\n2,1,2,3\n"));
  ImportSettings settings = settings_of(folder / "bad.csv");
  settings.map.emplace();
  settings.map->time.column = "time_s";
  settings.map->arms[0].position = exchange::PositionColumns{{"left_x_mm", "left_y_mm", "left_z_mm"}, "mm"};
  const auto view = looked_at(settings);
  CHECK(view->parts.empty());
  CHECK(view->error.find("line 3") != std::string::npos);
  CHECK(view->error.find("bad.csv") != std::string::npos);
}

TEST_CASE("several demonstrations come in as one step, each with its own id, and stay so") {
  const ScratchFolder folder;
  REQUIRE(write_file(folder / "hand.csv", table()));
  const auto view = looked_at(settings_of(folder / "hand.csv"));
  std::vector<ImportPart> parts{view->parts.at(0), view->parts.at(0), view->parts.at(0)};
  parts[1].notes.push_back({"a gesture", 0.1, 0.2, "gesture", 0});
  parts[1].notes.push_back({"another", 0.3, 0.4, "gesture", 0});
  std::uint64_t hash = 0;
  {
    ProjectFile file = created(folder / "p.trocar");
    testing::add_demonstration(file, 10, "hand");
    give_free_names(parts, *file.project());
    CHECK(parts[0].name == "hand 2");
    CHECK(parts[2].name == "hand 4");
    const std::uint64_t before = file.project()->hash();
    const auto ids = add_parts(file, folder / "hand.csv", parts);
    REQUIRE(ids);
    CHECK(*ids == std::vector<DemonstrationId>{{2}, {3}, {4}});
    CHECK(file.history().back().description == "Import 3 demonstrations from hand.csv");
    CHECK(file.project()->demonstrations.at({3})->notes.size() == 2);
    hash = file.project()->hash();
    REQUIRE(file.undo());
    CHECK(file.project()->hash() == before);
    REQUIRE(file.redo());
    CHECK(file.project()->hash() == hash);
    // The next edit's id is none of theirs.
    CHECK(testing::add_demonstration(file, 10, "next") == DemonstrationId{5});
    REQUIRE(file.undo());
  }
  const ProjectFile file = opened(folder / "p.trocar");
  CHECK(file.project()->hash() == hash);
  CHECK(file.recovered() == 0);
}

TEST_CASE("an import is in the journal as it is in memory") {
  ImportDemonstrations import{"a.hdf5", {{{7}, "demo_0", {demonstration::AddNote{"x", 0.0, 1.0, "gesture", 0}}}}};
  const auto back = edit_from_json(ImportDemonstrations::kName, to_json(Edit{import}));
  REQUIRE(back);
  CHECK(to_json(*back) == to_json(Edit{import}));
  CHECK_FALSE(edit_from_json(ImportDemonstrations::kName, R"({"file": "a", "parts": [1]})"));
  CHECK_FALSE(edit_from_json(ImportDemonstrations::kName, R"({"file": "a"})"));
}

TEST_CASE("times that jitter and gaps as short as the checks count them are said, and the rate as it is") {
  const ScratchFolder folder;
  const auto found_in = [&](double rate_hz, double jitter_s, int lost) {
    std::string text = "time_s,left_x_mm,left_y_mm,left_z_mm\n";
    for (int i = 0; i < 200; ++i) {
      if (i == lost) continue;
      text += fmt::format("{:.4f},{},-20,30\n", i / rate_hz + (i % 3 == 1 ? jitter_s : 0.0), 0.1 * i);
    }
    CHECK(write_file(folder / "hand.csv", text));
    std::string all;
    const auto view = looked_at(settings_of(folder / "hand.csv"));
    for (const std::string& each : view->parts.at(0).found) all += each + "\n";
    return all;
  };
  const std::string even = found_in(30.0, 0.0, -1);
  CHECK(even.find("30 samples a second\n") == 0);
  CHECK(even.find("unevenly") == std::string::npos);
  CHECK(even.find("gap") == std::string::npos);
  CHECK(found_in(30.0, 0.004, -1).find("samples come unevenly: 9 of 10 are 30 to 37 ms") != std::string::npos);
  CHECK(found_in(30.0, 0.0, 100).find("1 gap, the longest 0.07 s at 3.30 s") != std::string::npos);
  CHECK(found_in(62.5, 0.0, -1).find("62.5 samples a second\n") == 0);
}
