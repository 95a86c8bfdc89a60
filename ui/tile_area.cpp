#include "ui/tile_area.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "ui/panels/common.h"

namespace trocar::ui {
namespace {

// What the tabs of a strip show: less where it is narrow.
enum class TabWords : std::uint8_t { kIconAndTitle, kTitle, kIcons, kIconsOnly };

std::string words_of_tab(PanelId panel, bool active, TabWords detail) {
  const bool title_only = detail == TabWords::kTitle || (detail == TabWords::kIcons && active);
  if (title_only) return std::string(title(panel));
  if (detail != TabWords::kIconAndTitle) return icon_of(panel);
  return std::string(icon_of(panel)) + "  " + std::string(title(panel));
}

float tab_margin(const Ui& ui, TabWords detail) {
  return detail == TabWords::kIconsOnly ? ui.px(6) : ui.px(11);
}

float least_tab(const Ui& ui) {
  return ui.px(24);
}

float tab_width(const Ui& ui, const std::string& words, TabWords detail) {
  return std::max(ImGui::CalcTextSize(words.c_str()).x + 2.0F * tab_margin(ui, detail), least_tab(ui));
}

TabWords tab_words(const Ui& ui, const Tile& tile, float room) {
  for (const TabWords detail : {TabWords::kIconAndTitle, TabWords::kTitle, TabWords::kIcons}) {
    float width = 0.0F;
    for (std::size_t i = 0; i < tile.panels.size(); ++i) {
      const bool active = static_cast<int>(i) == tile.active;
      width += tab_width(ui, words_of_tab(tile.panels[i], active, detail), detail);
    }
    if (width <= room) return detail;
  }
  return TabWords::kIconsOnly;
}

// Where even the icons are too many for one row, they stand in several, as evenly as they can.
std::size_t tabs_of_row(const Ui& ui, const Tile& tile, float room) {
  const std::size_t most = std::max<std::size_t>(1, static_cast<std::size_t>(room / least_tab(ui)));
  const std::size_t rows = (tile.panels.size() + most - 1) / most;
  return (tile.panels.size() + rows - 1) / rows;
}

std::size_t tab_rows(const Ui& ui, const Tile& tile, float room) {
  const std::size_t of_row = tabs_of_row(ui, tile, room);
  return (tile.panels.size() + of_row - 1) / of_row;
}

// The picture goes to the edge of its tile; everything else has a margin.
bool has_margin(PanelId panel, const WorkbenchState& state) {
  return panel != PanelId::kView || state.load != workbench::LoadState::kReady;
}

void draw_tab(const Ui& ui, const Rect& rect, const std::string& words, bool active, bool lit) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (active) {
    list.AddRectFilled({rect.x0, rect.y0}, {rect.x1, rect.y1}, to_u32(ui.theme().panel));
    list.AddRectFilled({rect.x0, rect.y0}, {rect.x1, rect.y0 + ui.px(2)}, to_u32(ui.theme().accent));
  }
  const Rgba colour = active || lit ? ui.theme().text : ui.theme().text_dim;
  const float y = std::round(rect.centre_y() - 0.5F * ImGui::GetFontSize());
  const float text = ImGui::CalcTextSize(words.c_str()).x;
  list.AddText({std::round(rect.x0 + 0.5F * (rect.width() - text)), y}, to_u32(colour), words.c_str());
}

std::string_view place_words(std::optional<Side> side) {
  if (!side) return "with";
  if (*side == Side::kLeft) return "left of";
  if (*side == Side::kRight) return "right of";
  return *side == Side::kUp ? "above" : "below";
}

Rect half_of(const Rect& rect, Side side) {
  Rect half = rect;
  if (side == Side::kLeft) half.x1 = rect.centre_x();
  if (side == Side::kRight) half.x0 = rect.centre_x();
  if (side == Side::kUp) half.y1 = rect.centre_y();
  if (side == Side::kDown) half.y0 = rect.centre_y();
  return half;
}

// The edge that a point is near to; none in the middle.
std::optional<Side> side_near(const Rect& rect, ImVec2 at) {
  constexpr float kNear = 0.27F;  // Of the tile.
  const float x = (at.x - rect.x0) / rect.width();
  const float y = (at.y - rect.y0) / rect.height();
  const std::array<float, 4> distances{x, 1.0F - x, y, 1.0F - y};
  const auto* nearest = std::min_element(distances.begin(), distances.end());
  if (*nearest > kNear) return {};
  return static_cast<Side>(nearest - distances.begin());
}

}  // namespace

