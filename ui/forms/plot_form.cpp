#include "ui/forms/plot_form.h"

#include <fmt/format.h>

#include <array>
#include <filesystem>

#include "engine/figure/field_figure.h"
#include "engine/workbench/jobs/plot_job.h"
#include "ui/command_text.h"
#include "ui/icons.h"
#include "ui/panels/rollout_parts.h"

namespace trocar::ui {
namespace {

using learning::RolloutMeasure;
using workbench::PlotKind;

constexpr std::array<std::string_view, 4> kPlotEndings{".png", ".svg", ".pdf", ".csv"};
constexpr int kDrawnPlots = 3;

/// The ending that suits the kind: of a report its own, and back to a picture from there.
std::string with_ending_of(PlotKind kind, std::filesystem::path path) {
  const bool page = path.extension() == ".html";
  if (kind == PlotKind::kReport) return path.replace_extension(".html").string();
  return page ? path.replace_extension(".png").string() : path.string();
}

const std::vector<std::string>& plot_names() {
  static const std::vector<std::string> kNames{"Arrived by step",   "Deviation from the expert",
                                               "Boxes of measures", "All measures",
                                               "Small pictures",    "Success map",
                                               "Learning curve",    "Report, one page"};
  return kNames;
}

bool has_curve(const std::shared_ptr<const workbench::ModelEntry>& entry) {
  return entry != nullptr && entry->model != nullptr && entry->model->curve.size() > 1;
}

std::shared_ptr<const workbench::ModelEntry> entry_of(const WorkbenchState& state, workbench::ModelId id) {
  if (state.project == nullptr) return nullptr;
  const auto found = state.project->models.find(id);
  return found == state.project->models.end() ? nullptr : found->second;
}

/// "A exact and A eg-maxent, from around:3"
std::string subject_words(const WorkbenchState& state, PlotKind kind) {
  const auto first = entry_of(state, state.model);
  if (first == nullptr) return "No model is selected";
  std::string words = first->name;
  const bool curve = kind == PlotKind::kCurve;
  const auto second =
      curve || (state.insight && state.insight->second) ? entry_of(state, state.learning.second) : nullptr;
  if (second != nullptr) words += " and " + second->name;
  if (curve || kind == PlotKind::kMap) return words;
  return words + ", from " + state.rollouts.starts;
}

}  // namespace

void PlotForm::prepare(const WorkbenchState& state) {
  path_ = with_ending_of(settings_.kind,
                         beside_project(state, fmt::format("-{}.png", workbench::to_string(settings_.kind))));
  one_slice_ = !settings_.slice.empty();
  slice_ = one_slice_ ? settings_.slice : "z=11";
  brushed_ = true;
}

void PlotForm::draw_kind(Ui& ui, const WorkbenchState& state) {
  static const std::vector<std::string> kFiles{"PNG", "SVG", "PDF", "CSV"};
  int kind = static_cast<int>(settings_.kind);
  form_label(ui, "Figure");
  if (combo(ui, "Figure", kind, plot_names(),
            {.help = "Of the selected model, and of the second one if there is one"})) {
    settings_.kind = static_cast<PlotKind>(kind);
    path_ = beside_project(state, fmt::format("-{}{}", workbench::to_string(settings_.kind),
                                              std::filesystem::path(path_).extension().string()));
    path_ = with_ending_of(settings_.kind, path_);
  }
  wrapped_text(ui, subject_words(state, settings_.kind), ui.theme().text_dim);
  if (settings_.kind == PlotKind::kReport) {
    wrapped_text(ui, "One page of HTML: outcomes, measures, figures and whose they are", ui.theme().text_dim);
    return;
  }
  int file = place_of_ending(path_, kPlotEndings);
  form_label(ui, "Kind of file");
  if (segmented(ui, "Kind of file", file, kFiles, {.help = "Drawn; or the numbers of a curve, of boxes or of a map"})) {
    path_ = std::filesystem::path(path_).replace_extension(kPlotEndings[static_cast<std::size_t>(file)]).string();
  }
}

void PlotForm::draw_details(Ui& ui) {
  if (settings_.kind == PlotKind::kBoxes) {
    static const std::vector<RolloutMeasure> kBoxed = learning::spread_measures();
    std::vector<std::string> names{"All"};
    int chosen = 0;
    for (std::size_t i = 0; i < kBoxed.size(); ++i) {
      names.emplace_back(learning::words_of(kBoxed[i]).title);
      if (settings_.measures.size() == 1 && settings_.measures[0] == kBoxed[i]) chosen = static_cast<int>(i) + 1;
    }
    form_label(ui, "Measure");
    if (combo(ui, "Measure", chosen, names, {.help = "One, or all that have more and less"})) {
      settings_.measures.clear();
      if (chosen > 0) settings_.measures = {kBoxed[static_cast<std::size_t>(chosen - 1)]};
    }
  }
  if (settings_.kind == PlotKind::kMultiples) {
    int by = static_cast<int>(settings_.by);
    form_label(ui, "Sorted by");
    if (combo(ui, "Sorted by", by, measure_names(), {.help = "The first 24 in this order are drawn"})) {
      settings_.by = static_cast<RolloutMeasure>(by);
    }
    form_label(ui, "Order");
    checkbox(ui, "Largest first", settings_.descending, {.help = "Else the smallest"});
    form_label(ui, "Columns");
    slider_int(ui, "Columns", settings_.columns, 2, 8, "%d side by side",
               {.help = "Fewer where they would be too small"});
  }
  const bool sifted = settings_.kind == PlotKind::kAxes || settings_.kind == PlotKind::kMultiples;
  if (sifted && !settings_.kept.empty()) {
    form_label(ui, "Brushed");
    checkbox(ui, "Only what is brushed", brushed_,
             {.help = "Rollouts outside of the brushed ranges are grey on axes, and no small pictures"});
  }
  if (settings_.kind == PlotKind::kMap) {
    static const std::vector<std::string> kWhat{"All slices", "One slice"};
    int what = one_slice_ ? 1 : 0;
    form_label(ui, "What");
    segmented(ui, "What", what, kWhat, {});
    one_slice_ = what == 1;
    form_label(ui, "Slice");
    text_field(ui, "Slice", slice_, "z=11",
               {.help = "x=, y= or z= and the index of the cells",
                .reason = one_slice_ ? "" : "All slices along z are drawn"});
  }
}

std::string PlotForm::reason(const WorkbenchState& state) const {
  const auto first = entry_of(state, state.model);
  if (first == nullptr) return "No model is selected";
  if (settings_.kind == PlotKind::kCurve) {
    const auto second = entry_of(state, state.learning.second);
    if (!has_curve(first)) return first->name + " has no learning curve";
    if (second != nullptr && !has_curve(second)) return second->name + " has no learning curve";
  } else if (!state.insight || !state.insight->entry) {
    return "The rollouts are being worked out";
  } else if (state.insight->starts.empty()) {
    return "There are no starts";
  }
  if (std::string why = reason_against_path(path_, state); !why.empty()) return why;
  if (std::string why = workbench::reason_against_plot(settings_.kind, path_); !why.empty()) return why;
  if (settings_.kind == PlotKind::kMap && one_slice_) {
    const auto slice = figure::slice_from(slice_, state.insight->entry->model->grid);
    if (!slice) return slice.error().text();
  }
  return "";
}

workbench::ExportPlot PlotForm::wanted() const {
  workbench::ExportPlot plot{settings_, path_};
  const int file = place_of_ending(path_, kPlotEndings);
  const bool drawn = file >= 0 && file < kDrawnPlots;
  const bool sifted = settings_.kind == PlotKind::kAxes || settings_.kind == PlotKind::kMultiples;
  if (settings_.kind != PlotKind::kBoxes) plot.settings.measures.clear();
  if (!sifted || !brushed_) plot.settings.kept.clear();
  plot.settings.slice = settings_.kind == PlotKind::kMap && one_slice_ ? slice_ : "";
  plot.settings.preset = drawn ? paper_.preset() : "";
  plot.settings.transparent = drawn && paper_.transparent;
  if (file == 0 && paper_.paper > 0) plot.settings.dpi = static_cast<double>(paper_.dpi);
  return plot;
}

Requests PlotForm::draw_content(Ui& ui, const WorkbenchState& state) {
  draw_kind(ui, state);
  draw_details(ui);
  const int file = place_of_ending(path_, kPlotEndings);
  if (settings_.kind != PlotKind::kReport) draw_paper(ui, paper_, file >= 0 && file < kDrawnPlots, file == 0);
  form_label(ui, "File");
  text_field(ui, "File", path_, "figure.png", {.help = "Its ending says what kind it is"});
  ImGui::Dummy({0.0F, ui.px(6)});
  const workbench::Command command{wanted()};
  const std::string why = reason(state);
  Requests requests;
  if (!why.empty()) wrapped_text(ui, why, ui.theme().text_dim);
  const std::string typed = command_text(command, state);
  if (button(ui, "Copy as command", {.icon = icon::kCopy, .help = typed, .style = ButtonStyle::kQuiet})) {
    requests.emplace_back(CopyText{typed});
  }
  if (!export_button(ui, icon::kDownload, path_, why)) return requests;
  close();
  requests.emplace_back(command);
  requests.emplace_back(ShowPanel{PanelId::kJobs});
  return requests;
}

}  // namespace trocar::ui
