#include "ui/panels/history_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>

#include "ui/format.h"
#include "ui/icons.h"
#include "ui/panels/common.h"
#include "ui/panels/sketch.h"

namespace trocar::ui {
namespace {

using workbench::Command;
using workbench::HistoryNode;
using workbench::HistoryRow;

constexpr float kRowHeight = 32.0F;
constexpr float kLaneWidth = 12.0F;

// "2026-03-01T12:03:41Z" to "12:03".
std::string_view clock_of(std::string_view iso) {
  return iso.size() >= 16 && iso[10] == 'T' ? iso.substr(11, 5) : iso;
}

std::string_view label_of(const WorkbenchState& state, const HistoryRow& row) {
  if (row.node == 0) return "Empty project";
  const HistoryNode& node = state.history[row.index];
  return node.description.empty() ? node.name : node.description;
}

std::string checkpoint_of(const WorkbenchState& state, std::int64_t node) {
  const auto found = state.checkpoints.find(node);
  return found == state.checkpoints.end() ? std::string() : found->second;
}

bool holds(std::string_view text, std::string_view word) {
  return lower_case(text).find(word) != std::string::npos;
}

}  // namespace

bool HistoryPanel::answers(const WorkbenchState& state, const HistoryRow& row) const {
  const std::string word = lower_case(search_);
  return holds(label_of(state, row), word) || holds(checkpoint_of(state, row.node), word) ||
         std::to_string(row.node) == word;
}

void HistoryPanel::follow(const WorkbenchState& state) {
  const bool same = of_count_ == state.history.size() && of_head_ == state.head && of_path_ == state.path.string();
  if (!same) {
    rows_ = workbench::history_graph(state.history, state.head);
    of_count_ = state.history.size();
    of_head_ = state.head;
    of_path_ = state.path.string();
    std::uint16_t used = 1;
    for (const HistoryRow& row : rows_) used = static_cast<std::uint16_t>(used | row.above | row.below);
    lanes_ = static_cast<int>(std::bit_width(used));
    asked_.clear();
  }
  if (same && searched_ == search_ && searched_checkpoints_ == state.checkpoints.size()) return;
  searched_ = search_;
  searched_checkpoints_ = state.checkpoints.size();
  shown_.clear();
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    if (!searching() || answers(state, rows_[i])) shown_.push_back(i);
  }
}

void HistoryPanel::draw_bar(Ui& ui, const WorkbenchState& state, Requests& requests) {
  const float width = std::min(ui.px(180), ImGui::GetContentRegionAvail().x);
  text_field(ui, "Search", search_, "Search the history",
             {.help = "What was done, a checkpoint's name or a number", .width = width});
  const std::string kept = checkpoint_of(state, state.head);
  if (name_of_ != state.head || name_seen_ != kept) {
    name_of_ = state.head;
    name_ = name_seen_ = kept;
  }
  flow(width, ui.px(6));
  if (text_field(ui, "Name", name_, "Name this state",
                 {.help = "A name for the state that the project is in, to find and compare it; empty: none",
                  .width = width}) &&
      name_ != kept) {
    requests.emplace_back(Command{workbench::NameCheckpoint{state.head, name_}});
  }
  flow(ImGui::GetFrameHeight() + ui.px(4), ui.px(4));
  command_icon(ui, state, "file.checkpoint", requests);
}

