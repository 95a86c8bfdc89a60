#include "ui/panels/fields_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "engine/spatial/units.h"
#include "ui/format.h"
#include "ui/icons.h"
#include "ui/panels/colour_legend.h"
#include "ui/panels/common.h"

namespace trocar::ui {
namespace {

using workbench::Command;
using workbench::SetField;

constexpr float kLeastSlice = 160.0F;  // Pixels at 100 %.

constexpr std::array<const char*, 3> kAxisNames{"x", "y", "z"};

int& coordinate(spatial::CellCoordinates& cell, int axis) {
  return axis == 0 ? cell.x : axis == 1 ? cell.y : cell.z;
}

int coordinate(const spatial::CellCoordinates& cell, int axis) {
  return axis == 0 ? cell.x : axis == 1 ? cell.y : cell.z;
}

std::vector<std::string> layer_names() {
  std::vector<std::string> names;
  for (const learning::Layer layer : learning::all_layers()) names.emplace_back(learning::to_string(layer));
  return names;
}

std::string value_words(const learning::Field& field, double value) {
  if (!std::isfinite(value)) return "unknown";
  if (!field.categorical) return number(value) + (field.unit.empty() ? "" : " " + field.unit);
  const auto i = static_cast<std::size_t>(std::lround(value));
  return i < field.categories.size() ? field.categories[i] : number(value);
}

std::string explored_words(std::uint8_t tried, bool goal) {
  if (goal) return "the goal, where episodes end";
  if (tried == 0x3F) return "all 6 actions tried";
  return tried == 0 ? "no action tried" : fmt::format("{} of 6 actions tried", std::popcount(tried));
}

// Layers that the probe always shows.
bool has_own_row(learning::Layer layer) {
  using enum learning::Layer;
  constexpr std::array<learning::Layer, 10> kRows{kReward,  kValue,  kQPlusX,  kQMinusX, kQPlusY,
                                                  kQMinusY, kQPlusZ, kQMinusZ, kMargin,  kVisits};
  return std::find(kRows.begin(), kRows.end(), layer) != kRows.end();
}

// The exact method keeps expectations, in thousandths.
std::string visits_words(const learning::Model& model, std::size_t cell) {
  const std::uint32_t visits = model.visits[cell];
  if (model.options.method != learning::Method::kExact) return count(visits);
  return number(1e-3 * visits) + " expected";
}

void dot(ImVec2 at, float radius, Rgba colour, Rgba ring) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddCircleFilled(at, radius + 1.5F, to_u32(ring), 16);
  list.AddCircleFilled(at, radius, to_u32(colour), 16);
}

// What stands above and below the picture of a slice: its axes and its slider.
float below_slice(const Ui& ui) {
  return ImGui::GetFrameHeightWithSpacing() + ui.fonts().small->FontSize + ImGui::GetStyle().ItemSpacing.y;
}

}  // namespace

void FieldsPanel::draw_controls(Ui& ui, const WorkbenchState& state, Requests& requests) {
  static const std::vector<std::string> kLayers = layer_names();
  static const std::vector<std::string> kScales{"Linear", "Symlog", "Percentile"};
  workbench::FieldSettings settings = state.field;
  form_label(ui, "Layer");
  const auto& layers = learning::all_layers();
  int layer = static_cast<int>(std::find(layers.begin(), layers.end(), settings.layer) - layers.begin());
  if (combo(ui, "Layer", layer, kLayers, {.help = "What is shown over the lattice"})) {
    settings.layer = layers[static_cast<std::size_t>(layer)];
    // On a linear scale the few cells that were visited most would leave all others black.
    const bool visits = settings.layer == learning::Layer::kVisits;
    if (visits && settings.scale == plot::ScaleKind::kLinear) settings.scale = plot::ScaleKind::kSymlog;
    requests.emplace_back(Command{SetField{settings}});
  }
  form_label(ui, "Scale");
  int scale = static_cast<int>(settings.scale);
  const std::string_view reason = shading_.field().categorical ? "Classes have no scale" : "";
  if (segmented(ui, "Scale", scale, kScales, {.help = reason.empty() ? "How values become colours" : reason})) {
    settings.scale = static_cast<plot::ScaleKind>(scale);
    requests.emplace_back(Command{SetField{settings}});
  }
  form_label(ui, "In the view");
  if (checkbox(ui, "Voxels", settings.voxels, {.help = "Draw the known cells as small cubes in the 3-D view"})) {
    requests.emplace_back(Command{SetField{settings}});
  }
  flow(ui.px(170), ui.px(14));
  if (slider_float(ui, "Opacity", settings.opacity, 0.05F, 1.0F, "%.2f opaque",
                   {.help = "Of the field in the 3-D view"})) {
    requests.emplace_back(Command{SetField{settings}});
  }
}

