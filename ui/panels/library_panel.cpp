#include "ui/panels/library_panel.h"

#include <algorithm>
#include <array>

#include "ui/format.h"
#include "ui/icons.h"
#include "ui/panels/common.h"

namespace trocar::ui {
namespace {

using demonstration::Demonstration;
using workbench::ModelEntry;

constexpr ImGuiTableFlags kTableFlags =
    ImGuiTableFlags_RowBg | ImGuiTableFlags_BordersInnerH | ImGuiTableFlags_PadOuterX | ImGuiTableFlags_Resizable;

void right_aligned(std::string_view words, float right) {
  const float width = ImGui::CalcTextSize(words.data(), words.data() + words.size()).x;
  ImGui::SameLine(right - width);
  ImGui::TextUnformatted(words.data(), words.data() + words.size());
}

// Its sign alone, with the word as tooltip, where there is no room for both.
void draw_outcome(Ui& ui, const demonstration::Demonstration& shown, float room) {
  const char* sign = outcome_sign(shown.outcome());
  const std::string words = outcome_words(shown);
  const Rgba colour = outcome_colour(ui.theme(), shown.outcome());
  if (badge_width(ui, sign, words) <= room) return badge(ui, sign, words, colour);
  const ColourScope tint(ImGuiCol_Text, colour);
  ImGui::TextUnformatted(sign);
  note_item(ui, "text", words, "", {.help = words});
}

// Name and duration above; segments, outcome and origin below.
void draw_card(Ui& ui, const Demonstration& shown, float width) {
  const float left = ImGui::GetCursorPosX();
  const std::string duration = seconds(shown.duration_s());
  const float room = width - ImGui::CalcTextSize(duration.c_str()).x - ui.px(12);
  ImGui::TextUnformatted(fitted(shown.name, room).c_str());
  {
    const ColourScope dim(ImGuiCol_Text, ui.theme().text_dim);
    right_aligned(duration, left + width);
  }
  ImGui::SetCursorPosX(left);
  segment_chips(ui, shown, ui.px(17));
  ImGui::SameLine(0.0F, ui.px(8));
  draw_outcome(ui, shown, left + width - ImGui::GetCursorPosX());
  const FontScope font(ui.fonts().small);
  const ColourScope dim(ImGuiCol_Text, ui.theme().text_dim);
  const float used = ImGui::GetItemRectMax().x - ImGui::GetWindowPos().x + ui.px(8);
  if (left + width - used < ui.px(70)) return;
  right_aligned(fitted(provenance_words(shown.recording->provenance), left + width - used), left + width);
}

bool begin_wide_table(const char* id, std::span<const char* const> columns) {
  if (!ImGui::BeginTable(id, static_cast<int>(columns.size()), kTableFlags)) return false;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    ImGui::TableSetupColumn(columns[i], ImGuiTableColumnFlags_WidthStretch, i == 0 ? 2.4F : 1.0F);
  }
  ImGui::TableHeadersRow();
  return true;
}

void text_cell(std::string_view words) {
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(words.data(), words.data() + words.size());
}

std::string summary(const Demonstration& shown) {
  std::string segments;
  for (const auto& span : shown.segments) segments += demonstration::letter(span.label);
  return seconds(shown.duration_s()) + " " + segments + " " + std::string(demonstration::to_string(shown.outcome())) +
         " " + provenance_words(shown.recording->provenance);
}

// A selectable card of two lines; returns whether it was clicked.
template <typename Draw>
bool card(Ui& ui, std::string_view label, bool selected, std::string_view value, Draw draw) {
  const float height = ui.px(50);
  const ImVec2 at = ImGui::GetCursorPos();
  const float width = ImGui::GetContentRegionAvail().x;
  const bool clicked = selectable_row(ui, label, selected, value, {.height = height});
  const ImVec2 next = ImGui::GetCursorPos();
  if (selected) {
    const Rect rect = item_rect();
    ImGui::GetWindowDrawList()->AddRectFilled({rect.x0, rect.y0}, {rect.x0 + ui.px(3), rect.y1},
                                              to_u32(ui.theme().accent));
  }
  ImGui::SetCursorPos({at.x + ui.px(10), at.y + ui.px(4)});
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ui.px(8), ui.px(5)});
  {
    const Scope row(ui, label);
    draw(width - ui.px(20));
  }
  ImGui::PopStyleVar();
  ImGui::SetCursorPos(next);
  return clicked;
}

// The wide table says itself how many there are and how many of them it shows.
std::string demonstrations_heading(const WorkbenchState& state, bool wide) {
  if (wide && !state.project->demonstrations.empty()) return "DEMONSTRATIONS";
  return "DEMONSTRATIONS  " + std::to_string(state.project->demonstrations.size());
}

std::string models_heading(const WorkbenchState& state) {
  return "MODELS  " + std::to_string(state.project->models.size());
}

