#include "ui/panels/export_sources.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/demonstration/curves.h"
#include "engine/film/composition_words.h"
#include "engine/learning/field.h"
#include "engine/spatial/cell_text.h"
#include "ui/format.h"
#include "ui/icons.h"
#include "ui/panels/common.h"
#include "ui/panels/export_keys.h"

namespace trocar::ui {
namespace {

using film::Source;
using film::SourceKind;
using workbench::FilmDraft;

constexpr double kShortestGate_s = 0.1;  ///< What is left between both.

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
  if (kind == SourceKind::kField || kind == SourceKind::kRollout) {
    add(project.models);
  } else {
    add(project.demonstrations);
    add(project.trials);
  }
  return subjects;
}

std::string value_of_source(const Source& source) {
  if (source.kind == SourceKind::kField) return fmt::format("field, {}, {}", source.layer, source.slice);
  if (source.kind == SourceKind::kCurve) return "curve, " + source.curve;
  if (source.kind == SourceKind::kRollout) {
    return source.start ? fmt::format("rollout from {}", fmt::join(*source.start, ",")) : "rollout";
  }
  return fmt::format("camera {}", film::word_of(film::kViews, source.camera.view));
}

void draw_added(Ui& ui, const WorkbenchState& state, FilmDraft& draft, AddedSource& added) {
  static const std::vector<std::string> kKinds{"Recording", "Field", "Curve", "Rollout"};
  const Scope scope(ui, "Add");
  form_label(ui, "Kind");
  segmented(ui, "Kind", added.kind, kKinds,
            {.help = "A demonstration or trial by a camera, a slice of a model's field, a curve over time, or what a "
                     "model does in the simulator"});
  const auto kind = static_cast<SourceKind>(added.kind);
  Subjects subjects = subjects_of(*state.project, kind);
  const std::string none = !subjects.ids.empty() ? ""
                           : kind == SourceKind::kField || kind == SourceKind::kRollout
                               ? "There is no model yet"
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

void draw_layer(Ui& ui, std::string& said) {
  static const std::vector<std::string> kLayers = [] {
    std::vector<std::string> names;
    for (const learning::Layer layer : learning::all_layers()) names.emplace_back(learning::to_string(layer));
    return names;
  }();
  const auto found = std::find(kLayers.begin(), kLayers.end(), said);
  int layer = found == kLayers.end() ? -1 : static_cast<int>(found - kLayers.begin());
  form_label(ui, "Layer");
  if (combo(ui, "Layer", layer, kLayers, {.help = "What of the model is shown"})) {
    said = kLayers[static_cast<std::size_t>(layer)];
  }
}

void draw_slice(Ui& ui, std::string& said) {
  form_label(ui, "Slice");
  text_field(ui, "Slice", said, "z=11", {.help = "x=, y= or z= and the index of the cells; its keys move it"});
}

/// A slice of a model's field within the scene.
void draw_scene_field(Ui& ui, const workbench::Project& project, Source& source) {
  const Subjects subjects = subjects_of(project, SourceKind::kField);
  std::vector<std::string> names{"None"};
  names.insert(names.end(), subjects.names.begin(), subjects.names.end());
  int chosen = 0;
  if (source.field) {
    const auto found = std::find(subjects.ids.begin(), subjects.ids.end(), source.field->of);
    // One by name, or one that there is no more.
    chosen = found == subjects.ids.end() ? -1 : static_cast<int>(found - subjects.ids.begin()) + 1;
  }
  form_label(ui, "Field");
  if (combo(ui, "Field", chosen, names,
            {.help = "A slice of a model's field in the scene",
             .reason = subjects.ids.empty() ? "There is no model yet" : ""})) {
    if (chosen == 0) {
      source.field.reset();
    } else {
      if (!source.field) source.field.emplace();
      source.field->of = subjects.ids[static_cast<std::size_t>(chosen) - 1];
    }
  }
  if (!source.field) return;
  draw_layer(ui, source.field->layer);
  draw_slice(ui, source.field->slice);
}

void draw_rollout_source(Ui& ui, Source& source) {
  std::string start = source.start ? fmt::format("{}", fmt::join(*source.start, ",")) : "";
  form_label(ui, "Start");
  if (!text_field(ui, "Start", start, "I,J,K: the expert's",
                  {.help = "The cell in which it begins; nothing: where the model's first expert began"})) {
    return;
  }
  if (start.empty()) source.start.reset();
  if (const auto cell = spatial::coordinates_from(start)) source.start = {cell->x, cell->y, cell->z};
}

/// What can be moved within what, and why it cannot.
struct GateRoom {
  double begin_s = 0.0;
  double end_s = 1.0;
  std::string_view reason;
};

GateRoom gate_room(const WorkbenchState& state, const FilmDraft& draft) {
  const auto& preview = state.film_preview;
  if (!preview || preview->spans_s.size() != draft.film.sources.size()) {
    return {.reason = "How long it is shows with the picture"};
  }
  const auto [begin_s, end_s] = preview->spans_s[draft.source];
  if (end_s - begin_s <= kShortestGate_s) return {.reason = "There is nothing to be cut off"};
  return {begin_s, end_s, ""};
}

/// From when to when of its own time. They keep their place while the picture is on its way.
void draw_gates(Ui& ui, const WorkbenchState& state, FilmDraft& draft) {
  Source& source = draft.film.sources[draft.source];
  if (source.kind == SourceKind::kField) return;
  const GateRoom room = gate_room(state, draft);
  const auto slider = [&](std::string_view shown, std::optional<double>& gate, double low, double high, double usual,
                          std::string_view help) {
    // Gates of a job may leave no room between them, or lie where there is nothing.
    const std::string_view reason =
        room.reason.empty() && !(low < high) ? "The other gate leaves it no room" : room.reason;
    if (!reason.empty()) high = low + 1.0;
    auto value = static_cast<float>(std::clamp(gate.value_or(usual), low, high));
    form_label(ui, shown);
    if (!slider_float(ui, shown, value, static_cast<float>(low), static_cast<float>(high),
                      room.reason.empty() ? "%.2f s" : "–", {.help = help, .reason = reason})) {
      return;
    }
    const double wanted = std::clamp(static_cast<double>(value), low, high);
    gate = std::abs(wanted - usual) < 0.005 ? std::nullopt : std::optional<double>(wanted);
  };
  slider("From", source.in_s, room.begin_s, source.out_s.value_or(room.end_s) - kShortestGate_s, room.begin_s,
         "Of its own time: where the film of it begins");
  slider("To", source.out_s, source.in_s.value_or(room.begin_s) + kShortestGate_s, room.end_s, room.end_s,
         "Of its own time: where the film of it ends");
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

std::string name_of_source(const workbench::Project& project, const Source& source) {
  if (!source.title.empty()) return source.title;
  const Subjects subjects = subjects_of(project, source.kind);
  const auto found = std::find(subjects.ids.begin(), subjects.ids.end(), source.of);
  return found == subjects.ids.end() ? source.of
                                     : subjects.names[static_cast<std::size_t>(found - subjects.ids.begin())];
}

void draw_film_sources(Ui& ui, const WorkbenchState& state, FilmDraft& draft, AddedSource& added, Requests& requests) {
  const Scope scope(ui, "Sources");
  draw_list(ui, state, draft);
  if (draft.source < draft.film.sources.size()) {
    Source& source = draft.film.sources[draft.source];
    const Scope chosen(ui, "Chosen");
    form_label(ui, "Title");
    text_field(ui, "Title", source.title, "Its name", {.help = "What the film calls it"});
    if (source.kind == SourceKind::kField) {
      draw_layer(ui, source.layer);
      draw_slice(ui, source.slice);
    }
    if (source.kind == SourceKind::kCurve) draw_curve_source(ui, source);
    if (source.kind == SourceKind::kRollout) draw_rollout_source(ui, source);
    draw_gates(ui, state, draft);
    if (source.kind == SourceKind::kRecording || source.kind == SourceKind::kRollout) {
      draw_scene_field(ui, *state.project, source);
      draw_film_camera(ui, state, draft, requests);
    }
    if (button(ui, "Remove source", {.icon = icon::kTrash, .help = "The film is made without it"})) {
      draft = workbench::without_source(std::move(draft));
    }
  }
  heading(ui, "Another source");
  draw_added(ui, state, draft, added);
}

}  // namespace trocar::ui
