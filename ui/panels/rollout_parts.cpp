#include "ui/panels/rollout_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/figure/outcome_colours.h"
#include "engine/learning/rollout_table.h"
#include "ui/format.h"
#include "ui/icons.h"

namespace trocar::ui {

using learning::RolloutEnd;
using workbench::JobState;

const char* end_sign(RolloutEnd end) {
  switch (end) {
    case RolloutEnd::kArrives:
      return icon::kVerify;
    case RolloutEnd::kLoops:
      return icon::kRefresh;
    case RolloutEnd::kDeadEnd:
      return icon::kCross;
    case RolloutEnd::kOutsideSafeSet:
      break;
  }
  return icon::kEject;
}

void end_text(Ui& ui, RolloutEnd end) {
  ImGui::BeginGroup();
  {
    const ColourScope tint(ImGuiCol_Text, figure::outcome_colour(end));
    ImGui::TextUnformatted(end_sign(end));
  }
  ImGui::SameLine(0.0F, ui.px(6));
  const std::string_view words = figure::outcome_word(end);
  ImGui::TextUnformatted(words.data(), words.data() + words.size());
  ImGui::EndGroup();
}

std::string start_words(const spatial::Grid& grid, spatial::CellIndex cell) {
  const spatial::CellCoordinates c = grid.coordinates(cell);
  return fmt::format("{}, {}, {}", c.x, c.y, c.z);
}

void outcome_row(Ui& ui, const char* sign, std::string_view name, std::int64_t part, std::int64_t whole, Rgba colour) {
  const float left = ImGui::GetCursorPosX();
  const float width = ImGui::GetContentRegionAvail().x;
  const std::string words = percent(part, whole) + "  (" + count(part) + ")";
  {
    const ColourScope tint(ImGuiCol_Text, colour);
    ImGui::TextUnformatted(sign);
  }
  ImGui::SameLine(left + ui.px(24));
  ImGui::TextUnformatted(name.data(), name.data() + name.size());
  const float numbers = ImGui::CalcTextSize(words.c_str()).x;
  const float bar = left + ui.px(116);
  const float bar_width = width - ui.px(116) - std::max(numbers, ui.px(104)) - ui.px(10);
  if (bar_width > ui.px(30)) {
    ImGui::SameLine(bar);
    const float lower = 0.5F * (ImGui::GetTextLineHeight() - ui.px(8));
    ImGui::SetCursorPosY(ImGui::GetCursorPosY() + lower);
    share_bar(ui, whole > 0 ? static_cast<double>(part) / static_cast<double>(whole) : 0.0, colour,
              {bar_width, ui.px(8)});
    ImGui::SameLine(left + width - numbers);
    ImGui::SetCursorPosY(ImGui::GetCursorPosY() - lower);
  } else {
    const float used = ImGui::GetItemRectMax().x - ImGui::GetWindowPos().x + ui.px(8);
    if (used + numbers <= left + width) ImGui::SameLine(left + width - numbers);
  }
  ImGui::TextUnformatted(words.c_str());
  note_item(ui, "text", name, words, {});
}

void summary_block(Ui& ui, std::string_view name, const learning::RolloutSummary& summary) {
  const Scope scope(ui, name);
  heading(ui, name);
  ImGui::SameLine();
  dim_text(ui, count(summary.count) + " starts");
  const auto row = [&](std::string_view words, RolloutEnd end, int part) {
    outcome_row(ui, end_sign(end), words, part, summary.count, figure::outcome_colour(end));
  };
  row("Arrives", RolloutEnd::kArrives, summary.arrived);
  row("Loops", RolloutEnd::kLoops, summary.looped);
  row("Dead end", RolloutEnd::kDeadEnd, summary.dead_end);
  row("Outside", RolloutEnd::kOutsideSafeSet, summary.outside);
  outcome_row(ui, icon::kDownload, "From above", summary.from_above, summary.arrived, ui.theme().accent);
}

void choose_starts(const WorkbenchState& state, std::string starts, Requests& requests) {
  workbench::RolloutSettings settings = state.rollouts;
  settings.starts = std::move(starts);
  if (settings != state.rollouts) requests.emplace_back(workbench::Command{workbench::SetRollouts{settings}});
}

void select_start(const WorkbenchState& state, std::optional<spatial::CellIndex> start, Requests& requests) {
  workbench::RolloutSettings settings = state.rollouts;
  settings.selected = start;
  if (settings != state.rollouts) requests.emplace_back(workbench::Command{workbench::SetRollouts{settings}});
}

const workbench::JobView* job_under_way(const WorkbenchState& state, std::string_view title) {
  const auto found = std::find_if(state.jobs.begin(), state.jobs.end(), [title](const workbench::JobView& job) {
    return job.title.starts_with(title) && (job.state == JobState::kQueued || job.state == JobState::kRunning);
  });
  return found == state.jobs.end() ? nullptr : &*found;
}

void draw_job_under_way(Ui& ui, const workbench::JobView& job, std::string_view help, Requests& requests) {
  const float width = ImGui::GetContentRegionAvail().x;
  progress_bar(ui, "Progress", job.fraction, width);
  if (button(ui, "Stop", {.icon = icon::kStop, .help = help})) {
    requests.emplace_back(workbench::Command{workbench::CancelJob{job.id}});
  }
  ImGui::SameLine();
  dim_text(ui, fmt::format("{} %", static_cast<int>(100.0 * job.fraction)));
  ui.animate();
}

void export_plot_button(Ui& ui, std::string_view label, const workbench::PlotSettings& plot, Requests& requests) {
  if (button(
          ui, label,
          {.icon = icon::kDownload, .help = "As PNG, SVG or PDF, for screen or paper", .style = ButtonStyle::kQuiet})) {
    requests.emplace_back(ShowPlotForm{plot});
  }
}

bool chart_area(Ui& ui, std::string_view label, ImVec2 size, std::string_view value, const WidgetOptions& options) {
  ImGui::InvisibleButton(std::string(label).c_str(), {std::max(size.x, 1.0F), std::max(size.y, 1.0F)});
  const bool hovered = ImGui::IsItemHovered();
  if (hovered && !options.help.empty()) ui.set_hint(options.help);
  note_rect(ui, "canvas", label, value, item_rect(), options);
  return hovered;
}

const std::vector<std::string>& measure_names() {
  static const std::vector<std::string> kNames = [] {
    std::vector<std::string> names;
    for (int i = 0; i < learning::kRolloutMeasures; ++i) {
      names.emplace_back(learning::words_of(static_cast<learning::RolloutMeasure>(i)).name);
    }
    return names;
  }();
  return kNames;
}

std::string measure_words(learning::RolloutMeasure measure, double value) {
  using learning::RolloutMeasure;
  if (!std::isfinite(value)) return "unknown";
  const auto whole = static_cast<int>(std::lround(value));
  switch (measure) {
    case RolloutMeasure::kStart:
    case RolloutMeasure::kSteps:
    case RolloutMeasure::kOutside:
      return count(whole);
    case RolloutMeasure::kEnd:
      return std::string(learning::to_string(static_cast<RolloutEnd>(std::clamp(whole, 0, 3))));
    case RolloutMeasure::kLength:
    case RolloutMeasure::kMaxDeviation:
    case RolloutMeasure::kMeanDeviation:
    case RolloutMeasure::kFrechet:
    case RolloutMeasure::kHausdorff:
    case RolloutMeasure::kWarped:
    case RolloutMeasure::kClearance:
      return millimetres(value);
    case RolloutMeasure::kLastMoves:
      return fmt::format("{} of 3 down", whole);
    case RolloutMeasure::kFromAbove:
      return whole == 1 ? "yes" : "no";
    case RolloutMeasure::kDivergence:
      return whole < 0 ? "never" : fmt::format("step {}", whole);
    case RolloutMeasure::kStraightness:
    case RolloutMeasure::kReward:
      break;
  }
  return number(value);
}

}  // namespace trocar::ui