// Above a list that has been scrolled, so that it is known of what the rows are.
void draw_pinned_heading(const Ui& ui, const std::string& words) {
  const FontScope font(ui.fonts().small);
  // While the heading itself can be seen there is no need of another.
  if (ImGui::GetScrollY() < ImGui::GetFontSize()) return;
  const ImVec2 at = ImGui::GetWindowPos();
  const float height = ImGui::GetFontSize() + ui.px(6);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(at, {at.x + ImGui::GetWindowContentRegionMax().x, at.y + height}, to_u32(ui.theme().panel));
  list.AddRectFilled({at.x, at.y + height}, {at.x + ImGui::GetWindowContentRegionMax().x, at.y + height + 1.0F},
                     to_u32(ui.theme().line));
  list.AddText({at.x, at.y}, to_u32(ui.theme().text_dim), words.c_str());
}

}  // namespace

void LibraryPanel::remember(const WorkbenchState& state) {
  if (!state.insight || state.insight->entry == nullptr) return;
  const learning::RolloutSummary& near = state.insight->around[2];
  arrival_[state.insight->entry->id] = percent(near.arrived, near.count);
}

std::string LibraryPanel::arrival_of(workbench::ModelId id) const {
  const auto found = arrival_.find(id);
  return found == arrival_.end() ? std::string() : found->second;
}

void LibraryPanel::draw_buttons(Ui& ui, const WorkbenchState& state, Requests& requests) {
  command_button(ui, state, "demo.record", "Record…", ButtonStyle::kPrimary, requests);
  flow(button_width(ui, "Train…", icon::kTrain), ui.px(8));
  command_button(ui, state, "model.train", "Train…", ButtonStyle::kNormal, requests);
  const std::array<std::string_view, 3> icons{"edit.trim_idle", "demo.verify", "edit.remove_demonstration"};
  const float all = 3.0F * (ImGui::GetFrameHeight() + ui.px(4)) + 2.0F * ui.px(2);
  const float icons_x = ImGui::GetWindowContentRegionMax().x - all;
  // Where the panel is narrow, the icons go below.
  if (icons_x > ImGui::GetItemRectMax().x - ImGui::GetWindowPos().x + ui.px(8)) ImGui::SameLine(icons_x);
  for (std::size_t i = 0; i < icons.size(); ++i) {
    if (i > 0) ImGui::SameLine(0.0F, ui.px(2));
    command_icon(ui, state, icons[i], requests);
  }
  ImGui::Dummy({0.0F, ui.px(1)});
}

Requests LibraryPanel::draw(Ui& ui, const WorkbenchState& state) {
  Requests requests;
  if (draw_no_project(ui, state, requests)) return requests;
  remember(state);
  // Cards where a table and its filter would leave no room for rows.
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const bool wide = room.x > ui.px(400) && room.y > ui.px(280);
  // The buttons stay in sight where there is room for them and for a list.
  const bool tall = room.y > ui.px(240);
  draw_buttons(ui, state, requests);
  // Measures take time; cards show none.
  if (state.library_on != wide) requests.emplace_back(workbench::Command{workbench::ShowLibrary{wide}});
  if (tall) ImGui::BeginChild("list");
  draw_demonstrations(ui, state, wide, requests);
  ImGui::Dummy({0.0F, ui.px(8)});
  const float models_y = ImGui::GetCursorPosY();
  draw_models(ui, state, wide, requests);
  draw_trash(ui, state, requests);
  if (tall) {
    draw_pinned_heading(ui,
                        ImGui::GetScrollY() < models_y ? demonstrations_heading(state, wide) : models_heading(state));
    ImGui::EndChild();
  }
  return requests;
}

void LibraryPanel::draw_demonstrations(Ui& ui, const WorkbenchState& state, bool wide, Requests& requests) {
  const auto& list = state.project->demonstrations;
  const Scope scope(ui, "Demonstrations");
  small_text(ui, demonstrations_heading(state, wide), ui.theme().text_dim);
  if (list.empty()) {
    const std::string_view busy = state.live ? "A transfer is being recorded" : "";
    const std::array<EmptyStateAction, 2> actions{
        {{"Record a transfer…", icon::kRecord, busy, "Scripted operators in the simulator"},
         {"Import…", icon::kPlus, busy, "Take in a file of another program"}}};
    const int clicked = empty_state(ui, icon::kFilm, "No demonstration yet",
                                    "Record one with the scripted operators, or import one", actions, ui.px(170));
    if (clicked == 0) requests.emplace_back(UiAction::kShowRecord);
    if (clicked == 1) requests.emplace_back(UiAction::kShowImport);
    return;
  }
  if (wide) return table_.draw(ui, state, ImGui::GetWindowHeight() - ui.px(150), requests);
  UniqueNames unique;
  for (const auto& [id, shown] : list) {
    const bool selected = id == state.demonstration;
    ImGui::PushID(static_cast<int>(id.value));
    const bool clicked = card(ui, unique(shown->name), selected, summary(*shown),
                              [&ui, &shown = shown](float width) { draw_card(ui, *shown, width); });
    ImGui::PopID();
    if (clicked && !selected) requests.emplace_back(workbench::Command{workbench::SelectDemonstration{id}});
  }
}

