#include "ui/shell.h"

#include <imgui_internal.h>

#include <algorithm>
#include <cmath>

#include "ui/command_table.h"
#include "ui/command_text.h"
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

}  // namespace

float effective_scale(const Settings& settings, float content_scale) {
  return std::clamp(settings.scale > 0.0F ? settings.scale : content_scale, 0.75F, 3.0F);
}

Shell::Shell(Settings& settings)
    : settings_(settings), tiles_(time_), keymap_(std::make_shared<const Keymap>(settings.keys)) {
  time_->hidden_lanes = settings_.hidden_lanes;
  time_->ruler = settings_.ruler;
  tiles_.favour(main_panel(settings_.workspace));
}

void Shell::tell(std::string words) {
  status_.done = std::move(words);
  status_.just_done = true;
  pointer_when_done_ = ImGui::GetIO().MousePos;
}

void Shell::show_panel(PanelId panel) {
  tiles_.maximise({});
  settings_.layout() = opened(settings_.layout(), panel, default_layout(settings_.workspace));
  tiles_.bring_to_front(settings_.layout(), panel);
}

void Shell::arrange(Tile layout) {
  tiles_.maximise({});
  settings_.layout() = std::move(layout);
}

void Shell::take_back(std::optional<Tile> layout, std::string_view none) {
  if (layout) return arrange(std::move(*layout));
  tell(std::string(none));
}

void Shell::choose_keys(const KeyChoices& keys) {
  settings_.keys = keys;
  keymap_ = std::make_shared<const Keymap>(keys);
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
  tiles_.draw(ui, state, {0.0F, top + bar, screen.x, screen.y - status}, settings_.layout(), requests);
  ImGui::SetCursorScreenPos({0.0F, screen.y - status});
  append(requests, draw_status_line(ui, state, status_));
  ImGui::End();
  return requests;
}

Requests Shell::draw_forms(Ui& ui, const WorkbenchState& state) {
  Requests requests;
  for (Form* form : std::initializer_list<Form*>{&record_, &file_, &import_, &demonstrations_, &video_, &field_, &plot_,
                                                 &table_, &shortcuts_, &page_, &keys_, &layouts_, &about_, &quit_}) {
    append(requests, form->draw(ui, state));
  }
  append(requests, palette_.draw(ui, state));
  return requests;
}

bool Shell::form_open() const {
  return record_.is_open() || file_.is_open() || import_.is_open() || demonstrations_.is_open() || video_.is_open() ||
         field_.is_open() || plot_.is_open() || table_.is_open() || shortcuts_.is_open() || page_.is_open() ||
         keys_.is_open() || layouts_.is_open() || about_.is_open() || quit_.is_open() || palette_.is_open();
}