TileArea::TileArea(const std::shared_ptr<SharedTime>& time) {
  for (std::size_t i = 0; i < kPanelCount; ++i) panels_[i] = make_panel(static_cast<PanelId>(i), time);
}

void TileArea::favour(PanelId panel) {
  fronted_[static_cast<std::size_t>(panel)] = ++front_counter_;
  fronted_[static_cast<std::size_t>(PanelId::kView)] = ++front_counter_;
}

void TileArea::bring_to_front(Tile& layout, PanelId panel) {
  fronted_[static_cast<std::size_t>(panel)] = ++front_counter_;
  Tile* tile = find_panel(layout, panel);
  if (tile == nullptr) return;
  const auto at = std::find(tile->panels.begin(), tile->panels.end(), panel);
  tile->active = static_cast<int>(at - tile->panels.begin());
}

PanelId TileArea::current(const Ui& ui) const {
  if (!ui.focus().shown()) return pointed_;
  for (std::size_t i = 0; i < kPanelCount; ++i) {
    const auto panel = static_cast<PanelId>(i);
    if (ui.focus().path().starts_with(std::string(title(panel)) + "/")) return panel;
  }
  return pointed_;
}

void TileArea::draw_tabs(Ui& ui, const Tile& tile, const Rect& rect, Tile& layout, Requests& requests) {
  ImGui::PushClipRect({rect.x0, rect.y0}, {rect.x1, rect.y1}, true);
  ImGui::GetWindowDrawList()->AddRectFilled({rect.x0, rect.y0}, {rect.x1, rect.y1}, to_u32(ui.theme().header));
  const Scope scope(ui, "Tabs");
  const TabWords detail = tab_words(ui, tile, rect.width());
  const std::size_t of_row = tabs_of_row(ui, tile, rect.width());
  const float height = rect.height() / static_cast<float>(tab_rows(ui, tile, rect.width()));
  const float share = std::floor(rect.width() / static_cast<float>(of_row));
  const float most = detail == TabWords::kIconsOnly ? share : rect.width();
  float x = rect.x0;
  float y = rect.y0;
  std::optional<PanelId> chosen;
  for (std::size_t i = 0; i < tile.panels.size(); ++i) {
    const PanelId panel = tile.panels[i];
    const bool active = static_cast<int>(i) == tile.active;
    const std::string words = words_of_tab(panel, active, detail);
    const float width = std::min(tab_width(ui, words, detail), most);
    if (i > 0 && i % of_row == 0) {
      x = rect.x0;
      y += height;
    }
    ImGui::SetCursorScreenPos({x, y});
    if (ImGui::InvisibleButton(std::string(title(panel)).c_str(), {width, height})) chosen = panel;
    if (ImGui::IsItemActive() && ImGui::IsMouseDragging(0, ui.px(6)) && !drag_cancelled_) dragged_ = panel;
    const bool hovered = ImGui::IsItemHovered();
    if (hovered && ImGui::IsMouseClicked(2)) requests.emplace_back(Arrange{closed(layout, panel)});
    note_item(ui, "tab", title(panel), active ? "on" : "off",
              {.help = detail >= TabWords::kIcons ? title(panel) : std::string_view{}});
    const Rect tab{x, y, x + width, y + height};
    draw_tab(ui, tab, words, active, hovered);
    grounds_.back().tabs.push_back(tab);
    x += width;
  }
  if (chosen) bring_to_front(layout, *chosen);
  ImGui::PopClipRect();
}

