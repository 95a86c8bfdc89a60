#include "ui/shell.h"

#include <imgui_internal.h>

#include <algorithm>
#include <cmath>

#include "ui/command_table.h"
#include "ui/command_text.h"
#include "ui/icons.h"
#include "ui/panels/common.h"

namespace trocar::ui {
namespace {

constexpr std::array<float, 9> kScales{0.75F, 0.9F, 1.0F, 1.1F, 1.25F, 1.5F, 2.0F, 2.5F, 3.0F};

float next_scale(float now, bool up) {
  if (up) {
    const auto* next = std::upper_bound(kScales.begin(), kScales.end(), now + 0.01F);
    return next == kScales.end() ? kScales.back() : *next;
  }
  const auto* here = std::lower_bound(kScales.begin(), kScales.end(), now - 0.01F);
  return here == kScales.begin() ? kScales.front() : *(here - 1);
}

// ImGui leaves this to its keyboard navigation, which would take the arrow keys from the timeline.
void close_popups_on_escape(const Ui& ui) {
  const bool open = ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
  if (open && ui.input().pressed(Key::kEscape)) ImGui::ClosePopupToLevel(0, true);
}

// Before anything is drawn, so that the field sees that it was left and hands over what was typed.
void leave_field_on_tab(const Ui& ui) {
  if (ImGui::GetIO().WantTextInput && ui.input().pressed(Key::kTab)) ImGui::ClearActiveID();
}

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

float tab_width(const Ui& ui, const std::string& words, TabWords detail) {
  return std::max(ImGui::CalcTextSize(words.c_str()).x + 2.0F * tab_margin(ui, detail), ui.px(24));
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

// The picture goes to the edge of its tile; everything else has a margin.
bool has_margin(PanelId panel, const WorkbenchState& state) {
  return panel != PanelId::kView || state.load != workbench::LoadState::kReady;
}

}  // namespace

float effective_scale(const Settings& settings, float content_scale) {
  return std::clamp(settings.scale > 0.0F ? settings.scale : content_scale, 0.75F, 3.0F);
}

Shell::Shell(Settings& settings) : settings_(settings) {
  time_->hidden_lanes = settings_.hidden_lanes;
  for (std::size_t i = 0; i < kPanelCount; ++i) panels_[i] = make_panel(static_cast<PanelId>(i), time_);
  fronted_[static_cast<std::size_t>(PanelId::kView)] = front_counter_;
}

void Shell::bring_to_front(PanelId panel) {
  fronted_[static_cast<std::size_t>(panel)] = ++front_counter_;
  Tile* tile = find_panel(settings_.layout(), panel);
  if (tile == nullptr) return;
  const auto at = std::find(tile->panels.begin(), tile->panels.end(), panel);
  tile->active = static_cast<int>(at - tile->panels.begin());
}

void Shell::draw_tabs(Ui& ui, const Tile& tile, const Rect& rect) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  ImGui::PushClipRect({rect.x0, rect.y0}, {rect.x1, rect.y1}, true);
  list.AddRectFilled({rect.x0, rect.y0}, {rect.x1, rect.y1}, to_u32(ui.theme().header));
  const Scope scope(ui, "Tabs");
  const TabWords detail = tab_words(ui, tile, rect.width());
  float x = rect.x0;
  for (int i = 0; i < static_cast<int>(tile.panels.size()); ++i) {
    const PanelId panel = tile.panels[static_cast<std::size_t>(i)];
    const bool active = i == tile.active;
    const std::string words = words_of_tab(panel, active, detail);
    // Where even the icons are too many, they share what room there is.
    const float share = std::floor(rect.width() / static_cast<float>(tile.panels.size()));
    const bool crowded = detail == TabWords::kIconsOnly;
    const float width = crowded ? std::min(tab_width(ui, words, detail), share) : tab_width(ui, words, detail);
    ImGui::SetCursorScreenPos({x, rect.y0});
    if (ImGui::InvisibleButton(std::string(title(panel)).c_str(), {width, rect.height()})) bring_to_front(panel);
    const bool hovered = ImGui::IsItemHovered();
    note_item(ui, "tab", title(panel), active ? "on" : "off",
              {.help = detail >= TabWords::kIcons ? title(panel) : std::string_view{}});
    if (active) {
      list.AddRectFilled({x, rect.y0}, {x + width, rect.y1}, to_u32(ui.theme().panel));
      list.AddRectFilled({x, rect.y0}, {x + width, rect.y0 + ui.px(2)}, to_u32(ui.theme().accent));
    }
    const Rgba colour = active || hovered ? ui.theme().text : ui.theme().text_dim;
    const float y = std::round(rect.centre_y() - 0.5F * ImGui::GetFontSize());
    const float text = ImGui::CalcTextSize(words.c_str()).x;
    list.AddText({std::round(x + 0.5F * (width - text)), y}, to_u32(colour), words.c_str());
    x += width;
  }
  ImGui::PopClipRect();
}

void Shell::draw_tile(Ui& ui, const WorkbenchState& state, const PlacedTile& placed, Requests& requests) {
  const Tile& tile = *placed.tile;
  const PanelId panel = tile.panels[static_cast<std::size_t>(tile.active)];
  const Rect& rect = placed.rect;
  const float strip = ui.px(30);
  draw_tabs(ui, tile, {rect.x0, rect.y0, rect.x1, rect.y0 + strip});
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
void Shell::choose_front(Tile& tile) const {
  const auto newer = [this](PanelId a, PanelId b) {
    return fronted_[static_cast<std::size_t>(a)] < fronted_[static_cast<std::size_t>(b)];
  };
  const auto front = std::max_element(tile.panels.begin(), tile.panels.end(), newer);
  tile.active = static_cast<int>(front - tile.panels.begin());
}

void Shell::draw_tiles(Ui& ui, const WorkbenchState& state, const Rect& rect, Requests& requests) {
  Tile single;
  if (maximised_) {
    single.panels = {*maximised_};
    draw_tile(ui, state, {&single, rect, false}, requests);
    return;
  }
  const Placement placement = place(settings_.layout(), rect, {ui.px(4), ui.px(250), ui.px(160)});
  for (const std::unique_ptr<Tile>& merged : placement.merged) choose_front(*merged);
  for (std::size_t i = 0; i < placement.tiles.size(); ++i) {
    ImGui::PushID(static_cast<int>(i));
    draw_tile(ui, state, placement.tiles[i], requests);
    ImGui::PopID();
  }
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

Requests Shell::draw_host(Ui& ui, const WorkbenchState& state, double frames_hz) {
  Requests requests;
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({0.0F, 0.0F});
  ImGui::SetNextWindowSize(screen);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0.0F, 0.0F});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0.0F);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0.0F);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding,
                      {ui.px(10), 0.5F * (menu_bar_height(ui) - ui.fonts().body->FontSize)});
  constexpr ImGuiWindowFlags kFlags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                      ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus |
                                      ImGuiWindowFlags_MenuBar | ImGuiWindowFlags_NoBackground |
                                      ImGuiWindowFlags_NoScrollWithMouse;
  ImGui::Begin("Trocar", nullptr, kFlags);
  // Menus are windows too and keep the margins of the style.
  ImGui::PopStyleVar(4);
  append(requests, draw_menu_bar(ui, state, settings_, frames_hz));
  const float top = menu_bar_height(ui);
  const float bar = tool_bar_height(ui);
  const float status = status_line_height(ui);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled({0.0F, top}, {screen.x, top + bar - ui.px(4)}, to_u32(ui.theme().panel));
  ImGui::SetCursorScreenPos({0.0F, top - ui.px(2)});
  append(requests, draw_tool_bar(ui, state));
  draw_tiles(ui, state, {0.0F, top + bar, screen.x, screen.y - status}, requests);
  ImGui::SetCursorScreenPos({0.0F, screen.y - status});
  append(requests, draw_status_line(ui, state, status_));
  ImGui::End();
  return requests;
}

