#include "ui/panels/diff_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "engine/workbench/whiskers.h"
#include "ui/command_text.h"
#include "ui/format.h"
#include "ui/icons.h"
#include "ui/panels/common.h"
#include "ui/panels/timed_plot.h"

namespace trocar::ui {
namespace {

using demonstration::Alignment;
using demonstration::Comparison;
using demonstration::Demonstration;
using workbench::Against;
using workbench::Command;
using workbench::CompareWith;
using workbench::ComparisonSettings;
using workbench::ComparisonView;

constexpr std::size_t kMostPoints = 40;

struct Choice {
  std::string name;
  Against against;
};

/// The original, the other demonstrations, and the points of the history since it is there, newest first.
std::vector<Choice> choices_of(const WorkbenchState& state) {
  std::vector<Choice> choices{{"Original, as it was recorded", {}}};
  for (const auto& [id, other] : state.project->demonstrations) {
    if (id == state.demonstration) continue;
    choices.push_back({fmt::format("{} · {}", other->name, id.value), {Against::Kind::kDemonstration, id, 0}});
  }
  std::size_t points = 0;
  for (auto node = state.history.rbegin(); node != state.history.rend() && points < kMostPoints; ++node) {
    if (node->id < state.demonstration.value || node->id == state.head) continue;
    const std::string& words = node->description.empty() ? node->name : node->description;
    choices.push_back({fmt::format("Point {}: {}", node->id, words), {Against::Kind::kHistory, {}, node->id}});
    ++points;
  }
  return choices;
}

std::string with_sign(double value, int digits, std::string_view unit) {
  const std::string size = fmt::format("{:.{}f}", std::abs(value), digits);
  const bool none = size.find_first_of("123456789") == std::string::npos;
  return fmt::format("{}{} {}", none ? "±" : value < 0.0 ? "\u2212" : "+", size, unit);
}

std::string was_words(double before, double after, int digits, std::string_view unit) {
  return fmt::format("{:.{}f} {}, was {:.{}f} ({})", after, digits, unit, before, digits,
                     with_sign(after - before, digits, unit));
}

std::string was_words(std::optional<double> before, std::optional<double> after, int digits, std::string_view unit) {
  if (before && after) return was_words(*before, *after, digits, unit);
  const auto told = [&](std::optional<double> value) {
    return value ? fmt::format("{:.{}f} {}", *value, digits, unit) : std::string("unknown");
  };
  return fmt::format("{}, was {}", told(after), told(before));
}

void draw_facts(Ui& ui, const Comparison& comparison) {
  const Scope scope(ui, "Numbers");
  const demonstration::Difference& difference = comparison.difference;
  const auto mm = [](double metres) { return number(1e3 * metres); };
  fact(ui, "Deviation",
       fmt::format("max {}, mean {}, 95 % {} mm", mm(comparison.both.max_m), mm(comparison.both.mean_m),
                   mm(comparison.both.share_95_m)));
  fact(ui, "Duration", was_words(comparison.before_s, comparison.after_s, 2, "s"));
  fact(ui, "Samples",
       fmt::format("{} removed, {} added, {} moved", count(difference.removed), count(difference.added),
                   count(difference.moved)));
  fact(ui, "Cells", fmt::format("{} lost, {} gained", comparison.cells_lost, comparison.cells_gained));
  for (std::size_t arm = 0; arm < 2; ++arm) {
    fact(ui, arm == 0 ? "Path, left" : "Path, right",
         was_words(1e3 * comparison.path_before_m[arm], 1e3 * comparison.path_after_m[arm], 1, "mm"));
  }
  for (std::size_t arm = 0; arm < 2; ++arm) {
    fact(ui, arm == 0 ? "Raw jerk, left" : "Raw jerk, right",
         was_words(comparison.jerk_before_m_s3[arm], comparison.jerk_after_m_s3[arm], 2, "m/s³"));
  }
  UniqueNames unique;
  for (const std::string& clause : comparison.labels) {
    ImGui::PushTextWrapPos(0.0F);
    ImGui::TextUnformatted(clause.c_str());
    ImGui::PopTextWrapPos();
    note_item(ui, "text", unique("Also"), clause, {});
  }
}

/// What the colours of the whiskers mean.
void draw_whisker_key(Ui& ui, double max_m) {
  const FontScope font(ui.fonts().small);
  const std::string most = millimetres(max_m);
  const float strip = ui.px(60);
  const float width = ImGui::CalcTextSize(("0" + most).c_str()).x + strip + ui.px(16);
  flow(width, ui.px(10));
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float middle = at.y + 0.5F * ImGui::GetFrameHeight();
  const float text = std::round(middle - 0.5F * ImGui::GetFontSize());
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddText({at.x, text}, to_u32(ui.theme().text_dim), "0");
  const float x0 = at.x + ImGui::CalcTextSize("0").x + ui.px(6);
  constexpr int kSteps = 30;
  for (int i = 0; i < kSteps; ++i) {
    // Thicker with the deviation, as in the view.
    const float share = static_cast<float>(i) / static_cast<float>(kSteps - 1);
    const float half = ui.px(2) + share * ui.px(4);
    const float x = x0 + strip * static_cast<float>(i) / static_cast<float>(kSteps);
    list.AddRectFilled({x, middle - half}, {x + strip / static_cast<float>(kSteps) + 1.0F, middle + half},
                       to_u32(workbench::whisker_colour(static_cast<double>(share))));
  }
  list.AddText({x0 + strip + ui.px(6), text}, to_u32(ui.theme().text_dim), most.c_str());
  ImGui::Dummy({width, ImGui::GetFrameHeight()});
  note_item(ui, "text", "Whiskers", "0 … " + most,
            {.help = "Colour and thickness of the lines between the two paths in the 3-D view"});
}

bool nothing_differs(const Comparison& comparison) {
  const demonstration::Difference& difference = comparison.difference;
  return difference.moved == 0 && difference.removed == 0 && difference.added == 0 && comparison.labels.empty() &&
         difference.duration_change_s == 0.0;
}

}  // namespace

void DiffPanel::draw_choice(Ui& ui, const WorkbenchState& state, const ComparisonSettings& settings,
                            Requests& requests) const {
  ComparisonSettings wanted = settings;
  const std::vector<Choice> choices = choices_of(state);
  std::vector<std::string> names;
  int chosen = -1;
  for (const Choice& choice : choices) {
    if (choice.against == settings.against) chosen = static_cast<int>(names.size());
    names.push_back(choice.name);
  }
  const float room = ImGui::GetContentRegionAvail().x;
  if (combo(ui, "Against", chosen, names,
            {.help = "What the demonstration is compared with", .width = std::min(ui.px(230), room)})) {
    wanted.against = choices[static_cast<std::size_t>(chosen)].against;
  }
  static const std::array<std::string, 4> kAlignmentNames{"By time", "By arc length", "By warping", "By segment"};
  int aligned = static_cast<int>(settings.alignment);
  const float width = std::min(ui.px(140), room);
  flow(width, ui.px(8));
  if (combo(
          ui, "Aligned", aligned, kAlignmentNames,
          {.help = "Which instants answer to each other: the same time, the same share of the path, the matching with "
                   "the least distance, or the same share of the segment",
           .width = width})) {
    wanted.alignment = static_cast<Alignment>(aligned);
  }
  flow(button_width(ui, "In the view", icon::kEye), ui.px(8));
  if (toggle(ui, "In the view", settings.in_view,
             {.icon = icon::kEye, .help = "Draw the other path in the 3-D view, and how far the tools are from it"})) {
    wanted.in_view = !settings.in_view;
  }
  flow(button_width(ui, "Copy as command", icon::kCopy), ui.px(4));
  if (button(ui, "Copy as command",
             {.icon = icon::kCopy, .help = "Copy this comparison as a command line", .style = ButtonStyle::kQuiet})) {
    requests.emplace_back(CopyText{command_text(Command{CompareWith{settings}}, state)});
  }
  if (!(wanted == settings) || !state.comparing) requests.emplace_back(Command{CompareWith{wanted}});
}

void DiffPanel::draw_deviation(Ui& ui, const WorkbenchState& state, const ComparisonView& view, Requests& requests) {
  const Demonstration& after = *view.of.after;
  std::vector<PlotLine> lines;
  plot::Extent all{0.0, 0.0};
  for (int arm = 0; arm < 2; ++arm) {
    const plot::Curve* curve = view.deviation_mm[static_cast<std::size_t>(arm)].get();
    lines.push_back({std::string(workbench::arm_title(arm)), curve, arm_colour(ui.theme(), arm),
                     arm == 0 ? LineStyle::kSolid : LineStyle::kDashed});
    const std::optional<plot::Extent> one = curve->extent(time_->range.begin_s, time_->range.end_s);
    if (one) all.high = std::max(all.high, one->high);
  }
  PlotSpec spec = timed_plot(*time_, after, state.playhead_s, cursor_s_);
  spec.label = "Deviation";
  spec.unit = "mm";
  spec.lines = lines;
  spec.values = plot::value_range(all, true, {});
  spec.height = std::max(ui.px(120), std::min(ImGui::GetContentRegionAvail().y, ui.px(260)));
  const PlotActs acts = plot(ui, spec);
  cursor_s_ = acts.cursor_s;
  follow_plot(acts, after.full_duration_s(), *time_, requests);
}

void DiffPanel::draw_result(Ui& ui, const WorkbenchState& state, const ComparisonView& view, Requests& requests) {
  const Comparison& comparison = *view.comparison;
  ImGui::Dummy({0.0F, ui.px(2)});
  if (nothing_differs(comparison)) badge(ui, icon::kVerify, "Nothing differs", ui.theme().good);
  const float room = ImGui::GetContentRegionAvail().x;
  if (room < ui.px(720)) {
    draw_deviation(ui, state, view, requests);
    return draw_facts(ui, comparison);
  }
  if (!ImGui::BeginTable("##result", 2)) return;
  ImGui::TableSetupColumn("##numbers", ImGuiTableColumnFlags_WidthFixed, ui.px(415));
  ImGui::TableSetupColumn("##plot", ImGuiTableColumnFlags_WidthStretch);
  ImGui::TableNextColumn();
  draw_facts(ui, comparison);
  ImGui::TableNextColumn();
  draw_deviation(ui, state, view, requests);
  ImGui::EndTable();
}

Requests DiffPanel::draw(Ui& ui, const WorkbenchState& state) {
  Requests requests;
  if (draw_no_project(ui, state, requests)) return requests;
  if (state.live) {
    empty_state(ui, icon::kRecord, "Recording", "There is something to compare when it ends", {});
    return requests;
  }
  const auto shown = selected_demonstration(state);
  if (shown == nullptr || shown->gated().empty()) {
    empty_state(ui, icon::kBranch, "Nothing to compare", "Select a demonstration in the library, or record one", {});
    return requests;
  }
  time_->follow(state.demonstration.value, shown->full_duration_s());
  draw_choice(ui, state, state.comparing.value_or(ComparisonSettings{}), requests);
  const ComparisonView* view = state.comparison.get();
  const bool of_it = view != nullptr && view->of.after != nullptr && view->of.after->id == shown->id;
  if (!of_it) {
    empty_state(ui, icon::kClock, "", "Comparing", {});
    return requests;
  }
  if (!view->comparison) {
    wrapped_text(ui, view->error, ui.theme().danger);
    return requests;
  }
  if (state.comparing && state.comparing->in_view && view->comparison->both.max_m > workbench::kLeastWhisker_m) {
    draw_whisker_key(ui, view->comparison->both.max_m);
  }
  draw_result(ui, state, *view, requests);
  return requests;
}

}  // namespace trocar::ui
