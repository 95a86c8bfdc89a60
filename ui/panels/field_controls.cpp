#include "ui/panels/field_controls.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "engine/learning/start_set.h"
#include "ui/panels/field_layer_list.h"

namespace trocar::ui {
namespace {

using workbench::Command;
using workbench::FieldSettings;
using workbench::Glyphs;
using workbench::SetField;

// Those that suit numbers; classes have their own colours.
constexpr std::array<plot::ColourMap, 6> kMaps{plot::ColourMap::kViridis, plot::ColourMap::kCividis,
                                               plot::ColourMap::kMagma,   plot::ColourMap::kTurbo,
                                               plot::ColourMap::kGrey,    plot::ColourMap::kDiverging};

template <typename Kinds>
std::vector<std::string> names_of(const Kinds& kinds) {
  std::vector<std::string> names;
  for (const auto kind : kinds) names.emplace_back(to_string(kind));
  return names;
}

std::vector<std::string> map_names() {
  std::vector<std::string> names{"auto colours"};
  for (const plot::ColourMap map : kMaps) names.emplace_back(plot::to_string(map));
  return names;
}

// A drop-down list of some kinds, by their names on the command line. True if another was chosen.
template <typename Kind>
bool choose(Ui& ui, std::string_view label, Kind& kind, const std::vector<Kind>& kinds, const WidgetOptions& options) {
  const std::vector<std::string> names = names_of(kinds);
  int chosen = static_cast<int>(std::find(kinds.begin(), kinds.end(), kind) - kinds.begin());
  if (!combo(ui, label, chosen, names, options)) return false;
  kind = kinds[static_cast<std::size_t>(chosen)];
  return true;
}

bool choose_map(Ui& ui, std::optional<plot::ColourMap>& map, const WidgetOptions& options) {
  static const std::vector<std::string> kNames = map_names();
  int chosen = 0;
  for (std::size_t i = 0; i < kMaps.size(); ++i) {
    if (map == kMaps[i]) chosen = static_cast<int>(i) + 1;
  }
  if (!combo(ui, "Map", chosen, kNames, options)) return false;
  map.reset();
  if (chosen > 0) map = kMaps[static_cast<std::size_t>(chosen) - 1];
  return true;
}

void choose_mask(Ui& ui, learning::FieldMask& mask) {
  static const std::vector<std::string> kNames{"all", "the safe set", "the expert's", "visited in training",
                                               "those that arrive"};
  auto chosen = static_cast<int>(mask);
  if (combo(ui, "Mask", chosen, kNames, {.help = "Which cells are shown; the others count as unknown"})) {
    mask = learning::all_field_masks()[static_cast<std::size_t>(chosen)];
  }
}

std::vector<std::string> vision_names() {
  std::vector<std::string> names = names_of(plot::all_colour_visions());
  names.front() = "full colour vision";
  return names;
}

bool choose_vision(Ui& ui, plot::ColourVision& vision, float width) {
  static const std::vector<std::string> kNames = vision_names();
  auto chosen = static_cast<int>(vision);
  if (!combo(ui, "Seen with", chosen, kNames,
             {.help = "How a reader without red, green or blue cones sees it, or a print in grey", .width = width})) {
    return false;
  }
  vision = plot::all_colour_visions()[static_cast<std::size_t>(chosen)];
  return true;
}

bool choose_colours(Ui& ui, const FieldShading& shading, FieldSettings& settings) {
  const std::string_view reason = shading.field().categorical ? "Classes have no scale" : "";
  const std::string_view no_map = shading.field().categorical ? "Classes have colours of their own" : "";
  const float gap = ui.px(6);
  const float room = ImGui::GetContentRegionAvail().x;
  const bool narrow = room < ui.px(330);
  const float width = narrow ? room : (room - 2.0F * gap) / 3.0F;
  bool changed = choose(ui, "Scale", settings.scale, plot::all_scale_kinds(),
                        {.help = "How values become colours", .reason = reason, .width = width});
  flow(width, gap);
  changed |= choose_map(ui, settings.map,
                        {.help = "The colours; automatic: what suits the layer", .reason = no_map, .width = width});
  flow(width, gap);
  return choose_vision(ui, settings.vision, width) || changed;
}

bool flag(Ui& ui, std::string_view label, bool& on, std::string_view help, std::string_view reason = {}) {
  const float gap = ui.px(14);
  flow(ImGui::GetFrameHeight() + ui.px(8) + ImGui::CalcTextSize(label.data(), label.data() + label.size()).x, gap);
  return checkbox(ui, label, on, {.help = help, .reason = reason});
}

bool share_slider(Ui& ui, std::string_view label, double& share, const char* format, std::string_view help) {
  auto value = static_cast<float>(share);
  if (!slider_float(ui, label, value, 0.0F, 1.0F, format, {.help = help})) return false;
  share = static_cast<double>(value);
  return true;
}

bool choose_drawings(Ui& ui, const FieldShading& shading, FieldSettings& settings) {
  const std::string_view reason = shading.field().categorical ? "Classes have neither surface nor volume" : "";
  bool changed = checkbox(ui, "Voxels", settings.voxels, {.help = "Draw the cells above the threshold as small cubes"});
  changed |= flag(ui, "Surface", settings.iso_surface, "Draw where the field has one value", reason);
  changed |= flag(ui, "Volume", settings.volume, "Draw the field as a cloud, as thick as its curve says", reason);
  changed |= flag(ui, "Streamlines", settings.streamlines, "Draw where the greedy policy leads");
  return changed;
}

bool choose_details(Ui& ui, const WorkbenchState& state, const FieldShading& shading, OpacityEditor& opacity,
                    FieldSettings& settings) {
  bool changed = false;
  if (settings.voxels) {
    form_label(ui, "Threshold");
    changed |=
        share_slider(ui, "Threshold", settings.voxel_threshold, "%.2f of the scale", "Voxels are drawn from here on");
  }
  if (settings.iso_surface) {
    form_label(ui, "Level");
    changed |= share_slider(ui, "Level", settings.iso_level, "%.2f of the scale", "Where the surface is");
  }
  if (settings.volume && !shading.field().categorical) {
    changed |= opacity.draw(ui, shading, settings.opacity_curve);
  }
  if (settings.streamlines) {
    form_label(ui, "From");
    changed |= text_field(ui, "Starts", settings.streamline_starts, "around:2", {.help = learning::start_set_help()});
    const auto starts = learning::starts_from(settings.streamline_starts, *state.insight->entry->model);
    if (!starts) wrapped_text(ui, starts.error().text(), ui.theme().danger);
  }
  return changed;
}

}  // namespace

void draw_field_controls(Ui& ui, const WorkbenchState& state, const FieldShading& shading, OpacityEditor& opacity,
                         bool& montage, Requests& requests) {
  FieldSettings settings = state.field;
  form_label(ui, "Layer");
  if (choose(ui, "Layer", settings.layer, learning::all_layers(), {.help = "What is shown over the lattice"})) {
    // On a linear scale the few cells that were visited most would leave all others black; limits are of one layer.
    const bool visits = settings.layer == learning::Layer::kVisits;
    if (visits && settings.scale == plot::ScaleKind::kLinear) settings.scale = plot::ScaleKind::kSymlog;
    settings.limits.reset();
  }
  form_label(ui, "Cells");
  choose_mask(ui, settings.mask);
  form_label(ui, "Colours");
  const plot::ScaleKind scale = settings.scale;
  ImGui::BeginGroup();
  choose_colours(ui, shading, settings);
  ImGui::EndGroup();
  if (settings.scale != scale) settings.limits.reset();
  form_label(ui, "In the view");
  ImGui::BeginGroup();
  choose_drawings(ui, shading, settings);
  ImGui::EndGroup();
  choose_details(ui, state, shading, opacity, settings);
  form_label(ui, "On slices");
  ImGui::BeginGroup();
  const float half = 0.5F * (ImGui::GetContentRegionAvail().x - ui.px(14));
  choose(ui, "Glyphs", settings.glyphs, stage::all_glyphs(),
         {.help = "In the cells of slices in the view: nothing, the best action, or six arms as long as Q",
          .width = std::max(half, ui.px(90))});
  flow(std::max(half, ui.px(150)), ui.px(14));
  slider_float(ui, "Opacity", settings.opacity, 0.05F, 1.0F, "%.2f opaque", {.help = "Of the field in the 3-D view"});
  ImGui::EndGroup();
  if (settings.slabs != std::array{1, 1, 1}) {
    form_label(ui, "Thick slices");
    choose(ui, "Through", settings.through, learning::all_through(),
           {.help = "What a slice of several cells shows: the largest value across, or the mean of those known",
            .reason = shading.field().categorical ? "Classes have neither largest nor mean" : ""});
  }
  draw_field_layers(ui, state, requests);
  form_label(ui, "Shown here");
  static const std::vector<std::string> kModes{"Slices", "Montage"};
  int mode = montage ? 1 : 0;
  if (segmented(ui, "Mode", mode, kModes, {.help = "Three slices and the probe, or all slices along z"})) {
    montage = mode == 1;
  }
  if (settings != state.field) requests.emplace_back(Command{SetField{settings}});
}

}  // namespace trocar::ui
