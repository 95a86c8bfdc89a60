// What people do to tiles: any sequence keeps a layout whole; drags, keys, names and the way back.
#include "ui/layouts.h"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <string>

#include "tests/support/ui_desk.h"
#include "ui/tile_moves.h"

namespace trocar::ui {
namespace {

bool whole_tile(const Tile& tile) {
  if (tile.kind == Tile::Kind::kTabs) {
    return !tile.panels.empty() && tile.children.empty() && tile.active >= 0 &&
           tile.active < static_cast<int>(tile.panels.size());
  }
  const float sum = std::accumulate(tile.shares.begin(), tile.shares.end(), 0.0F);
  const bool nested = std::any_of(tile.children.begin(), tile.children.end(),
                                  [&](const Tile& child) { return child.kind == tile.kind; });
  return tile.children.size() >= 2 && tile.shares.size() == tile.children.size() && std::abs(sum - 1.0F) < 1e-3F &&
         !nested && std::all_of(tile.children.begin(), tile.children.end(), whole_tile);
}

bool hidden_only_at_sides(const Tile& root) {
  std::size_t hidden = 0;
  for (std::size_t i = 0; i < root.children.size(); ++i) {
    const Tile& child = root.children[i];
    if (!child.hidden) continue;
    ++hidden;
    if (root.kind != Tile::Kind::kRow || (i != 0 && i + 1 != root.children.size())) return false;
  }
  return hidden == 0 || hidden < root.children.size();
}

void check_whole(const Tile& root) {
  RC_ASSERT(whole_tile(root));
  RC_ASSERT(!root.hidden);
  RC_ASSERT(hidden_only_at_sides(root));
  const auto panels = panels_of(root);
  RC_ASSERT(!panels.empty());
  RC_ASSERT(std::set<PanelId>(panels.begin(), panels.end()).size() == panels.size());
  const std::string json = to_json(root);
  const Result<Tile> read = tile_from_json(json);
  RC_ASSERT(read.has_value());
  RC_ASSERT(panels_of(*read) == panels);
}

PanelId any_panel() {
  return static_cast<PanelId>(*rc::gen::inRange(0, static_cast<int>(kPanelCount)));
}

Side any_side() {
  return static_cast<Side>(*rc::gen::inRange(0, 4));
}

Tile any_act(const Tile& root) {
  switch (*rc::gen::inRange(0, 7)) {
    case 0:
      return dropped(root, any_panel(), {any_panel(), any_side(), -1});
    case 1:
      return dropped(root, any_panel(), {any_panel(), {}, *rc::gen::inRange(-1, 12)});
    case 2:
      return moved(root, any_panel(), any_side());
    case 3:
      return closed(root, any_panel());
    case 4:
      return opened(root, any_panel(), default_layout(Workspace::kAuthor));
    case 5:
      return with_side_toggled(root, *rc::gen::arbitrary<bool>() ? Side::kLeft : Side::kRight);
    default:
      return equalised(root, any_panel());
  }
}

Tile tabs(std::vector<PanelId> panels) {
  Tile tile;
  tile.panels = std::move(panels);
  return tile;
}

Tile row(std::vector<Tile> children) {
  Tile tile;
  tile.kind = Tile::Kind::kRow;
  tile.shares.assign(children.size(), 1.0F / static_cast<float>(children.size()));
  tile.children = std::move(children);
  return tile;
}

const Tile& layout_of(const Desk& desk) {
  const Settings& settings = desk.session->settings();
  return settings.layouts[static_cast<std::size_t>(settings.workspace)];
}

std::vector<PanelId> beside(const Desk& desk, PanelId panel) {
  const Tile* tile = find_panel(layout_of(desk), panel);
  return tile == nullptr ? std::vector<PanelId>{} : tile->panels;
}

}  // namespace

TEST_CASE("any sequence of acts keeps each panel at most once, no tile empty, shares of 1, and reads back as written") {
  CHECK(rc::check([] {
    Tile root = default_layout(static_cast<Workspace>(*rc::gen::inRange(0, static_cast<int>(kWorkspaceCount))));
    const int acts = *rc::gen::inRange(1, 30);
    for (int i = 0; i < acts; ++i) {
      root = any_act(root);
      check_whole(root);
    }
  }));
}

TEST_CASE("opening what was closed brings every panel back, whatever was done before") {
  CHECK(rc::check([] {
    Tile root = default_layout(Workspace::kFields);
    const int acts = *rc::gen::inRange(0, 20);
    for (int i = 0; i < acts; ++i) root = any_act(root);
    for (std::size_t i = 0; i < kPanelCount; ++i) {
      root = opened(root, static_cast<PanelId>(i), default_layout(Workspace::kFields));
    }
    check_whole(root);
    RC_ASSERT(panels_of(root).size() == kPanelCount);
  }));
}

TEST_CASE("tiles fill the window without a gap after any sequence of acts") {
  CHECK(rc::check([] {
    Tile root = default_layout(Workspace::kLibrary);
    const int acts = *rc::gen::inRange(1, 20);
    for (int i = 0; i < acts; ++i) root = any_act(root);
    double area = 0.0;
    for (const PlacedTile& placed : place(root, {0, 0, 4000, 3000}, {0, 0, 0}).tiles) {
      area += static_cast<double>(placed.rect.width()) * placed.rect.height();
    }
    RC_ASSERT(std::abs(area - 12e6) < 12e3);
  }));
}

TEST_CASE("a panel dropped on the edge of a tile gets half of it, on its middle a tab") {
  using enum PanelId;
  const Tile root = row({tabs({kLibrary, kLog}), tabs({kView})});
  const Tile split = dropped(root, kLog, {kView, Side::kDown, -1});
  REQUIRE(split.children.size() == 2);
  CHECK(split.children[0].panels == std::vector{kLibrary});
  CHECK(split.children[1].kind == Tile::Kind::kColumn);
  CHECK(split.children[1].children[1].panels == std::vector{kLog});
  CHECK(split.children[1].shares == std::vector{0.5F, 0.5F});
  const Tile tab = dropped(root, kLog, {kView, {}, 0});
  CHECK(tab.children[1].panels == std::vector{kLog, kView});
  CHECK(tab.children[1].active == 0);
  const Tile reordered = dropped(root, kLog, {kLibrary, {}, 0});
  CHECK(reordered.children[0].panels == std::vector{kLog, kLibrary});
}

TEST_CASE("a tile that loses its last panel goes, and a panel alone cannot be split from itself or closed") {
  using enum PanelId;
  const Tile root = row({tabs({kLibrary}), tabs({kView})});
  const Tile one = dropped(root, kLibrary, {kView, {}, -1});
  CHECK(one.kind == Tile::Kind::kTabs);
  CHECK(one.panels == std::vector{kView, kLibrary});
  CHECK(same_places(dropped(root, kView, {kView, Side::kLeft, -1}), root));
  CHECK(same_places(closed(tabs({kView}), kView), tabs({kView})));
}

TEST_CASE("moved sideways a panel goes into the neighbour, and at the edge into a tile of its own") {
  using enum PanelId;
  const Tile root = row({tabs({kLibrary, kLog}), tabs({kView})});
  CHECK(moved(root, kLog, Side::kRight).children[1].panels == std::vector{kView, kLog});
  const Tile edge = moved(root, kLog, Side::kLeft);
  REQUIRE(edge.children.size() == 3);
  CHECK(edge.children[0].panels == std::vector{kLog});
  CHECK(same_places(moved(edge, kLog, Side::kLeft), edge));
  CHECK(moved(root, kLog, Side::kUp).kind == Tile::Kind::kColumn);
}

TEST_CASE("a side that is put away gives its room to the others, and comes back when a panel of it is opened") {
  Tile root = default_layout(Workspace::kAuthor);
  Tile less = with_side_toggled(root, Side::kLeft);
  const auto placed = place(less, {0, 0, 1600, 900}, {4, 0, 0});
  CHECK(placed.tiles.front().rect.x0 == 0.0F);
  CHECK(std::none_of(placed.tiles.begin(), placed.tiles.end(),
                     [](const PlacedTile& one) { return one.tile->panels.front() == PanelId::kLibrary; }));
  CHECK(same_places(with_side_toggled(less, Side::kLeft), root));
  CHECK(same_places(opened(less, PanelId::kLibrary, root), root));
  CHECK(same_places(tile_from_json(to_json(less)).value(), less));
  const PlacedSplitter& bar = placed.splitters.back();
  CHECK(bar.parent == &less);
  CHECK(bar.index == 1);
}

TEST_CASE("what is done to tiles can be undone and done again, each gesture as one step") {
  LayoutHistory history;
  const Tile first = default_layout(Workspace::kAuthor);
  const Tile second = closed(first, PanelId::kLog);
  history.settle(Workspace::kAuthor, first);
  history.settle(Workspace::kAuthor, second);
  history.settle(Workspace::kAuthor, second);
  CHECK_FALSE(history.undo(Workspace::kFields));
  CHECK(same_places(history.undo(Workspace::kAuthor).value(), first));
  CHECK_FALSE(history.undo(Workspace::kAuthor));
  CHECK(same_places(history.redo(Workspace::kAuthor).value(), second));
  CHECK_FALSE(history.redo(Workspace::kAuthor));
}

TEST_CASE("a tab that is dragged to the edge of a tile splits it, with a preview, and Escape leaves it") {
  Desk desk(testing::made_state());
  Driver driver = desk.driver();
  const Item tab = driver.item("Tabs/Curves").value();
  const Item view = driver.item("View/Picture").value();
  const float dx = view.rect.x1 - 20.0F - tab.rect.centre_x();
  const float dy = view.rect.centre_y() - tab.rect.centre_y();
  InputQueue& input = desk.window.input();
  const auto begin = [&] {
    input.push(MouseMoved{tab.rect.centre_x(), tab.rect.centre_y()});
    CHECK(driver.frames(2));
    input.push(MouseButton{0, true});
    CHECK(driver.frames(2));
    input.push(MouseMoved{tab.rect.centre_x() + dx, tab.rect.centre_y() + dy});
    CHECK(driver.frames(3));
  };
  begin();
  CHECK(text_of(driver.expect_value("Drop", "Curves right of View")) == "");
  CHECK(driver.key("Escape"));
  input.push(MouseButton{0, false});
  CHECK(driver.frames(3));
  CHECK(beside(desk, PanelId::kCurves).size() == 3);
  begin();
  input.push(MouseButton{0, false});
  CHECK(driver.frames(3));
  CHECK(beside(desk, PanelId::kCurves) == std::vector{PanelId::kCurves});
  CHECK(driver.key("Ctrl+Alt+U"));
  CHECK(driver.frames(3));
  CHECK(beside(desk, PanelId::kCurves).size() == 3);
  CHECK(driver.key("Ctrl+Shift+Alt+U"));
  CHECK(driver.frames(3));
  CHECK(beside(desk, PanelId::kCurves).size() == 1);
}

TEST_CASE("the keyboard moves, closes and opens panels and puts the sides away") {
  Desk desk(testing::made_state());
  Driver driver = desk.driver();
  CHECK(text_of(driver.hover("View/Picture")) == "");
  CHECK(driver.key("Ctrl+Shift+Alt+Right"));
  CHECK(driver.frames(3));
  CHECK(beside(desk, PanelId::kView).size() > 3);
  CHECK(text_of(driver.hover("Library/Record…")) == "");
  CHECK(driver.key("Ctrl+W"));
  CHECK(driver.frames(3));
  CHECK(beside(desk, PanelId::kLibrary).empty());
  CHECK(text_of(driver.click("Menu/View")) == "");
  CHECK(text_of(driver.click("View/Panels")) == "");
  CHECK(text_of(driver.click("Panels/Library panel")) == "");
  CHECK(driver.frames(3));
  CHECK_FALSE(beside(desk, PanelId::kLibrary).empty());
  CHECK(text_of(driver.expect_present("Tabs/Inspector", true)) == "");
  CHECK(driver.key("F10"));
  CHECK(driver.frames(3));
  CHECK(text_of(driver.expect_present("Tabs/Inspector", false)) == "");
  CHECK(driver.key("F10"));
  CHECK(driver.frames(3));
  CHECK(text_of(driver.expect_present("Tabs/Inspector", true)) == "");
}

TEST_CASE("a layout is kept by name, gone to, renamed, deleted and brought back") {
  Desk desk(testing::made_state());
  Driver driver = desk.driver();
  const Tile before = layout_of(desk);
  CHECK(driver.key("Ctrl+Shift+P"));
  CHECK(driver.frames(3));
  CHECK(desk.driver().item("Layouts/Save").value().reason == "Type a name");
  CHECK(text_of(driver.type("Layouts/Name", "Wide")) == "");
  CHECK(text_of(driver.click("Layouts/Save")) == "");
  CHECK(driver.frames(2));
  CHECK(driver.key("Escape"));
  CHECK(driver.key("F9"));
  CHECK(driver.frames(3));
  CHECK_FALSE(same_places(layout_of(desk), before));
  CHECK(driver.key("Ctrl+Shift+P"));
  CHECK(driver.frames(3));
  CHECK(text_of(driver.click("Layouts/Named/Wide/Show")) == "");
  CHECK(driver.frames(2));
  CHECK(same_places(layout_of(desk), before));
  CHECK(text_of(driver.click("Layouts/Named/Wide/Rename")) == "");
  CHECK(text_of(driver.type("Rename layout/New name", "Broad")) == "");
  CHECK(text_of(driver.click("Rename layout/Rename")) == "");
  CHECK(driver.frames(2));
  CHECK(desk.session->settings().named_layouts().front().name == "Broad");
  CHECK(text_of(driver.click("Layouts/Named/Broad/Delete")) == "");
  CHECK(driver.frames(2));
  CHECK(desk.session->settings().named_layouts().empty());
  CHECK(text_of(driver.click("Layouts/Bring it back")) == "");
  CHECK(driver.frames(2));
  CHECK(desk.session->settings().named_layouts().size() == 1);
}

TEST_CASE("F1 explains the panel under the pointer, and every panel has a page") {
  Desk desk(testing::made_state());
  Driver driver = desk.driver();
  CHECK(text_of(driver.hover("Library/Record…")) == "");
  CHECK(driver.key("F1"));
  CHECK(driver.frames(3));
  CHECK(text_of(driver.expect_present("Help/Commands/Record…", true)) == "");
  CHECK(driver.key("Escape"));
  CHECK(text_of(driver.hover("Timeline/Lanes")) == "");
  CHECK(driver.key("F1"));
  CHECK(driver.frames(3));
  CHECK(text_of(driver.expect_present("Help/Mouse/Trim", true)) == "");
}

}  // namespace trocar::ui