void HistoryPanel::draw_lanes(const Ui& ui, const HistoryRow& row, const Rect& rect, bool head) const {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const auto x_of = [&](int lane) { return rect.x0 + ui.px(12) + ui.px(kLaneWidth) * static_cast<float>(lane); };
  const float middle = rect.centre_y();
  const auto colour_of = [&](int lane) { return to_u32(lane == 0 ? ui.theme().text_dim : ui.theme().text_disabled); };
  const ImVec2 point{x_of(row.lane), middle};
  const float thick = ui.px(1.5F);
  for (int lane = 0; lane < lanes_; ++lane) {
    const auto bit = static_cast<std::uint16_t>(1U << lane);
    const bool above = (row.above & bit) != 0;
    const bool joins = (row.joins & bit) != 0;
    const bool below = (row.below & bit) != 0;
    const float x = x_of(lane);
    if (above && joins && lane != row.lane) {
      list.AddBezierQuadratic({x, rect.y0}, {x, middle}, point, colour_of(lane), thick);
      if (below) list.AddLine({x, rect.y0}, {x, rect.y1}, colour_of(lane), thick);
    } else if (above && !joins) {
      list.AddLine({x, rect.y0}, {x, rect.y1}, colour_of(lane), thick);
    } else {
      if (above) list.AddLine({x, rect.y0}, {x, middle}, colour_of(lane), thick);
      if (below && lane == row.lane) list.AddLine({x, middle}, {x, rect.y1}, colour_of(lane), thick);
    }
  }
  const Rgba colour = head ? ui.theme().accent : row.done ? ui.theme().text_dim : ui.theme().text_disabled;
  // What is done is filled, what is ahead or on a branch that was left is hollow.
  list.AddCircleFilled(point, ui.px(4), to_u32(row.done ? colour : ui.theme().panel), 12);
  if (!row.done) list.AddCircle(point, ui.px(4), to_u32(colour), 12, thick);
}

void HistoryPanel::draw_buttons(Ui& ui, const WorkbenchState& state, const HistoryRow& row, Requests& requests) const {
  const std::string reason = state.live                                 ? std::string(being_recorded(state))
                             : selected_demonstration(state) == nullptr ? "No demonstration is selected"
                             : row.node < state.demonstration.value     ? "It was not there yet"
                                                                        : "";
  if (icon_button(ui, "Compare with",
                  {.icon = icon::kAdjust,
                   .help = "Compare the selected demonstration with itself at this point",
                   .reason = reason,
                   .style = ButtonStyle::kQuiet})) {
    workbench::ComparisonSettings settings;
    settings.against = {workbench::Against::Kind::kHistory, {}, row.node};
    requests.emplace_back(Command{workbench::CompareWith{settings}});
    requests.emplace_back(ShowPanel{PanelId::kDiff});
  }
}

void HistoryPanel::keep_head_in_sight(const Ui& ui, const WorkbenchState& state) {
  if (in_sight_ == state.head) return;
  in_sight_ = state.head;
  const auto found =
      std::find_if(shown_.begin(), shown_.end(), [&](std::size_t i) { return rows_[i].node == state.head; });
  if (found == shown_.end()) return;
  const float top = ui.px(kRowHeight) * static_cast<float>(found - shown_.begin());
  const float height = ImGui::GetWindowHeight();
  const bool seen = top >= ImGui::GetScrollY() && top + ui.px(kRowHeight) <= ImGui::GetScrollY() + height;
  if (!seen) ImGui::SetScrollY(std::max(top - 0.5F * height, 0.0F));
}