void LibraryPanel::draw_trash(Ui& ui, const WorkbenchState& state, Requests& requests) {
  const auto& trash = state.project->trash;
  if (trash.empty()) return;
  const Scope scope(ui, "Trash");
  ImGui::Dummy({0.0F, ui.px(8)});
  small_text(ui, "TRASH  " + std::to_string(trash.size()), ui.theme().text_dim);
  UniqueNames unique;
  for (const auto& [id, document] : trash) {
    const Scope row(ui, unique(document->name));
    const float width = button_width(ui, "Restore", icon::kUndo);
    const std::string words = document->name + "  " + seconds(document->duration_s());
    ImGui::AlignTextToFramePadding();
    dim_text(ui, fitted(words, ImGui::GetContentRegionAvail().x - width - ui.px(12)));
    flow(width, ui.px(8));
    const std::string_view reason = being_recorded(state);
    if (button(ui, "Restore", {.icon = icon::kUndo, .help = "Take it out of the trash", .reason = reason})) {
      requests.emplace_back(workbench::Command{workbench::CommitEdit{workbench::RestoreDemonstration{id}}});
    }
  }
}

namespace {

void draw_model_card(Ui& ui, const ModelEntry& entry, bool stale, const std::string& arrival, float width) {
  const float left = ImGui::GetCursorPosX();
  ImGui::TextUnformatted(fitted(entry.name, width - ui.px(100)).c_str());
  {
    const ColourScope dim(ImGuiCol_Text, ui.theme().text_dim);
    right_aligned(arrival, left + width);
  }
  ImGui::SetCursorPosX(left);
  segment_chip(ui, entry.segment, true, ui.px(17));
  ImGui::SameLine(0.0F, ui.px(8));
  if (stale) {
    badge(ui, icon::kWarning, "stale", ui.theme().warning, "A demonstration was edited since training");
    ImGui::SameLine(0.0F, ui.px(8));
  }
  std::string words(learning::to_string(entry.model->options.method));
  const std::string trained = words + "  " + elapsed(entry.model->seconds) + " to train";
  if (entry.model->options.method != learning::Method::kImported) {
    const FontScope font(ui.fonts().small);
    if (ImGui::CalcTextSize(trained.c_str()).x <= ImGui::GetContentRegionAvail().x) words = trained;
  }
  small_text(ui, words, ui.theme().text_dim);
}

void draw_model_cells(Ui& ui, const ModelEntry& entry, bool stale, const std::string& arrival) {
  text_cell(learning::to_string(entry.model->options.method));
  ImGui::TableNextColumn();
  segment_chip(ui, entry.segment, true, ui.px(17));
  text_cell(arrival);
  ImGui::TableNextColumn();
  if (stale) {
    badge(ui, icon::kWarning, "stale", ui.theme().warning, "A demonstration was edited since training");
  } else {
    dim_text(ui, "up to date");
  }
}

}  // namespace

void LibraryPanel::draw_models(Ui& ui, const WorkbenchState& state, bool wide, Requests& requests) {
  const auto& list = state.project->models;
  const Scope scope(ui, "Models");
  small_text(ui, models_heading(state), ui.theme().text_dim);
  if (list.empty()) {
    const std::string reason = command("model.train").reason_now(state);
    const std::array<EmptyStateAction, 1> actions{
        {{"Train a model…", icon::kTrain, reason, "Learn from demonstrations"}}};
    if (empty_state(ui, icon::kTrain, "", "No model yet: train one from a demonstration", actions, ui.px(130)) == 0) {
      requests.emplace_back(ShowPanel{PanelId::kTrain});
    }
    return;
  }
  const std::array<const char*, 5> columns{"Name", "Method", "Segment", "Arrives ±3", "State"};
  if (wide && !begin_wide_table("models", columns)) return;
  UniqueNames unique;
  for (const auto& [id, entry] : list) {
    const std::string name = unique(entry->name);
    const bool selected = id == state.model;
    const bool stale = state.project->stale(*entry);
    const std::string arrival = arrival_of(id);
    ImGui::PushID(static_cast<int>(id.value));
    bool clicked = false;
    if (wide) {
      ImGui::TableNextRow();
      ImGui::TableNextColumn();
      clicked = selectable_row(ui, name, selected, stale ? "stale" : "up to date", {.height = ui.px(20)});
      const Scope row(ui, name);
      ImGui::SameLine(0.0F, 0.0F);
      ImGui::TextUnformatted(entry->name.c_str());
      draw_model_cells(ui, *entry, stale, arrival);
    } else {
      clicked = card(ui, name, selected, stale ? "stale" : "up to date", [&, &entry = entry](float width) {
        draw_model_card(ui, *entry, stale, arrival.empty() ? arrival : arrival + " arrive", width);
      });
    }
    ImGui::PopID();
    if (clicked && !selected) requests.emplace_back(workbench::Command{workbench::SelectModel{id}});
  }
  if (wide) ImGui::EndTable();
}

}  // namespace trocar::ui
