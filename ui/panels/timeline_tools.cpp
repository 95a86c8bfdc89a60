#include "ui/panels/timeline_tools.h"

#include <fmt/format.h>

#include <array>
#include <charconv>

#include "ui/format.h"
#include "ui/icons.h"
#include "ui/panels/common.h"

namespace trocar::ui {
namespace {

using workbench::Command;
using workbench::Loop;
using workbench::SetSelection;
using workbench::TimeSpan;

constexpr float kFieldWidth = 74.0F;  // At 100 %: "1234.567" and its margins.

std::optional<double> seconds_in(const std::string& words) {
  double value = 0.0;
  const char* begin = words.data();
  const char* end = begin + words.size();
  while (begin < end && *begin == ' ') ++begin;
  const auto [rest, error] = std::from_chars(begin, end, value);
  if (error != std::errc{}) return std::nullopt;
  const std::string_view unit(rest, static_cast<std::size_t>(end - rest));
  return unit.find_first_not_of(" s") == std::string_view::npos ? std::optional(value) : std::nullopt;
}

// An icon of a row of the command table that stays down.
void command_toggle(Ui& ui, const WorkbenchState& state, std::string_view id, std::string_view label, bool on,
                    Requests& requests) {
  const CommandRow& row = command(id);
  const std::string reason = row.reason_now(state);
  const std::string keys(shown_keys(ui, row.id));
  const float width = ImGui::GetFrameHeight() + ui.px(4);
  flow(width, ui.px(2));
  if (toggle(ui, label, on,
             {.icon = row.icon, .icon_only = true, .help = row.help, .shortcut = keys, .reason = reason})) {
    append(requests, row.run(state));
  }
}

}  // namespace

void TimelineTools::draw_numbers(Ui& ui, const WorkbenchState& state, const demonstration::Demonstration& shown,
                                 Requests& requests) {
  const Scope scope(ui, "Selection");
  if (written_ != state.selection || (!state.selection && from_.empty() && to_.empty())) {
    written_ = state.selection;
    from_ = written_ ? fmt::format("{:.3f}", written_->begin_s) : "";
    to_ = written_ ? fmt::format("{:.3f}", written_->end_s) : "";
  }
  const float width = ui.px(kFieldWidth);
  const bool from =
      text_field(ui, "From", from_, "from s", {.help = "Begin of the selection, seconds", .width = width});
  flow(width, ui.px(4));
  const bool to = text_field(ui, "To", to_, "to s", {.help = "End of the selection, seconds", .width = width});
  if (from || to) {
    const auto begin_s = seconds_in(from_);
    const auto end_s = seconds_in(to_);
    const bool understood = (begin_s || from_.empty()) && (end_s || to_.empty());
    if (understood && (begin_s || end_s)) {
      TimeSpan typed{begin_s.value_or(shown.begin_s), end_s.value_or(shown.end_s)};
      // What is typed last stands; the other end keeps its distance where it would be passed.
      const double length_s = state.selection ? state.selection->length_s() : 1.0;
      if (typed.begin_s >= typed.end_s && from) typed.end_s = std::min(typed.begin_s + length_s, shown.end_s);
      if (typed.begin_s >= typed.end_s && to) typed.begin_s = std::max(typed.end_s - length_s, shown.begin_s);
      requests.emplace_back(Command{SetSelection{typed}});
    } else if (understood && state.selection) {
      requests.emplace_back(Command{SetSelection{}});
    }
    // Say what it has become, also if nothing came of what was typed.
    written_.reset();
    from_.clear();
    to_.clear();
  }
  const std::string length = written_ ? seconds(written_->length_s()) : "nothing selected";
  flow(ImGui::CalcTextSize("nothing selected").x, ui.px(8));
  ImGui::AlignTextToFramePadding();
  const float x0 = ImGui::GetCursorPosX();
  {
    const ColourScope colour(ImGuiCol_Text, ui.theme().text_dim);
    ImGui::TextUnformatted(length.c_str());
  }
  note_item(ui, "text", "Length", length, {});
  ImGui::SameLine(x0 + ImGui::CalcTextSize("nothing selected").x);
  ImGui::Dummy({0.0F, 0.0F});
}

void TimelineTools::draw_lane_menu(Ui& ui, LaneSet& lanes) const {
  if (icon_button(ui, "Lanes shown…",
                  {.icon = icon::kList, .help = "Choose the lanes", .style = ButtonStyle::kQuiet})) {
    ImGui::OpenPopup("lanes shown");
  }
  if (!ImGui::BeginPopup("lanes shown")) return;
  {
    const Scope scope(ui, "Lanes shown");
    for (std::size_t i = 0; i < kLaneCount; ++i) {
      bool on = lanes[i];
      if (checkbox(ui, name_of(static_cast<Lane>(i)), on, {.help = help_of(static_cast<Lane>(i))})) lanes[i] = on;
    }
  }
  ImGui::EndPopup();
}

void TimelineTools::draw(Ui& ui, const WorkbenchState& state, const demonstration::Demonstration& shown, LaneSet& lanes,
                         Requests& requests) {
  draw_numbers(ui, state, shown, requests);
  const float width = ImGui::GetFrameHeight() + ui.px(4);
  float gap = ui.px(12);
  for (const char* id : {"edit.cut", "edit.copy", "edit.paste", "edit.ripple_delete", "edit.lift"}) {
    flow(width, gap);
    command_icon(ui, state, id, requests);
    gap = ui.px(2);
  }
  ImGui::SameLine(0.0F, ui.px(8));
  ImGui::Dummy({0.0F, 0.0F});
  command_toggle(ui, state, "transport.snap", "Snap", state.snapping, requests);
  command_toggle(ui, state, "transport.loop", "Loop", state.loop == Loop::kSpan, requests);
  flow(width, ui.px(2));
  draw_lane_menu(ui, lanes);
}

}  // namespace trocar::ui