void TileArea::draw_tile(Ui& ui, const WorkbenchState& state, const PlacedTile& placed, Tile& layout,
                         Requests& requests) {
  const Tile& tile = *placed.tile;
  const PanelId panel = tile.panels[static_cast<std::size_t>(tile.active)];
  const Rect& rect = placed.rect;
  const float strip = ui.px(30) * static_cast<float>(tab_rows(ui, tile, rect.width()));
  grounds_.push_back(
      {{rect.x0, rect.y0, rect.x1, rect.y0 + strip}, {rect.x0, rect.y0 + strip, rect.x1, rect.y1}, tile.panels, {}});
  draw_tabs(ui, tile, grounds_.back().strip, layout, requests);
  ImGui::SetCursorScreenPos({rect.x0, rect.y0 + strip});
  const bool margin = has_margin(panel, state);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, margin ? ImVec2{ui.px(12), ui.px(10)} : ImVec2{0.0F, 0.0F});
  ImGui::PushStyleVar(ImGuiStyleVar_ChildRounding, 0.0F);
  const ColourScope ground(ImGuiCol_ChildBg, ui.theme().panel);
  // Over a canvas the wheel is the canvas's: it zooms or steps, and does not scroll the panel as well.
  const ImGuiWindowFlags wheel = ui.wheel_taken() ? ImGuiWindowFlags_NoScrollWithMouse : 0;
  const ImGuiWindowFlags flags = ImGuiWindowFlags_AlwaysUseWindowPadding |
                                 (margin ? wheel : ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
  ImGui::BeginChild(std::string(title(panel)).c_str(), {rect.width(), rect.height() - strip}, false, flags);
  ImGui::PopStyleVar(2);
  {
    const Scope scope(ui, title(panel));
    append(requests, panels_[static_cast<std::size_t>(panel)]->draw(ui, state));
  }
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  if (rect.contains(mouse.x, mouse.y)) pointed_ = panel;
  ImGui::EndChild();
}

// A tab group that was made for want of room shows what was last brought to the front.
void TileArea::choose_front(Tile& tile) const {
  const auto newer = [this](PanelId a, PanelId b) {
    return fronted_[static_cast<std::size_t>(a)] < fronted_[static_cast<std::size_t>(b)];
  };
  const auto front = std::max_element(tile.panels.begin(), tile.panels.end(), newer);
  tile.active = static_cast<int>(front - tile.panels.begin());
}

void TileArea::draw_splitters(Ui& ui, const Placement& placement) const {
  const Scope scope(ui, "Splitters");
  for (std::size_t i = 0; i < placement.splitters.size(); ++i) {
    const PlacedSplitter& bar = placement.splitters[i];
    float position = bar.vertical ? bar.rect.centre_x() : bar.rect.centre_y();
    bool share = false;
    // Wider than it looks, so that it can be caught.
    Rect grip = bar.rect;
    (bar.vertical ? grip.x0 : grip.y0) -= ui.px(2);
    (bar.vertical ? grip.x1 : grip.y1) += ui.px(2);
    if (splitter(ui, std::to_string(i + 1), bar.vertical, grip, position, share)) {
      move_splitter(bar, position, bar.vertical ? ui.px(250) : ui.px(160));
    }
    if (share) equalise(bar);
  }
}

