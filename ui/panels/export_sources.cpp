#include "ui/panels/export_sources.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "engine/demonstration/curves.h"
#include "engine/film/composition_words.h"
#include "engine/learning/field.h"
#include "ui/format.h"
#include "ui/icons.h"
#include "ui/panels/common.h"
#include "ui/panels/export_keys.h"

namespace trocar::ui {
namespace {

using film::Source;
using film::SourceKind;
using workbench::FilmDraft;

/// What a source of that kind can be of: ids and, in the same order, names that differ.
struct Subjects {
  std::vector<std::string> ids;
  std::vector<std::string> names;
};

Subjects subjects_of(const workbench::Project& project, SourceKind kind) {
  Subjects subjects;
  UniqueNames unique;
  const auto add = [&](const auto& map) {
    for (const auto& [id, entry] : map) {
      subjects.ids.push_back(fmt::format("{}", id.value));
      subjects.names.push_back(unique(entry->name));
    }
  };
  if (kind == SourceKind::kField) {
    add(project.models);
  } else {
    add(project.demonstrations);
    add(project.trials);
  }
  return subjects;
}

/// The name of what the source is of; what it says itself, if that is no id of the project.
std::string name_of_source(const workbench::Project& project, const Source& source) {
  if (!source.title.empty()) return source.title;
  const Subjects subjects = subjects_of(project, source.kind);
  const auto found = std::find(subjects.ids.begin(), subjects.ids.end(), source.of);
  return found == subjects.ids.end() ? source.of
                                     : subjects.names[static_cast<std::size_t>(found - subjects.ids.begin())];
}

std::string value_of_source(const Source& source) {
  if (source.kind == SourceKind::kField) return fmt::format("field, {}, {}", source.layer, source.slice);
  if (source.kind == SourceKind::kCurve) return "curve, " + source.curve;
  return fmt::format("camera {}", film::word_of(film::kViews, source.camera.view));
}

void draw_added(Ui& ui, const WorkbenchState& state, FilmDraft& draft, AddedSource& added) {
  static const std::vector<std::string> kKinds{"Recording", "Field", "Curve"};
  const Scope scope(ui, "Add");
  form_label(ui, "Kind");
  segmented(ui, "Kind", added.kind, kKinds,
            {.help = "A demonstration or trial by a camera, a slice of a model's field, or a curve over time"});
  const auto kind = static_cast<SourceKind>(added.kind);
  Subjects subjects = subjects_of(*state.project, kind);
  const std::string none = !subjects.ids.empty()        ? ""
                           : kind == SourceKind::kField ? "There is no model yet"
                                                        : "There is no demonstration yet";
  if (subjects.ids.empty()) subjects.names.emplace_back("–");
  if (added.of >= static_cast<int>(subjects.names.size())) added.of = 0;
  form_label(ui, "Of");
  combo(ui, "Of", added.of, subjects.names, {.help = "Demonstrations and trials, or models", .reason = none});
  const std::string full = draft.film.sources.size() >= 9 ? "A film has room for nine" : none;
  if (!button(ui, "Add source", {.icon = icon::kPlus, .help = "The layout makes room for it", .reason = full})) return;
  Source source = film::recording_of(subjects.ids[static_cast<std::size_t>(added.of)]);
  source.kind = kind;
  draft = workbench::with_source(std::move(draft), std::move(source));
  if (draft.film.path.empty()) draft.film.path = (state.path.parent_path() / "film.mp4").string();
}

/// The name at the left, the value dim in the right half.
void write_row(Ui& ui, const Rect& row, const std::string& name, const std::string& value) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float y = std::round(row.y0 + 0.5F * (row.height() - ImGui::GetFontSize()));
  const float half = row.x0 + 0.5F * row.width();
  const float edge = ui.px(8);
  list.AddText({row.x0 + edge, y}, to_u32(ui.theme().text), fitted(name, half - row.x0 - 2.0F * edge).c_str());
  list.AddText({half, y}, to_u32(ui.theme().text_dim), fitted(value, row.x1 - half - edge).c_str());
}

void draw_list(Ui& ui, const WorkbenchState& state, FilmDraft& draft) {
  const Scope scope(ui, "List");
  UniqueNames unique;
  for (std::size_t i = 0; i < draft.film.sources.size(); ++i) {
    const Source& source = draft.film.sources[i];
    ImGui::PushID(static_cast<int>(i));
    const std::string value = value_of_source(source);
    const std::string name = unique(name_of_source(*state.project, source));
    if (selectable_row(ui, name, i == draft.source, value,
                       {.help = "Choose it, to say how it is shown", .height = ImGui::GetFrameHeight()})) {
      draft.source = i;
    }
    write_row(ui, item_rect(), name, value);
    ImGui::PopID();
  }
}

void draw_field_source(Ui& ui, Source& source) {
  static const std::vector<std::string> kLayers = [] {
    std::vector<std::string> names;
    for (const learning::Layer layer : learning::all_layers()) names.emplace_back(learning::to_string(layer));
    return names;
  }();
  const auto found = std::find(kLayers.begin(), kLayers.end(), source.layer);
  int layer = found == kLayers.end() ? -1 : static_cast<int>(found - kLayers.begin());
  form_label(ui, "Layer");
  if (combo(ui, "Layer", layer, kLayers, {.help = "What of the model is shown"})) {
    source.layer = kLayers[static_cast<std::size_t>(layer)];
  }
  form_label(ui, "Slice");
  text_field(ui, "Slice", source.slice, "z=11", {.help = "x=, y= or z= and the index of the cells"});
}

void draw_curve_source(Ui& ui, Source& source) {
  static const std::vector<std::string> kCurves = [] {
    std::vector<std::string> names;
    for (const demonstration::CurveKind kind : demonstration::kCurveKinds) {
      // It is one of geometry: no film shows it.
      if (kind != demonstration::CurveKind::kClearance) names.emplace_back(demonstration::to_string(kind));
    }
    return names;
  }();
  const auto found = std::find(kCurves.begin(), kCurves.end(), source.curve);
  int curve = found == kCurves.end() ? -1 : static_cast<int>(found - kCurves.begin());
  form_label(ui, "Curve");
  if (combo(ui, "Curve", curve, kCurves, {.help = "Of both tools, with the instant marked"})) {
    source.curve = kCurves[static_cast<std::size_t>(curve)];
  }
}

}  // namespace

void draw_film_sources(Ui& ui, const WorkbenchState& state, FilmDraft& draft, AddedSource& added, Requests& requests) {
  const Scope scope(ui, "Sources");
  draw_list(ui, state, draft);
  if (draft.source < draft.film.sources.size()) {
    Source& source = draft.film.sources[draft.source];
    const Scope chosen(ui, "Chosen");
    form_label(ui, "Title");
    text_field(ui, "Title", source.title, "Its name", {.help = "What the film calls it"});
    if (source.kind == SourceKind::kField) draw_field_source(ui, source);
    if (source.kind == SourceKind::kCurve) draw_curve_source(ui, source);
    if (source.kind == SourceKind::kRecording) draw_film_camera(ui, state, draft, requests);
    if (button(ui, "Remove source", {.icon = icon::kTrash, .help = "The film is made without it"})) {
      draft = workbench::without_source(std::move(draft));
    }
  }
  heading(ui, "Another source");
  draw_added(ui, state, draft, added);
}

}  // namespace trocar::ui
