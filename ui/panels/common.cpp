#include "ui/panels/common.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "ui/format.h"
#include "ui/icons.h"

namespace trocar::ui {

namespace {

void draw_open_error(Ui& ui, const WorkbenchState& state, Requests& requests) {
  const std::array<EmptyStateAction, 3> actions{{{"Retry", icon::kRefresh, {}, "Open the same file again"},
                                                 {"Open project…", icon::kFolder, {}, "Open another project file"},
                                                 {"Show log", icon::kList, {}, "Everything that was reported"}}};
  const int clicked = empty_state(ui, icon::kWarning, "The project could not be opened", state.load_error, actions);
  if (clicked == 0) requests.emplace_back(workbench::Command{workbench::OpenProject{state.path, false}});
  if (clicked == 1) requests.emplace_back(UiAction::kOpenProject);
  if (clicked == 2) requests.emplace_back(ShowPanel{PanelId::kLog});
}

}  // namespace

bool draw_no_project(Ui& ui, const WorkbenchState& state, Requests& requests) {
  using workbench::LoadState;
  if (state.load == LoadState::kReady && state.project != nullptr) return false;
  if (state.load == LoadState::kLoading) {
    empty_state(ui, "", "", "Opening the project", {});
    return true;
  }
  // The view says at length what went wrong, or what can be done first; here one way on is enough.
  if (state.load == LoadState::kFailed) {
    const std::array<EmptyStateAction, 1> retry{{{"Retry", icon::kRefresh, {}, "Open the same file again"}}};
    if (empty_state(ui, "", "", "The project did not open", retry) == 0) {
      requests.emplace_back(workbench::Command{workbench::OpenProject{state.path, false}});
    }
    return true;
  }
  const std::array<EmptyStateAction, 1> open{{{"Open project…", icon::kFolder, {}, "Open a project file"}}};
  if (empty_state(ui, "", "", "No project is open", open) == 0) requests.emplace_back(UiAction::kOpenProject);
  return true;
}

bool draw_welcome(Ui& ui, const WorkbenchState& state, Requests& requests) {
  using workbench::LoadState;
  if (state.load == LoadState::kReady && state.project != nullptr) return false;
  if (state.load == LoadState::kLoading) {
    const std::string sentence = "Reading " + shown_path(state.path);
    empty_state(ui, icon::kClock, "Opening the project", sentence, {});
    ui.animate();
    return true;
  }
  if (state.load == LoadState::kFailed) {
    draw_open_error(ui, state, requests);
    return true;
  }
  const std::array<EmptyStateAction, 2> actions{{{"New project…", icon::kFile, {}, "Make an empty project file"},
                                                 {"Open project…", icon::kFolder, {}, "Open a project file"}}};
  const int clicked = empty_state(ui, icon::kFolder, "No project is open",
                                  "Demonstrations, models and their history live in one file", actions);
  if (clicked == 0) requests.emplace_back(UiAction::kNewProject);
  if (clicked == 1) requests.emplace_back(UiAction::kOpenProject);
  return true;
}

std::string_view being_recorded(const WorkbenchState& state) {
  return state.live ? "A transfer is being recorded" : "";
}

void command_button(Ui& ui, const WorkbenchState& state, std::string_view id, std::string_view label, ButtonStyle style,
                    Requests& requests) {
  const CommandRow& row = command(id);
  const std::string reason = row.reason_now(state);
  const std::string keys(shown_keys(ui, row.id));
  if (button(ui, label, {.icon = row.icon, .help = row.help, .shortcut = keys, .reason = reason, .style = style})) {
    append(requests, row.run(state));
  }
}

void command_icon(Ui& ui, const WorkbenchState& state, std::string_view id, Requests& requests, ButtonStyle style) {
  const CommandRow& row = command(id);
  const std::string reason = row.reason_now(state);
  const std::string help = std::string(row.title) + ": " + std::string(row.help);
  const std::string keys(shown_keys(ui, row.id));
  const WidgetOptions options{.icon = row.icon, .help = help, .shortcut = keys, .reason = reason, .style = style};
  if (icon_button(ui, row.title, options)) append(requests, row.run(state));
}

bool shows_field(const workbench::FieldSettings& settings) {
  const bool slice = std::any_of(settings.slices.begin(), settings.slices.end(), [](int index) { return index >= 0; });
  return settings.visible &&
         (slice || settings.voxels || settings.iso_surface || settings.volume || settings.streamlines);
}

void segment_chip(Ui& ui, demonstration::Segment segment, bool present, float size) {
  const FontScope font(ui.fonts().small);
  const std::string letter(1, demonstration::letter(segment));
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const ImVec2 end{at.x + size, at.y + size};
  const ImVec2 words = ImGui::CalcTextSize(letter.c_str());
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (present) {
    list.AddRectFilled(at, end, to_u32(segment_colour(segment)), ui.px(3));
  } else {
    list.AddRect(at, end, to_u32(ui.theme().line), ui.px(3));
  }
  const Rgba ink = present ? Rgba{16, 18, 21, 255} : ui.theme().text_disabled;
  const ImVec2 place{at.x + 0.5F * (size - words.x), at.y + 0.5F * (size - words.y)};
  list.AddText({std::round(place.x), std::round(place.y)}, to_u32(ink), letter.c_str());
  ImGui::Dummy({size, size});
}

void segment_chips(Ui& ui, const demonstration::Demonstration& shown, float size) {
  for (int i = 0; i < demonstration::kSegmentCount; ++i) {
    const auto segment = static_cast<demonstration::Segment>(i);
    if (i > 0) ImGui::SameLine(0.0F, ui.px(2));
    segment_chip(ui, segment, shown.segment(segment).has_value(), size);
  }
}

Rgba outcome_colour(const Theme& theme, demonstration::Outcome outcome) {
  using demonstration::Outcome;
  switch (outcome) {
    case Outcome::kSuccess:
      return theme.good;
    case Outcome::kUnfinished:
    case Outcome::kUnknown:
      return theme.text_dim;
    case Outcome::kAborted:
      return theme.warning;
    case Outcome::kDropped:
    case Outcome::kFault:
      return theme.danger;
  }
  return theme.text_dim;
}

std::string outcome_words(const demonstration::Demonstration& shown) {
  if (shown.motion_edited()) return "edited since";
  if (!shown.outcome_doubt().empty()) return "end cut off";
  if (shown.outcome() == demonstration::Outcome::kSuccess) return shown.placed() ? "placed" : "success";
  return std::string(demonstration::to_string(shown.outcome()));
}

const char* outcome_sign(demonstration::Outcome outcome) {
  if (outcome == demonstration::Outcome::kSuccess) return icon::kVerify;
  if (outcome == demonstration::Outcome::kUnknown) return icon::kHelp;
  return outcome == demonstration::Outcome::kUnfinished ? icon::kClock : icon::kCross;
}

void sentences(Ui& ui, const char* sign, std::span<const std::string> list, Rgba colour) {
  for (const std::string& sentence : list) {
    {
      const ColourScope tint(ImGuiCol_Text, colour);
      ImGui::TextUnformatted(sign);
    }
    ImGui::SameLine(0.0F, ui.px(8));
    wrapped_text(ui, sentence, ui.theme().text);
  }
}

std::string place_words(int place) {
  return place == demonstration::kUnknownPlace ? "unknown" : std::to_string(place);
}

std::string provenance_words(const demonstration::Provenance& provenance) {
  if (provenance.skill.empty()) return provenance.operator_kind;
  return provenance.operator_kind + " " + provenance.skill;
}

void append(Requests& to, Requests from) {
  std::move(from.begin(), from.end(), std::back_inserter(to));
}

double length_of(const demonstration::Demonstration& shown) {
  return shown.samples.empty() ? 1.0 : shown.full_duration_s();
}

}  // namespace trocar::ui
