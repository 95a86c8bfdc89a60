#include "ui/panels/curves_panel.h"

#include <algorithm>
#include <string>

#include "ui/format.h"
#include "ui/icons.h"
#include "ui/panels/common.h"
#include "ui/panels/timed_plot.h"

namespace trocar::ui {
namespace {

using demonstration::Demonstration;
using demonstration::Problem;
using demonstration::ProblemKind;
using workbench::CurveKind;
using workbench::CurveSet;
using workbench::ShownCurve;

/// Whether a problem is of what a curve shows.
bool concerns(const Problem& problem, CurveKind kind) {
  switch (problem.kind) {
    case ProblemKind::kNotFinite:
    case ProblemKind::kTime:
      return true;
    case ProblemKind::kCollision:
    case ProblemKind::kClearance:
      return kind == CurveKind::kClearance || kind == CurveKind::kX || kind == CurveKind::kY || kind == CurveKind::kZ;
    case ProblemKind::kLattice:
    case ProblemKind::kWorkspace:
    case ProblemKind::kJoint:
    case ProblemKind::kSafeSet:
    case ProblemKind::kEnds:
      return kind == CurveKind::kX || kind == CurveKind::kY || kind == CurveKind::kZ;
    case ProblemKind::kSpeed:
      return kind == CurveKind::kSpeed;
    case ProblemKind::kAcceleration:
      return kind == CurveKind::kAcceleration;
    case ProblemKind::kJerk:
      return kind == CurveKind::kJerk;
    case ProblemKind::kJaw:
      return kind == CurveKind::kJaw;
    case ProblemKind::kQuaternion:
    case ProblemKind::kSegments:
    case ProblemKind::kIdle:
      return false;
  }
  return false;
}

/// Those of the true geometry where they are worked out, else those that the samples alone tell.
const std::vector<Problem>& problems_of(const WorkbenchState& state, const CurveSet& set) {
  for (const auto& review : {state.preview_review, state.review}) {
    if (review && review->of.document == set.of.shown) return review->review.problems;
  }
  return set.problems;
}

std::vector<PlotSpan> spans_of(const Theme& theme, const std::vector<Problem>& problems, CurveKind kind) {
  std::vector<PlotSpan> spans;
  for (const Problem& problem : problems) {
    if (!concerns(problem, kind)) continue;
    const bool error = problem.severity == demonstration::Severity::kError;
    const bool warning = problem.severity == demonstration::Severity::kWarning;
    const Rgba colour = error ? theme.danger : warning ? theme.warning : theme.text_dim;
    spans.push_back({problem.begin_s, problem.end_s, colour, problem.message});
  }
  return spans;
}

std::vector<PlotLine> lines_of(const Theme& theme, const CurveSet& set, CurveKind kind, bool before) {
  std::vector<PlotLine> lines;
  for (int arm = 0; arm < 2; ++arm) {
    const ShownCurve* curve = set.find(kind, arm);
    if (curve == nullptr) continue;
    const LineStyle style = arm == 0 ? LineStyle::kSolid : LineStyle::kDashed;
    lines.push_back({std::string(workbench::arm_title(arm)), curve->now.get(), arm_colour(theme, arm), style});
  }
  for (int arm = 0; arm < 2 && before; ++arm) {
    const ShownCurve* curve = set.find(kind, arm);
    if (curve == nullptr || curve->before == nullptr) continue;
    const std::string name = std::string(workbench::arm_title(arm)) + " before";
    lines.push_back({name, curve->before.get(), theme.text_disabled, LineStyle::kGhost});
  }
  return lines;
}

/// Of what is seen between the gates, or of all that is seen where that is outside of them.
plot::Extent extent_of(const std::vector<PlotLine>& lines, const TimeRange& range, const Demonstration& shown) {
  const double begin_s = std::max(range.begin_s, shown.begin_s);
  const double end_s = std::min(range.end_s, shown.end_s);
  std::optional<plot::Extent> all;
  for (const PlotLine& line : lines) {
    std::optional<plot::Extent> one = line.curve->extent(begin_s, end_s);
    if (!one) one = line.curve->extent(range.begin_s, range.end_s);
    if (!one) continue;
    all = all ? plot::Extent{std::min(all->low, one->low), std::max(all->high, one->high)} : *one;
  }
  return all.value_or(plot::Extent{0.0, 1.0});
}

bool is_of(const CurveSet* set, const Demonstration& shown) {
  return set != nullptr && set->of.shown->id == shown.id;
}

}  // namespace

void CurvesPanel::draw_choice(Ui& ui, const WorkbenchState& state, const Demonstration& shown) {
  const Scope scope(ui, "Show");
  const float gap = ui.px(4);
  const auto choose = [&](std::string_view label, bool on, const WidgetOptions& options) {
    flow(std::max(button_width(ui, label, options.icon), ui.px(30)), gap);
    WidgetOptions wide = options;
    wide.width = std::max(button_width(ui, label, options.icon), ui.px(30));
    return toggle(ui, label, on, wide);
  };
  ImGui::Dummy({0.0F, 0.0F});
  for (const CurveKind kind : demonstration::kCurveKinds) {
    const workbench::CurveLook& look = workbench::look_of(kind);
    const bool on = (kinds_ & workbench::bit(kind)) != 0;
    const std::string help =
        "Show " + std::string(demonstration::to_string(kind)) + " of both tools, in " + std::string(look.unit);
    if (choose(look.title, on, {.help = help})) kinds_ ^= workbench::bit(kind);
  }
  const bool changed = state.preview != nullptr || !shown.samples.same_pieces(shown.recorded);
  if (choose("Before", before_ && changed,
             {.icon = icon::kHistory,
              .help = "Show what was before: as it was recorded, or without the edit that is being made",
              .reason = changed ? "" : "It is as it was recorded"})) {
    before_ = !before_;
  }
  flow(ImGui::GetFrameHeight() + ui.px(4), gap);
  if (icon_button(ui, "Fit",
                  {.icon = icon::kExpand, .help = "Show the whole demonstration", .style = ButtonStyle::kQuiet})) {
    time_->show(shown.begin_s, shown.end_s);
  }
}

void CurvesPanel::draw_plot(Ui& ui, const WorkbenchState& state, const Demonstration& shown, CurveKind kind,
                            float height, bool time_axis, Requests& requests) {
  const workbench::CurveLook& look = workbench::look_of(kind);
  const std::vector<PlotLine> lines = lines_of(ui.theme(), *state.curves, kind, before_);
  const std::vector<PlotSpan> spans = spans_of(ui.theme(), problems_of(state, *state.curves), kind);
  const std::vector<plot::Band> limits = workbench::limits_of(kind);
  PlotSpec spec = timed_plot(*time_, shown, state.playhead_s, cursor_s_);
  spec.label = look.title;
  spec.unit = look.unit;
  spec.lines = lines;
  spec.limits = limits;
  spec.spans = spans;
  spec.values = plot::value_range(extent_of(lines, time_->range, shown), look.from_zero, limits);
  spec.time_axis = time_axis;
  spec.height = height;
  const PlotActs acts = plot(ui, spec);
  if (acts.cursor_s) next_cursor_s_ = acts.cursor_s;
  follow_plot(acts, length_of(shown), *time_, requests);
}

void CurvesPanel::draw_plots(Ui& ui, const WorkbenchState& state, const Demonstration& shown, Requests& requests) {
  std::vector<CurveKind> kinds;
  for (const CurveKind kind : demonstration::kCurveKinds) {
    if ((kinds_ & workbench::bit(kind)) != 0) kinds.push_back(kind);
  }
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0.0F, ui.px(4)});
  const float gaps = ui.px(4) * static_cast<float>(kinds.size() - 1);
  const float room = ImGui::GetContentRegionAvail().y - gaps;
  const float times = least_plot_height(ui, true) - least_plot_height(ui, false);
  const float least = least_plot_height(ui, false);
  // Where they do not fit, the panel scrolls, and each has its own times.
  const bool fits = least * static_cast<float>(kinds.size()) + times <= room;
  const float each = std::floor((room - times) / static_cast<float>(kinds.size()));
  next_cursor_s_.reset();
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    const bool time_axis = !fits || i + 1 == kinds.size();
    const float height = (fits ? each : least) + (time_axis ? times : 0.0F);
    draw_plot(ui, state, shown, kinds[i], height, time_axis, requests);
  }
  ImGui::PopStyleVar();
  cursor_s_ = next_cursor_s_;
}

Requests CurvesPanel::draw(Ui& ui, const WorkbenchState& state) {
  Requests requests;
  if (draw_no_project(ui, state, requests)) return requests;
  if (state.live) {
    empty_state(ui, icon::kRecord, "Recording", "Its curves appear here when it ends", {});
    return requests;
  }
  auto shown = selected_demonstration(state);
  if (shown == nullptr || shown->gated().empty()) {
    empty_state(ui, icon::kChart, "No curves to show", "Select a demonstration in the library, or record one", {});
    return requests;
  }
  if (state.preview && state.preview->after) shown = state.preview->after;
  time_->follow(state.demonstration.value, length_of(*shown));
  draw_choice(ui, state, *shown);
  time_->want_curves(kinds_);
  if (kinds_ == 0) {
    empty_state(ui, icon::kChart, "", "Choose a curve above", {});
  } else if (!is_of(state.curves.get(), *shown)) {
    empty_state(ui, icon::kClock, "", "Working out the curves", {});
  } else {
    draw_plots(ui, state, *shown, requests);
  }
  return requests;
}

}  // namespace trocar::ui