Requests Shell::take_keys(Ui& ui, const WorkbenchState& state) const {
  Requests requests;
  // Stop is there whatever else the keys are for.
  const bool stops = state.trials && state.live && ui.input().pressed(Key::kEscape);
  if (stops) return {workbench::Command{workbench::StopTrial{}}};
  if (keys_.capturing() || tiles_.dragging()) return requests;
  const bool typing = ImGui::GetIO().WantTextInput;
  const auto means = [&](const Chord& chord) {
    if (!pressed(ui.input(), chord) || TakeKeys::claims(chord, state)) return false;
    if (tiles_.panel(tiles_.current(ui)).claims(ui, chord, state)) return false;
    // While a field has the keyboard or a form lies on top, only chords that cannot be text go to the window.
    const bool plain = !chord.modifiers.control && !chord.modifiers.alt;
    if ((typing || form_open()) && (plain || typing)) return false;
    const bool presses =
        chord.key == Key::kSpace || chord.key == Key::kEnter || chord.key == Key::kUp || chord.key == Key::kDown;
    return !(presses && plain && ui.focus().shown());
  };
  std::vector<Chord> taken;
  for (const bool in_context : {true, false}) {
    for (const CommandRow& row : command_table()) {
      if (row.context.empty() == in_context) continue;
      for (const Chord& chord : keymap_->chords(row.id)) {
        if (!means(chord) || std::find(taken.begin(), taken.end(), chord) != taken.end()) continue;
        if (!row.reason_now(state).empty()) continue;
        taken.push_back(chord);
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

bool Shell::open_form(UiAction action, const Ui& ui) {
  const auto opened = [](Form& form) {
    form.open();
    return true;
  };
  if (action == UiAction::kShowRecord) return opened(record_);
  if (action == UiAction::kShowExportVideo) return opened(video_);
  if (action == UiAction::kShowExportField) {
    field_.open_on(tiles_.panel(PanelId::kFields).shown_slice());
    return true;
  }
  if (action == UiAction::kShowExportPlot) {
    plot_.open_on({});
    return true;
  }
  if (action == UiAction::kShowImportTable) return opened(table_);
  if (action == UiAction::kShowShortcuts) return opened(shortcuts_);
  if (action == UiAction::kShowAbout) return opened(about_);
  if (action == UiAction::kShowKeys) return opened(keys_);
  if (action == UiAction::kShowLayouts) return opened(layouts_);
  if (action == UiAction::kShowHelp) page_.open_on(tiles_.current(ui));
  if (action == UiAction::kShowExportDemonstrations) return opened(demonstrations_);
  if (action == UiAction::kShowImport) {
    import_.open_on({});
    return true;
  }
  if (action == UiAction::kNewProject) file_.open_new();
  if (action == UiAction::kOpenProject) file_.open_existing();
  if (action == UiAction::kShowPalette) palette_.open();
  return action == UiAction::kNewProject || action == UiAction::kOpenProject || action == UiAction::kShowPalette ||
         action == UiAction::kShowHelp;
}

bool Shell::act_on_tiles(UiAction action, const Ui& ui) {
  const Tile& layout = settings_.layout();
  const PanelId panel = tiles_.current(ui);
  const auto toggle_side = [&](Side side) {
    Tile toggled = with_side_toggled(layout, side);
    if (same_places(toggled, layout)) return tell("This layout has nothing at that side");
    arrange(std::move(toggled));
  };
  switch (action) {
    case UiAction::kResetLayout:
      arrange(default_layout(settings_.workspace));
      return true;
    case UiAction::kUndoLayout:
      take_back(history_.undo(settings_.workspace), "Nothing was done to the tiles");
      return true;
    case UiAction::kRedoLayout:
      take_back(history_.redo(settings_.workspace), "Nothing was undone of the tiles");
      return true;
    case UiAction::kClosePanel:
      arrange(closed(layout, panel));
      tell("Closed " + std::string(title(panel)) + "; View > Panels opens it");
      return true;
    case UiAction::kEqualise:
      arrange(equalised(layout, panel));
      return true;
    case UiAction::kHideLeft:
      toggle_side(Side::kLeft);
      return true;
    case UiAction::kHideRight:
      toggle_side(Side::kRight);
      return true;
    case UiAction::kMaximise:
      tiles_.maximise(tiles_.maximised() ? std::nullopt : std::optional(panel));
      return true;
    default:
      return false;
  }
}

void Shell::act(UiAction action, const Ui& ui, const WorkbenchState& state, ShellResult& result) {
  result.restyle = true;
  if (open_form(action, ui) || act_on_tiles(action, ui)) return;
  if (action == UiAction::kQuit && something_runs(state)) return quit_.open();
  if (action == UiAction::kQuit || action == UiAction::kQuitNow) result.quit = true;
  if (action == UiAction::kScaleUp) settings_.scale = next_scale(ui.scale(), true);
  if (action == UiAction::kScaleDown) settings_.scale = next_scale(ui.scale(), false);
  if (action == UiAction::kScaleReset) settings_.scale = 1.0F;
  if (action == UiAction::kNextRuler) time_->ruler = next(time_->ruler);
  if (action == UiAction::kSwitchTheme) settings_.theme = next(settings_.theme);
  if (action == UiAction::kFrameRate) settings_.frame_rate = !settings_.frame_rate;
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
      show_panel(panel->panel);
    } else if (const auto* workspace = std::get_if<ShowWorkspace>(&request)) {
      tiles_.maximise({});
      settings_.workspace = workspace->workspace;
      tiles_.favour(main_panel(settings_.workspace));
    } else if (const auto* keys = std::get_if<ChooseKeys>(&request)) {
      choose_keys(keys->keys);
    } else if (const auto* move = std::get_if<MovePanel>(&request)) {
      arrange(moved(settings_.layout(), tiles_.current(ui), move->side));
    } else if (const auto* tiles = std::get_if<Arrange>(&request)) {
      arrange(tiles->layout);
    } else if (const auto* keep = std::get_if<KeepLayouts>(&request)) {
      settings_.named[static_cast<std::size_t>(settings_.workspace)] = keep->layouts;
    } else if (const auto* begin = std::get_if<BeginEdit>(&request)) {
      show_panel(PanelId::kEdits);
      tiles_.panel(PanelId::kEdits).begin_edit(*begin, state);
    } else if (const auto* plot = std::get_if<ShowPlotForm>(&request)) {
      plot_.open_on(plot->settings);
    } else if (const auto* copy = std::get_if<CopyText>(&request)) {
      result.clipboard = copy->text;
    }
  }
}

ShellResult Shell::draw(Ui& ui, const WorkbenchState& state, double frames_hz, bool close_asked) {
  status_.hint = ui.hint();
  const ImVec2 pointer = ImGui::GetIO().MousePos;
  status_.just_done = status_.just_done && pointer.x == pointer_when_done_.x && pointer.y == pointer_when_done_.y;
  if (seen_done_ != state.done) tell(seen_done_ = state.done);
  ui.set_keymap(keymap_);
  const bool capturing = keys_.capturing();
  if (!palette_.is_open() && !capturing) leave_field_on_tab(ui);
  Requests requests = take_keys(ui, state);
  append(requests, take_dropped(ui, state));
  append(requests, take_keys_.follow(ui, state, !ImGui::GetIO().WantTextInput && !form_open()));
  if (close_asked) requests.emplace_back(UiAction::kQuit);
  append(requests, draw_host(ui, state, frames_hz));
  append(requests, draw_forms(ui, state));
  if (!palette_.is_open() && !capturing) ui.take_focus_keys();
  close_popups_on_escape(ui);
  settings_.hidden_lanes = time_->hidden_lanes;
  settings_.ruler = time_->ruler;
  // Several panels draw curves; one request is for all of them.
  if (const auto kinds = std::exchange(time_->wanted_curves, std::nullopt); kinds && *kinds != state.curve_kinds) {
    requests.emplace_back(workbench::Command{workbench::ShowCurves{*kinds}});
  }
  const bool light = settings_.theme == ThemeKind::kLight;
  if (light != state.light_backdrop) requests.emplace_back(workbench::Command{workbench::SetBackdrop{light}});
  ShellResult result;
  if (!ImGui::IsAnyMouseDown()) history_.settle(settings_.workspace, settings_.layout());
  resolve(requests, ui, state, result);
  return result;
}

}  // namespace trocar::ui