void FieldsPanel::move_to(const spatial::CellCoordinates& cell, const WorkbenchState& state, Requests& requests) {
  workbench::FieldSettings settings = state.field;
  for (int axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    index_[i] = coordinate(cell, axis);
    if (settings.slices[i] >= 0) settings.slices[i] = index_[i];
  }
  if (settings != state.field) requests.emplace_back(Command{SetField{settings}});
}

void FieldsPanel::take_mouse(int axis, const Rect& rect, bool hovered, const WorkbenchState& state,
                             Requests& requests) {
  const ImGuiIO& io = ImGui::GetIO();
  const bool dragged = ImGui::IsItemActive() && io.MouseDown[0];
  if (!hovered && !dragged) return;
  const int n = shading_.field().grid.n;
  const SliceAxes axes = slice_axes(axis);
  const float u = (io.MousePos.x - rect.x0) / rect.width();
  const float v = (rect.y1 - io.MousePos.y) / rect.height();
  spatial::CellCoordinates cell;
  coordinate(cell, axis) = index_[static_cast<std::size_t>(axis)];
  coordinate(cell, axes.right) = std::clamp(static_cast<int>(u * static_cast<float>(n)), 0, n - 1);
  coordinate(cell, axes.up) = std::clamp(static_cast<int>(v * static_cast<float>(n)), 0, n - 1);
  hovered_ = cell;
  if (dragged) move_to(cell, state, requests);
  if (hovered && io.MouseWheel != 0.0F) {
    coordinate(cell, axis) = std::clamp(coordinate(cell, axis) + (io.MouseWheel > 0.0F ? 1 : -1), 0, n - 1);
    coordinate(cell, axes.right) = index_[static_cast<std::size_t>(axes.right)];
    coordinate(cell, axes.up) = index_[static_cast<std::size_t>(axes.up)];
    move_to(cell, state, requests);
  }
}

void FieldsPanel::draw_marks(Ui& ui, const WorkbenchState& state, int axis, const Rect& rect) const {
  const spatial::Grid& grid = shading_.field().grid;
  const SliceAxes axes = slice_axes(axis);
  const float cell_px = rect.width() / static_cast<float>(grid.n);
  const auto middle = [&](int right, int up) {
    return ImVec2{rect.x0 + (static_cast<float>(right) + 0.5F) * cell_px,
                  rect.y1 - (static_cast<float>(up) + 0.5F) * cell_px};
  };
  const ImVec2 cross = middle(index_[static_cast<std::size_t>(axes.right)], index_[static_cast<std::size_t>(axes.up)]);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImU32 line = IM_COL32(255, 255, 255, 110);
  list.AddRectFilled({std::round(cross.x), rect.y0}, {std::round(cross.x) + 1.0F, rect.y1}, line);
  list.AddRectFilled({rect.x0, std::round(cross.y)}, {rect.x1, std::round(cross.y) + 1.0F}, line);
  const learning::Model& model = *state.insight->entry->model;
  const auto mark = [&](spatial::CellIndex index, std::string_view letter, Rgba colour) {
    const spatial::CellCoordinates cell = grid.coordinates(index);
    if (coordinate(cell, axis) != index_[static_cast<std::size_t>(axis)]) return;
    const ImVec2 at = middle(coordinate(cell, axes.right), coordinate(cell, axes.up));
    dot(at, ui.px(6), colour, {16, 18, 21, 255});
    const FontScope font(ui.fonts().small);
    const ImVec2 size = ImGui::CalcTextSize(letter.data(), letter.data() + letter.size());
    list.AddText({std::round(at.x - 0.5F * size.x), std::round(at.y - 0.5F * size.y)}, IM_COL32(16, 18, 21, 255),
                 letter.data(), letter.data() + letter.size());
  };
  mark(model.start, "S", {240, 240, 240, 255});
  mark(model.goal, "G", {255, 200, 60, 255});
}