Requests Shell::draw_forms(Ui& ui, const WorkbenchState& state) {
  Requests requests;
  for (Form* form : std::initializer_list<Form*>{&record_, &file_, &import_, &demonstrations_, &video_, &field_,
                                                 &shortcuts_, &about_, &quit_}) {
    append(requests, form->draw(ui, state));
  }
  append(requests, palette_.draw(ui, state));
  return requests;
}

bool Shell::form_open() const {
  return record_.is_open() || file_.is_open() || import_.is_open() || demonstrations_.is_open() || video_.is_open() ||
         field_.is_open() || shortcuts_.is_open() || about_.is_open() || quit_.is_open() || palette_.is_open();
}

Requests Shell::take_keys(Ui& ui, const WorkbenchState& state) const {
  Requests requests;
  const bool typing = ImGui::GetIO().WantTextInput;
  const auto means = [&](const Chord& chord) {
    if (!pressed(ui.input(), chord)) return false;
    // While a field has the keyboard or a form lies on top, only chords that cannot be text go to the window.
    const bool plain = !chord.modifiers.control && !chord.modifiers.alt;
    if ((typing || form_open()) && (plain || typing)) return false;
    const bool presses = chord.key == Key::kSpace || chord.key == Key::kEnter;
    return !(presses && plain && ui.focus().shown());
  };
  std::vector<Chord> taken;
  for (const bool in_context : {true, false}) {
    for (const CommandRow& row : command_table()) {
      if (row.context.empty() == in_context) continue;
      for (const std::string_view keys : row.keys) {
        const Result<Chord> chord = chord_from(keys);
        if (!chord || !means(*chord) || std::find(taken.begin(), taken.end(), *chord) != taken.end()) continue;
        if (!row.reason_now(state).empty()) continue;
        taken.push_back(*chord);
        append(requests, row.run(state));
      }
    }
  }
  return requests;
}