std::optional<TileArea::Drop> TileArea::drop_at(const Ui& ui, ImVec2 mouse) const {
  for (const Ground& ground : grounds_) {
    const PanelId beside = ground.panels.front();
    if (ground.strip.contains(mouse.x, mouse.y)) {
      // Before the first tab of which the mouse is left of the middle, or of which it is in a row above.
      const auto follows = [mouse](const Rect& tab) {
        return mouse.y < tab.y0 || (mouse.y < tab.y1 && mouse.x < tab.centre_x());
      };
      const auto next = std::find_if(ground.tabs.begin(), ground.tabs.end(), follows);
      const bool last_of_row = next == ground.tabs.end() || mouse.y < next->y0;
      const Rect& neighbour = last_of_row ? *std::prev(next) : *next;
      const float at = last_of_row ? neighbour.x1 : neighbour.x0;
      const float half = 0.5F * ui.px(4);
      return Drop{{beside, {}, static_cast<int>(next - ground.tabs.begin())},
                  {at - half, neighbour.y0, at + half, neighbour.y1}};
    }
    if (!ground.body.contains(mouse.x, mouse.y)) continue;
    const std::optional<Side> side = side_near(ground.body, mouse);
    const Rect preview = side ? half_of(ground.body, *side) : ground.body;
    return Drop{{beside, side, -1}, preview};
  }
  return {};
}

void TileArea::follow_drag(Ui& ui, const Tile& layout, Requests& requests) {
  const bool held = ImGui::IsMouseDown(0);
  if (!held) drag_cancelled_ = false;
  if (!dragged_) return;
  const PanelId panel = *dragged_;
  if (ui.input().pressed(Key::kEscape)) {
    dragged_.reset();
    drag_cancelled_ = held;
    return;
  }
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const std::optional<Drop> drop = drop_at(ui, mouse);
  if (!held) dragged_.reset();
  if (!drop) return;
  if (!held) {
    requests.emplace_back(Arrange{dropped(layout, panel, drop->place)});
    return;
  }
  ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  ImDrawList& list = *ImGui::GetForegroundDrawList();
  const Rect& rect = drop->preview;
  Rgba tint = ui.theme().accent;
  tint.a = 72;
  list.AddRectFilled({rect.x0, rect.y0}, {rect.x1, rect.y1}, to_u32(tint), ui.px(3));
  list.AddRect({rect.x0, rect.y0}, {rect.x1, rect.y1}, to_u32(ui.theme().accent), ui.px(3), 0, ui.px(2));
  const std::string words =
      fmt::format("{} {} {}", title(panel), place_words(drop->place.side), title(drop->place.beside));
  note_rect(ui, "mark", "Drop", words, rect, {});
  const ImVec2 size = ImGui::CalcTextSize(words.c_str());
  const ImVec2 at{mouse.x + ui.px(14), mouse.y + ui.px(12)};
  list.AddRectFilled({at.x - ui.px(8), at.y - ui.px(5)}, {at.x + size.x + ui.px(8), at.y + size.y + ui.px(5)},
                     to_u32(ui.theme().raised), ui.px(3));
  list.AddText(at, to_u32(ui.theme().text), words.c_str());
}

void TileArea::draw(Ui& ui, const WorkbenchState& state, const Rect& rect, Tile& layout, Requests& requests) {
  grounds_.clear();
  if (maximised_) {
    Tile single;
    single.panels = {*maximised_};
    draw_tile(ui, state, {&single, rect, false}, layout, requests);
    return dragged_.reset();
  }
  const Placement placement = place(layout, rect, {ui.px(4), ui.px(250), ui.px(160), ui.px(420), ui.px(110)});
  for (const std::unique_ptr<Tile>& merged : placement.merged) choose_front(*merged);
  for (std::size_t i = 0; i < placement.tiles.size(); ++i) {
    ImGui::PushID(static_cast<int>(i));
    draw_tile(ui, state, placement.tiles[i], layout, requests);
    ImGui::PopID();
  }
  // What is not in sight is not pointed at.
  const auto in_sight = [this](const PlacedTile& placed) {
    return placed.tile->panels[static_cast<std::size_t>(placed.tile->active)] == pointed_;
  };
  if (std::none_of(placement.tiles.begin(), placement.tiles.end(), in_sight)) {
    const Tile& first = *placement.tiles.front().tile;
    pointed_ = first.panels[static_cast<std::size_t>(first.active)];
  }
  draw_splitters(ui, placement);
  follow_drag(ui, layout, requests);
}

}  // namespace trocar::ui