void HistoryPanel::draw_row(Ui& ui, const WorkbenchState& state, const HistoryRow& row, Requests& requests) {
  const bool head = row.node == state.head;
  const std::string label(label_of(state, row));
  const std::string checkpoint = checkpoint_of(state, row.node);
  const std::string name = fmt::format("{} · {}", row.node, label);
  const float height = ui.px(kRowHeight);
  const std::string help = label + ": go to this state; nothing is lost";
  const std::string value = head ? (checkpoint.empty() ? "HEAD" : "HEAD " + checkpoint) : checkpoint;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const bool clicked =
      selectable_row(ui, name, head, value, {.help = help, .reason = being_recorded(state), .height = height});
  const ImVec2 next = ImGui::GetCursorScreenPos();
  const Rect rect{at.x, at.y, at.x + ImGui::GetContentRegionAvail().x, at.y + height};
  float left = rect.x0 + ui.px(8);
  if (!searching()) {
    draw_lanes(ui, row, rect, head);
    left += ui.px(kLaneWidth) * static_cast<float>(lanes_) + ui.px(4);
  }
  const float tall = height - ui.px(6);
  const auto sketch = state.sketches.find(row.node);
  const Rect picture{left, rect.y0 + ui.px(3), left + tall * workbench::kSketchAspect, rect.y0 + ui.px(3) + tall};
  if (sketch != state.sketches.end() && sketch->second) draw_sketch(ui, *sketch->second, picture);
  left = picture.x1 + ui.px(8);
  const std::string clock(row.node == 0 ? std::string_view() : clock_of(state.history[row.index].time));
  const float button_x = rect.x1 - ImGui::GetFrameHeight() - ui.px(6);
  const float clock_x = button_x - ImGui::CalcTextSize("00:00").x - ui.px(8);
  const float text_y = rect.y0 + 0.5F * (height - ImGui::GetTextLineHeight());
  const bool line = row.done || row.ahead;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (!checkpoint.empty()) {
    const std::string words = fitted(fmt::format("{} {}", icon::kBook, checkpoint), 0.5F * (clock_x - left));
    list.AddText({left, text_y}, to_u32(ui.theme().accent), words.c_str());
    left += ImGui::CalcTextSize(words.c_str()).x + ui.px(8);
  }
  const Rgba ink = state.live ? ui.theme().text_disabled : line ? ui.theme().text : ui.theme().text_dim;
  list.AddText({left, text_y}, to_u32(ink), fitted(label, std::max(clock_x - left - ui.px(6), 0.0F)).c_str());
  list.AddText({clock_x, text_y}, to_u32(ui.theme().text_dim), clock.c_str());
  {
    const Scope scope(ui, name);
    ImGui::SetCursorScreenPos({button_x, rect.y0 + 0.5F * (height - ImGui::GetFrameHeight())});
    draw_buttons(ui, state, row, requests);
  }
  ImGui::SetCursorScreenPos(next);
  if (clicked && !head && !state.live) requests.emplace_back(Command{workbench::GoToHistory{row.node}});
}

Requests HistoryPanel::draw(Ui& ui, const WorkbenchState& state) {
  Requests requests;
  if (draw_no_project(ui, state, requests)) return requests;
  if (state.history.empty()) {
    empty_state(ui, icon::kHistory, "", "Every edit appears here and can be undone, also tomorrow", {});
    return requests;
  }
  draw_bar(ui, state, requests);
  follow(state);
  if (shown_.empty()) {
    const std::array<EmptyStateAction, 1> actions{{{"Show all", icon::kExpand, {}, "Clear the search"}}};
    if (empty_state(ui, icon::kSearch, "", "Nothing in the history answers", actions) == 0) search_.clear();
    return requests;
  }
  std::vector<std::int64_t> seen;
  // The search stays in sight where there is room for it and for a list.
  const bool tall = ImGui::GetContentRegionAvail().y > ui.px(4.0F * kRowHeight);
  if (tall) ImGui::BeginChild("rows");
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ui.px(8), 0.0F});
  if (tall) keep_head_in_sight(ui, state);
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(shown_.size()), ui.px(kRowHeight));
  while (clipper.Step()) {
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
      const HistoryRow& row = rows_[shown_[static_cast<std::size_t>(i)]];
      ImGui::PushID(static_cast<int>(row.node));
      draw_row(ui, state, row, requests);
      ImGui::PopID();
      if (row.node != 0 && !state.sketches.contains(row.node)) seen.push_back(row.node);
    }
  }
  ImGui::PopStyleVar();
  if (tall) ImGui::EndChild();
  if (seen != asked_ && !seen.empty()) requests.emplace_back(Command{workbench::SketchHistory{seen}});
  asked_ = std::move(seen);
  return requests;
}

}  // namespace trocar::ui