Requests Shell::take_dropped(const Ui& ui, const WorkbenchState& state) {
  if (ui.input().dropped().empty()) return {};
  const std::filesystem::path path = ui.input().dropped().front();
  const bool project = path.extension() == ".trocar";
  const CommandRow& row = command(project ? "file.open" : "file.import");
  if (!row.reason_now(state).empty()) return {};
  if (project) return {workbench::Command{workbench::OpenProject{path, false}}};
  import_.open_on(path);
  return {};
}

bool Shell::open_form(UiAction action) {
  const auto opened = [](Form& form) {
    form.open();
    return true;
  };
  if (action == UiAction::kShowRecord) return opened(record_);
  if (action == UiAction::kShowExportVideo) return opened(video_);
  if (action == UiAction::kShowExportField) return opened(field_);
  if (action == UiAction::kShowShortcuts) return opened(shortcuts_);
  if (action == UiAction::kShowAbout) return opened(about_);
  if (action == UiAction::kShowExportDemonstrations) return opened(demonstrations_);
  if (action == UiAction::kShowImport) {
    import_.open_on({});
    return true;
  }
  if (action == UiAction::kNewProject) file_.open_new();
  if (action == UiAction::kOpenProject) file_.open_existing();
  if (action == UiAction::kShowPalette) palette_.open();
  return action == UiAction::kNewProject || action == UiAction::kOpenProject || action == UiAction::kShowPalette;
}

void Shell::act(UiAction action, const Ui& ui, const WorkbenchState& state, ShellResult& result) {
  result.restyle = true;
  if (open_form(action)) return;
  if (action == UiAction::kQuit && something_runs(state)) return quit_.open();
  if (action == UiAction::kQuit || action == UiAction::kQuitNow) result.quit = true;
  if (action == UiAction::kScaleUp) settings_.scale = next_scale(ui.scale(), true);
  if (action == UiAction::kScaleDown) settings_.scale = next_scale(ui.scale(), false);
  if (action == UiAction::kScaleReset) settings_.scale = 1.0F;
  if (action == UiAction::kSwitchTheme) settings_.theme = next(settings_.theme);
  if (action == UiAction::kResetLayout) settings_.layout() = default_layout(settings_.workspace);
  if (action == UiAction::kMaximise) maximised_ = maximised_ ? std::nullopt : std::optional(pointed_);
  if (action == UiAction::kCopyCommand) result.clipboard = status_.last_command;
}

void Shell::resolve(const Requests& requests, const Ui& ui, const WorkbenchState& state, ShellResult& result) {
  for (const Request& request : requests) {
    if (const auto* asked = std::get_if<workbench::Command>(&request)) {
      if (std::string words = command_text(*asked, state); !words.empty()) status_.last_command = std::move(words);
      if (const auto* open = std::get_if<workbench::OpenProject>(asked)) add_recent(settings_, open->path);
      result.commands.push_back(*asked);
    } else if (const auto* action = std::get_if<UiAction>(&request)) {
      act(*action, ui, state, result);
    } else if (const auto* panel = std::get_if<ShowPanel>(&request)) {
      maximised_.reset();
      bring_to_front(panel->panel);
    } else if (const auto* workspace = std::get_if<ShowWorkspace>(&request)) {
      maximised_.reset();
      settings_.workspace = workspace->workspace;
    } else if (const auto* begin = std::get_if<BeginEdit>(&request)) {
      maximised_.reset();
      bring_to_front(PanelId::kEdits);
      panels_[static_cast<std::size_t>(PanelId::kEdits)]->begin_edit(begin->edit, state);
    } else if (const auto* copy = std::get_if<CopyText>(&request)) {
      result.clipboard = copy->text;
    }
  }
}

ShellResult Shell::draw(Ui& ui, const WorkbenchState& state, double frames_hz, bool close_asked) {
  status_.hint = ui.hint();
  const ImVec2 pointer = ImGui::GetIO().MousePos;
  status_.just_done = status_.just_done && pointer.x == pointer_when_done_.x && pointer.y == pointer_when_done_.y;
  if (status_.done != state.done) {
    status_.done = state.done;
    status_.just_done = true;
    pointer_when_done_ = pointer;
  }
  if (!palette_.is_open()) leave_field_on_tab(ui);
  Requests requests = take_keys(ui, state);
  append(requests, take_dropped(ui, state));
  if (close_asked) requests.emplace_back(UiAction::kQuit);
  append(requests, draw_host(ui, state, frames_hz));
  append(requests, draw_forms(ui, state));
  if (!palette_.is_open()) ui.take_focus_keys();
  close_popups_on_escape(ui);
  settings_.hidden_lanes = time_->hidden_lanes;
  ShellResult result;
  resolve(requests, ui, state, result);
  return result;
}

}  // namespace trocar::ui