void FieldsPanel::draw_slice(Ui& ui, const WorkbenchState& state, int axis, ImVec2 size, Requests& requests) {
  const auto i = static_cast<std::size_t>(axis);
  const Scope scope(ui, kAxisNames[i]);
  const SliceAxes axes = slice_axes(axis);
  ImGui::BeginGroup();
  {
    // Not as an item: beside another slice it would be set on that one's baseline.
    const FontScope font(ui.fonts().small);
    const std::string names = fmt::format("{} →  {} ↑", kAxisNames[static_cast<std::size_t>(axes.right)],
                                          kAxisNames[static_cast<std::size_t>(axes.up)]);
    ImGui::GetWindowDrawList()->AddText(ImGui::GetCursorScreenPos(), to_u32(ui.theme().text_dim), names.c_str());
    ImGui::Dummy({size.x, ImGui::GetFontSize()});
  }
  const float side = std::min(size.x, size.y - below_slice(ui));
  const bool hovered = canvas(ui, "Slice", {side, side}, std::to_string(index_[i]),
                              {.help = "Click to cut there, wheel to step through the slices"});
  const Rect rect = item_rect();
  take_mouse(axis, rect, hovered, state, requests);
  draw_hatch(ui, rect);
  const Image& picture = shading_.slice(axis, index_[i]);
  const ImTextureID texture =
      ui.textures().texture(fmt::format("slice {}", axis), picture, shading_.version(axis), Sampling::kNearest);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddImage(texture, {rect.x0, rect.y0}, {rect.x1, rect.y1});
  draw_marks(ui, state, axis, rect);
  workbench::FieldSettings settings = state.field;
  const bool in_view = settings.slices[i] >= 0;
  if (toggle(ui, "3-D", in_view, {.icon = icon::kEye, .help = "Show this slice in the 3-D view"})) {
    settings.slices[i] = in_view ? -1 : index_[i];
    requests.emplace_back(Command{SetField{settings}});
  }
  ImGui::SameLine(0.0F, ui.px(4));
  const std::string format = std::string(kAxisNames[i]) + " = %d";
  if (slider_int(ui, "Index", index_[i], 0, shading_.field().grid.n - 1, format.c_str(),
                 {.width = std::max(rect.x1 - ImGui::GetCursorScreenPos().x, ui.px(40))})) {
    move_to({index_[0], index_[1], index_[2]}, state, requests);
  }
  ImGui::EndGroup();
}

void FieldsPanel::draw_probe(Ui& ui, const WorkbenchState& state) {
  const Scope scope(ui, "Probe");
  const learning::Model& model = *state.insight->entry->model;
  const spatial::CellCoordinates at = hovered_.value_or(spatial::CellCoordinates{index_[0], index_[1], index_[2]});
  const spatial::CellIndex cell = model.grid.index(at);
  const auto flat = static_cast<std::size_t>(cell.value);
  const Eigen::Vector3d p = model.grid.centre(cell);
  const learning::Field& field = shading_.field();
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ui.px(6), ui.px(3)});
  heading(ui, fmt::format("Cell {}, {}, {}", at.x, at.y, at.z));
  const FontScope font(ui.fonts().small);
  fact(ui, "Position",
       fmt::format("{}, {}, {} mm", number(spatial::to_mm(p.x())), number(spatial::to_mm(p.y())),
                   number(spatial::to_mm(p.z()))));
  fact(ui, "Index", count(cell.value));
  if (!has_own_row(field.layer)) fact(ui, field.title, value_words(field, field.values[flat]));
  fact(ui, "Reward θ", number(model.theta[flat]));
  fact(ui, "Value V", number(model.value[flat]));
  const std::uint8_t best = state.insight->policy == nullptr ? learning::kNoAction : (*state.insight->policy)[flat];
  double first = -std::numeric_limits<double>::infinity();
  double second = first;
  for (int a = 0; a < spatial::kActionCount; ++a) {
    const double q = model.q_at(cell, static_cast<spatial::Action>(a));
    second = std::max(second, std::min(q, first));
    first = std::max(first, q);
    const std::string sign = a == static_cast<int>(best) ? std::string(icon::kVerify) + " " : "";
    fact(ui, fmt::format("Q {}", spatial::to_string(static_cast<spatial::Action>(a))), sign + number(q));
  }
  fact(ui, "Best action",
       best == learning::kNoAction ? "none" : spatial::to_string(static_cast<spatial::Action>(best)));
  fact(ui, "Margin", number(first - second));
  fact(ui, learning::Layer::kVisits == field.layer ? field.title : "Visits", visits_words(model, flat));
  fact(ui, "Explored", explored_words(model.tried[flat], cell == model.goal));
  ImGui::PopStyleVar();
}

