#include "ui/panels/library_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "ui/icons.h"
#include "ui/panels/common.h"

namespace trocar::ui {
namespace {

using workbench::Command;
using workbench::DemonstrationId;
using workbench::LibraryColumn;
using workbench::LibraryRow;

struct ShownColumn {
  const char* id;
  float width;  ///< At 100 %.
};
constexpr std::array<ShownColumn, 15> kShown{{{"name", 190},
                                              {"length", 74},
                                              {"segment", 104},
                                              {"outcome", 92},
                                              {"flag", 66},
                                              {"tag", 110},
                                              {"jerk", 134},
                                              {"idle", 58},
                                              {"path", 62},
                                              {"clearance", 86},
                                              {"grid", 92},
                                              {"odd", 108},
                                              {"replay", 84},
                                              {"model", 120},
                                              {"source", 120}}};
constexpr float kLibraryRowHeight = 58.0F;  // A path can be told in a picture of this height.

std::string head_of(const LibraryColumn& column) {
  return column.unit.empty() ? std::string(column.title) : fmt::format("{} [{}]", column.title, column.unit);
}

const char* flag_sign(workbench::Flag flag) {
  switch (flag) {
    case workbench::Flag::kNone:
      return "";
    case workbench::Flag::kGood:
      return icon::kVerify;
    case workbench::Flag::kBad:
      return icon::kCross;
    case workbench::Flag::kUnsure:
      return icon::kHelp;
  }
  return "";
}

Rgba cell_colour(const Theme& theme, const LibraryColumn& column, const LibraryRow& row) {
  if (column.id == "flag" && row.marks.flag == workbench::Flag::kGood) return theme.good;
  if (column.id == "flag" && row.marks.flag == workbench::Flag::kBad) return theme.danger;
  if (column.id == "flag" && row.marks.flag == workbench::Flag::kUnsure) return theme.warning;
  if (column.id == "outcome") return outcome_colour(theme, row.outcome);
  if (column.id == "replay" && row.replay) return row.replay->verified ? theme.good : theme.danger;
  if (column.id == "model" && row.models_stale) return theme.warning;
  const workbench::LibraryCell cell = column.cell(row);
  const bool there = cell.kind == workbench::LibraryCell::Kind::kNumber || column.id == "name";
  return there ? theme.text : theme.text_dim;
}

/// With a sign where colour alone would tell.
std::string cell_words(const LibraryColumn& column, const LibraryRow& row) {
  std::string words = workbench::shown_cell(column, row);
  if (column.id == "flag" && row.marks.flag != workbench::Flag::kNone) {
    return fmt::format("{} {}", flag_sign(row.marks.flag), words);
  }
  if (column.id == "outcome") return fmt::format("{} {}", outcome_sign(row.outcome), words);
  if (column.id == "replay" && row.replay) {
    return fmt::format("{} {}", row.replay->verified ? icon::kVerify : icon::kCross, words);
  }
  if (column.id == "model" && row.models_stale) return fmt::format("{} {}", icon::kWarning, words);
  if (column.id == "odd" && row.oddity && row.oddity->deviations >= 1.0) words += " " + row.oddity->in;
  return words;
}

/// What a screen reader and a script hear of a row.
std::string summary_of(const LibraryRow& row) {
  std::string words =
      fmt::format("{:.2f} s {} {}", row.duration_s, row.segments, demonstration::to_string(row.outcome));
  if (row.marks.flag != workbench::Flag::kNone) words += fmt::format(" {}", to_string(row.marks.flag));
  for (const std::string& tag : row.marks.tags) words += " #" + tag;
  if (row.duplicate != DemonstrationId{}) words += " duplicate";
  return words;
}

/// In the middle of the row, numbers to the right.
void draw_cell(const Ui& ui, const LibraryColumn& column, const LibraryRow& row, float top) {
  const float room = ImGui::GetContentRegionAvail().x;
  const std::string words = fitted(cell_words(column, row), room);
  const float left = ImGui::GetCursorPosX();
  if (column.number) ImGui::SetCursorPosX(left + std::max(room - ImGui::CalcTextSize(words.c_str()).x, 0.0F));
  ImGui::SetCursorPosY(top + 0.5F * (ui.px(kLibraryRowHeight) - ImGui::GetTextLineHeight()));
  const ColourScope colour(ImGuiCol_Text, cell_colour(ui.theme(), column, row));
  ImGui::TextUnformatted(words.c_str());
}

}  // namespace

void LibraryTable::sort_by(const LibraryColumn& column) {
  descending_ = sort_ == column.id && !descending_;
  // The largest number is what one looks for first.
  if (sort_ != column.id) descending_ = column.number && column.id != "id";
  sort_ = column.id;
  sorted_ = false;
}

void LibraryTable::follow(const WorkbenchState& state) {
  if (view_ == state.library && filtered_ == filter_.version() && sorted_) return;
  view_ = state.library;
  filtered_ = filter_.version();
  sorted_ = true;
  rows_.clear();
  names_.clear();
  if (!view_) return;
  rows_ = workbench::matching(*view_, filter_.query(), undecided_);
  workbench::sort_library(rows_, *workbench::find_library_column(sort_), descending_);
  UniqueNames unique;
  for (const LibraryRow* row : rows_) names_.push_back(unique(row->name));
  std::erase_if(chosen_, [this](DemonstrationId id) {
    return std::none_of(rows_.begin(), rows_.end(), [id](const LibraryRow* row) { return row->id == id; });
  });
}

void LibraryTable::draw_heads(Ui& ui) {
  const Scope scope(ui, "Columns");
  ImGui::TableNextRow(ImGuiTableRowFlags_Headers);
  ImGui::TableNextColumn();
  for (const ShownColumn& shown : kShown) {
    const LibraryColumn& column = *workbench::find_library_column(shown.id);
    ImGui::TableNextColumn();
    const bool sorted = sort_ == column.id;
    const std::string words = head_of(column);
    const char* arrow = !sorted ? "" : descending_ ? icon::kArrowDown : icon::kArrowUp;
    const float room = ImGui::GetContentRegionAvail().x;
    const ImVec2 at = ImGui::GetCursorPos();
    const bool clicked = ImGui::InvisibleButton(column.id.data(), {std::max(room, 1.0F), ui.px(24)});
    const std::string help = fmt::format("{}; click to sort", column.help);
    note_item(ui, "button", column.title, !sorted ? "" : descending_ ? "falling" : "rising", {.help = help});
    const bool hovered = ImGui::IsItemHovered();
    ImGui::SetCursorPos({at.x, at.y + 0.5F * (ui.px(24) - ImGui::GetTextLineHeight())});
    const ColourScope colour(ImGuiCol_Text, sorted || hovered ? ui.theme().text : ui.theme().text_dim);
    const std::string shown_words = fitted(sorted ? fmt::format("{} {}", words, arrow) : words, room);
    ImGui::TextUnformatted(shown_words.c_str());
    if (!clicked) continue;
    sort_by(column);
    ui.animate();
  }
}

void LibraryTable::choose(std::size_t place, Requests& requests) {
  const ImGuiIO& io = ImGui::GetIO();
  const DemonstrationId id = rows_[place]->id;
  if (io.KeyShift && anchor_ != DemonstrationId{}) {
    const auto from = std::find_if(rows_.begin(), rows_.end(), [this](const auto* row) { return row->id == anchor_; });
    const std::size_t begin = from == rows_.end() ? place : static_cast<std::size_t>(from - rows_.begin());
    chosen_.clear();
    for (std::size_t i = std::min(begin, place); i <= std::max(begin, place); ++i) chosen_.insert(rows_[i]->id);
    return;
  }
  anchor_ = id;
  if (io.KeyCtrl) {
    if (chosen_.erase(id) == 0) chosen_.insert(id);
    return;
  }
  chosen_ = {id};
  requests.emplace_back(Command{workbench::SelectDemonstration{id}});
}

void LibraryTable::draw_name(Ui& ui, const WorkbenchState& state, std::size_t place, const std::string& name,
                             Requests& requests) {
  const LibraryRow& row = *rows_[place];
  const float height = ui.px(kLibraryRowHeight);
  const bool chosen = chosen_.contains(row.id);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  if (selectable_row(ui, name, chosen || row.id == state.demonstration, summary_of(row), {.height = height})) {
    choose(place, requests);
  }
  const Scope scope(ui, name);
  const ImVec2 next = ImGui::GetCursorScreenPos();
  const float box = ui.px(24);
  ImGui::SetCursorScreenPos({at.x, at.y + 0.5F * (height - box)});
  if (toggle_shown_as(
          ui, "Choose", chosen ? icon::kVerify : " ", chosen,
          {.help = "Choose it for an act on several; Shift and Ctrl with a click choose more", .width = box})) {
    anchor_ = row.id;
    if (chosen_.erase(row.id) == 0) chosen_.insert(row.id);
  }
  if (!chosen) {
    const Rect square = item_rect();
    ImGui::GetWindowDrawList()->AddRect({square.x0 + ui.px(3), square.y0 + ui.px(4)},
                                        {square.x1 - ui.px(3), square.y1 - ui.px(4)}, to_u32(ui.theme().text_dim),
                                        ui.px(3));
  }
  const float left = at.x + box + ui.px(6);
  const auto document = state.project->demonstrations.find(row.id);
  const float tall = height - ui.px(4);
  const Rect picture{left, at.y + ui.px(2), left + tall * workbench::kSketchAspect, at.y + ui.px(2) + tall};
  if (document != state.project->demonstrations.end()) draw_sketch(ui, sketches_.of(document->second), picture);
  ImGui::SetCursorScreenPos(next);
}

void LibraryTable::draw_row(Ui& ui, const WorkbenchState& state, std::size_t place, const std::string& name,
                            Requests& requests) {
  const LibraryRow& row = *rows_[place];
  ImGui::PushID(static_cast<int>(row.id.value));
  ImGui::TableNextRow(ImGuiTableRowFlags_None, ui.px(kLibraryRowHeight));
  ImGui::TableNextColumn();
  const float top = ImGui::GetCursorPosY();
  draw_name(ui, state, place, name, requests);
  for (const ShownColumn& shown : kShown) {
    if (!ImGui::TableNextColumn()) continue;
    draw_cell(ui, *workbench::find_library_column(shown.id), row, top);
  }
  ImGui::PopID();
}

bool LibraryTable::draw_nothing(Ui& ui, const WorkbenchState& state) {
  if (!view_) {
    empty_state(ui, icon::kClock, "", "Gathering the demonstrations", {}, ui.px(120));
    ui.animate();
    return true;
  }
  if (!rows_.empty()) return false;
  const std::array<EmptyStateAction, 1> actions{{{"Show all", icon::kExpand, {}, "Clear the filter"}}};
  const bool waiting = undecided_ > 0;
  const char* sentence = waiting ? "Nothing answers the filter so far; some are still being measured"
                                 : "No demonstration answers the filter";
  if (empty_state(ui, icon::kSearch, "", sentence, actions, ui.px(120)) == 0) filter_.clear();
  if (waiting && state.library_pending) ui.animate();
  return true;
}

void LibraryTable::draw_choice(Ui& ui) {
  flow(button_width(ui, "Choose all", nullptr), ui.px(8));
  const char* nothing = rows_.empty() ? "Nothing is shown" : "";
  if (button(ui, "Choose all", {.help = "Choose everything that is shown", .reason = nothing})) {
    for (const LibraryRow* row : rows_) chosen_.insert(row->id);
  }
  if (chosen_.empty()) return;
  flow(button_width(ui, "Choose none", nullptr), ui.px(4));
  if (button(ui, "Choose none", {.help = "Choose nothing", .style = ButtonStyle::kQuiet})) chosen_.clear();
}

void LibraryTable::draw(Ui& ui, const WorkbenchState& state, float height, Requests& requests) {
  follow(state);
  filter_.draw(ui, state, rows_.size(), state.project->demonstrations.size(), undecided_, requests);
  draw_choice(ui);
  batch_.draw(ui, state, chosen_, requests);
  follow(state);
  if (draw_nothing(ui, state)) return;
  constexpr ImGuiTableFlags kFlags = ImGuiTableFlags_RowBg | ImGuiTableFlags_BordersInnerH | ImGuiTableFlags_PadOuterX |
                                     ImGuiTableFlags_Resizable | ImGuiTableFlags_ScrollX | ImGuiTableFlags_ScrollY;
  const int columns = static_cast<int>(kShown.size()) + 1;
  // No higher than its rows, and its bar for scrolling in sight.
  const float line = ui.px(kLibraryRowHeight + 14);
  const float needed = ui.px(56) + line * static_cast<float>(rows_.size());
  if (!ImGui::BeginTable("table", columns, kFlags, {0.0F, std::min(needed, std::max(height, 3.0F * line))})) {
    return;
  }
  ImGui::TableSetupScrollFreeze(1, 1);
  ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthFixed,
                          ui.px(34 + (kLibraryRowHeight - 4) * workbench::kSketchAspect));
  for (const ShownColumn& shown : kShown) {
    ImGui::TableSetupColumn(shown.id, ImGuiTableColumnFlags_WidthFixed, ui.px(shown.width));
  }
  draw_heads(ui);
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(rows_.size()));
  while (clipper.Step()) {
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
      const auto place = static_cast<std::size_t>(i);
      draw_row(ui, state, place, names_[place], requests);
    }
  }
  ImGui::EndTable();
}

}  // namespace trocar::ui
