#include "engine/exchange/map_presets.h"

#include <doctest/doctest.h>

#include "engine/core/file.h"
#include "engine/exchange/table_preview.h"
#include "tests/support/scratch_folder.h"

using namespace trocar;
using namespace trocar::exchange;
using testing::ScratchFolder;

TEST_CASE("a map that was kept under a name comes back as it was") {
  const ScratchFolder folder;
  ColumnMap map;
  map.delimiter.assign(1, ';');
  map.time.rate_hz = 30.0;
  map.arms[1].position = PositionColumns{{"x", "y", "#3"}, "mm"};
  map.frame.mirror.assign(1, 'y');
  CHECK(map_presets(folder / "maps").empty());
  REQUIRE(save_map_preset(folder / "maps", "Tracker of the lab", map));
  REQUIRE(save_map_preset(folder / "maps", "Another", map));
  CHECK(map_presets(folder / "maps") == std::vector<std::string>{"Another", "Tracker of the lab"});
  const auto back = load_map_preset(folder / "maps", "Tracker of the lab");
  REQUIRE(back);
  CHECK(to_json(*back) == to_json(map));
}

TEST_CASE("a name that would lead out of the folder is refused") {
  const ScratchFolder folder;
  for (const char* name : {"", "../a", ".hidden", "a/b", "a\\b", "a\nb"}) {
    CAPTURE(name);
    CHECK_FALSE(reason_against_preset(name).empty());
    CHECK_FALSE(save_map_preset(folder / "maps", name, ColumnMap{}));
    CHECK_FALSE(load_map_preset(folder / "maps", name));
  }
}

TEST_CASE("a preset that is not there is said by its name") {
  const ScratchFolder folder;
  const auto none = load_map_preset(folder / "maps", "Tracker");
  REQUIRE_FALSE(none);
  CHECK(none.error().text() == "no map of columns is kept as \"Tracker\"");
}

TEST_CASE("the columns of a table are named as a map names them, with their first cells") {
  const ScratchFolder folder;
  REQUIRE(write_file(folder / "a.csv", "t;x;x;\n0,5;1;2;a\n1;3;4;b\n"));
  ColumnMap map;
  map.delimiter.assign(1, ';');
  map.decimal.assign(1, ',');
  const auto columns = table_columns(folder / "a.csv", Format::kCsv, map);
  REQUIRE(columns);
  REQUIRE(columns->size() == 4);
  CHECK((*columns)[0].name == "t");
  CHECK((*columns)[0].cells == std::vector<std::string>{"0.5", "1"});
  // Two are called x, and one has no name: their places are sure.
  CHECK((*columns)[1].name == "#2");
  CHECK((*columns)[3].name == "#4");
  CHECK((*columns)[3].cells.front() == "–");
}