void FieldsPanel::draw_slices(Ui& ui, const WorkbenchState& state, Requests& requests) {
  hovered_.reset();
  const float gap = ui.px(10);
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const float frame = below_slice(ui);
  const float half = 0.5F * (room.x - gap);
  if (half < ui.px(kLeastSlice)) {
    // One below the other, the panel scrolls.
    const float side = std::min(room.x, ui.px(280));
    for (const int axis : {2, 0, 1}) draw_slice(ui, state, axis, {side, side + frame}, requests);
    draw_probe(ui, state);
    return;
  }
  // Two by two: three slices and the probe; where the room is low, the slices shrink.
  const float side = std::max(std::min(half, 0.5F * (room.y - gap) - frame), ui.px(kLeastSlice));
  const ImVec2 size{side, side + frame};
  draw_slice(ui, state, 2, size, requests);
  ImGui::SameLine(0.0F, gap);
  draw_slice(ui, state, 0, size, requests);
  draw_slice(ui, state, 1, size, requests);
  ImGui::SameLine(0.0F, gap);
  ImGui::BeginChild("probe", {0.0F, std::max(ImGui::GetContentRegionAvail().y, side + frame)});
  draw_probe(ui, state);
  ImGui::EndChild();
}

Requests FieldsPanel::draw(Ui& ui, const WorkbenchState& state) {
  Requests requests;
  if (draw_no_project(ui, state, requests)) return requests;
  if (!state.insight || state.insight->entry == nullptr || state.insight->field == nullptr) {
    const std::string reason = command("model.train").reason_now(state);
    const std::array<EmptyStateAction, 1> actions{
        {{"Train a model…", icon::kTrain, reason, "Learn from demonstrations"}}};
    const bool waiting = selected_model(state) != nullptr;
    if (waiting) ui.animate();
    if (empty_state(
            ui, icon::kThLarge, waiting ? "Working out the field" : "No model is selected",
            waiting ? "This takes a moment" : "Reward, value and policy of a model are shown here, cell by cell",
            waiting ? std::span<const EmptyStateAction>{} : std::span<const EmptyStateAction>{actions}) == 0) {
      requests.emplace_back(ShowPanel{PanelId::kTrain});
    }
    return requests;
  }
  shading_.update(state.insight->field, state.field);
  const spatial::Grid& grid = shading_.field().grid;
  if (placed_for_ != state.model) {
    placed_for_ = state.model;
    const spatial::CellCoordinates goal = grid.coordinates(state.insight->entry->model->goal);
    index_ = {goal.x, goal.y, goal.z};
  }
  for (std::size_t i = 0; i < 3; ++i) {
    if (state.field.slices[i] >= 0) index_[i] = state.field.slices[i];
    index_[i] = std::clamp(index_[i], 0, grid.n - 1);
  }
  draw_controls(ui, state, requests);
  const spatial::CellCoordinates at = hovered_.value_or(spatial::CellCoordinates{index_[0], index_[1], index_[2]});
  ImGui::Dummy({0.0F, ui.px(2)});
  colour_legend(ui, shading_, shading_.field().values[static_cast<std::size_t>(grid.index(at).value)]);
  ImGui::Dummy({0.0F, ui.px(2)});
  draw_slices(ui, state, requests);
  return requests;
}

}  // namespace trocar::ui
