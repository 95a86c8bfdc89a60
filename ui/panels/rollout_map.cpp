#include "ui/panels/rollout_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/learning/start_set.h"
#include "ui/format.h"
#include "ui/icons.h"
#include "ui/panels/colour_legend.h"
#include "ui/panels/rollout_parts.h"

namespace trocar::ui {
namespace {

constexpr std::array<const char*, 3> kAxes{"x", "y", "z"};

int& coordinate_along(spatial::CellCoordinates& cell, int axis) {
  return axis == 0 ? cell.x : axis == 1 ? cell.y : cell.z;
}
int coordinate_along(const spatial::CellCoordinates& cell, int axis) {
  return axis == 0 ? cell.x : axis == 1 ? cell.y : cell.z;
}

Rect cell_rect(const Rect& rect, int n, int right, int up) {
  const float side = rect.width() / static_cast<float>(n);
  const float x = rect.x0 + static_cast<float>(right) * side;
  const float y = rect.y1 - static_cast<float>(up + 1) * side;
  return {x, y, x + side, y + side};
}

std::string said(const learning::Field& field, double value) {
  if (!std::isfinite(value)) return "unknown";
  if (!field.categorical) return number(value);
  const auto i = static_cast<std::size_t>(std::lround(value));
  return i < field.categories.size() ? field.categories[i] : number(value);
}

}  // namespace

std::shared_ptr<const learning::Field> RolloutMap::field(Ui& ui, const WorkbenchState& state) {
  static const std::vector<std::string> kShown{"Outcome", "Share", "Both models"};
  const workbench::ModelInsight& insight = *state.insight;
  if (of_ != insight.entry) {
    of_ = insight.entry;
    outcomes_ = std::make_shared<const learning::Field>(learning::field(*of_->model, learning::Layer::kBasin));
    const spatial::CellCoordinates start = of_->model->grid.coordinates(of_->model->start);
    index_ = coordinate_along(start, axis_);
  }
  segmented(ui, "Map", shown_, kShown,
            {.help = "How every start ends; the share that arrives when the agent errs; who arrives of two models"});
  std::string why;
  std::shared_ptr<const learning::Field> chosen = outcomes_;
  if (shown_ == 1) {
    const bool there = state.monte_carlo && state.monte_carlo->share->grid == of_->model->grid;
    if (there) chosen = state.monte_carlo->share;
    if (!there) why = "No share is known yet: let the agent err at random, below Chance";
  }
  if (shown_ == 2) {
    if (insight.second) chosen = insight.second->outcomes;
    if (!insight.second) why = "No second model is chosen, below Two models";
  }
  if (!why.empty()) wrapped_text(ui, why, ui.theme().text_dim);
  return chosen;
}

std::string RolloutMap::slice() const {
  return fmt::format("{}={}", kAxes[static_cast<std::size_t>(axis_)], index_);
}

void RolloutMap::brush(const spatial::Grid& grid, const spatial::CellCoordinates& middle) {
  const SliceAxes axes = slice_axes(axis_);
  for (int du = -radius_ + 1; du < radius_; ++du) {
    for (int dv = -radius_ + 1; dv < radius_; ++dv) {
      spatial::CellCoordinates cell = middle;
      coordinate_along(cell, axes.right) += du;
      coordinate_along(cell, axes.up) += dv;
      if (!grid.contains(cell)) continue;
      if (static_cast<Mouse>(mouse_) == Mouse::kPaint) chosen_.insert(grid.index(cell));
      if (static_cast<Mouse>(mouse_) == Mouse::kErase) chosen_.erase(grid.index(cell));
    }
  }
}

void RolloutMap::take_mouse(const WorkbenchState& state, const Rect& rect, bool hovered, Requests& requests) {
  const ImGuiIO& io = ImGui::GetIO();
  const bool pressed = ImGui::IsItemActive() && io.MouseDown[0];
  const spatial::Grid& grid = of_->model->grid;
  hovered_.reset();
  if (painting_ && !pressed) {
    // One request for a whole stroke.
    painting_ = false;
    std::vector<spatial::CellIndex> cells;
    for (std::int32_t cell = 0; cell < grid.cell_count(); ++cell) {
      if (chosen_.contains({cell})) cells.push_back({cell});
    }
    if (!cells.empty()) choose_starts(state, learning::start_text(cells), requests);
    if (cells.empty()) chosen_of_.reset();  // No starts are none: those before come back.
  }
  if (!hovered && !pressed) return;
  const SliceAxes axes = slice_axes(axis_);
  const auto n = static_cast<float>(grid.n);
  spatial::CellCoordinates cell;
  coordinate_along(cell, axis_) = index_;
  coordinate_along(cell, axes.right) =
      std::clamp(static_cast<int>((io.MousePos.x - rect.x0) / rect.width() * n), 0, grid.n - 1);
  coordinate_along(cell, axes.up) =
      std::clamp(static_cast<int>((rect.y1 - io.MousePos.y) / rect.height() * n), 0, grid.n - 1);
  hovered_ = cell;
  if (hovered && io.MouseWheel != 0.0F) index_ = std::clamp(index_ + (io.MouseWheel > 0.0F ? 1 : -1), 0, grid.n - 1);
  if (!pressed) return;
  if (static_cast<Mouse>(mouse_) == Mouse::kSelect) {
    select_start(state, grid.index(cell), requests);
    return;
  }
  if (!painting_ && !state.rollouts.starts.starts_with("cells:")) chosen_ = spatial::CellSet(grid);
  painting_ = true;
  brush(grid, cell);
}

void RolloutMap::draw_marks(Ui& ui, const WorkbenchState& state, const Rect& rect) const {
  const learning::Model& model = *of_->model;
  const spatial::Grid& grid = model.grid;
  const SliceAxes axes = slice_axes(axis_);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (int right = 0; right < grid.n; ++right) {
    for (int up = 0; up < grid.n; ++up) {
      spatial::CellCoordinates cell;
      coordinate_along(cell, axis_) = index_;
      coordinate_along(cell, axes.right) = right;
      coordinate_along(cell, axes.up) = up;
      if (chosen_.contains(grid.index(cell))) continue;
      const Rect place = cell_rect(rect, grid.n, right, up);
      // What is no start is seen, but steps back.
      list.AddRectFilled({place.x0, place.y0}, {place.x1, place.y1}, to_u32(ui.theme().panel, 0.62F));
    }
  }
  const auto mark = [&](spatial::CellIndex index, Rgba colour, bool ring) {
    const spatial::CellCoordinates cell = grid.coordinates(index);
    if (coordinate_along(cell, axis_) != index_) return;
    const Rect place = cell_rect(rect, grid.n, coordinate_along(cell, axes.right), coordinate_along(cell, axes.up));
    const ImVec2 middle{place.centre_x(), place.centre_y()};
    const float radius = std::max(ui.px(4), 0.5F * place.width());
    if (!ring) list.AddCircleFilled(middle, radius + 1.5F, IM_COL32(16, 18, 21, 255), 16);
    if (!ring) list.AddCircleFilled(middle, radius, to_u32(colour), 16);
    if (!ring) return;
    list.AddCircle(middle, radius + ui.px(2), IM_COL32(16, 18, 21, 255), 20, ui.px(4));
    list.AddCircle(middle, radius + ui.px(2), to_u32(colour), 20, ui.px(2));
  };
  mark(model.start, {240, 240, 240, 255}, false);
  mark(model.goal, {255, 200, 60, 255}, false);
  if (state.insight->selected) mark(state.insight->selected->start, {255, 255, 255, 255}, true);
}

void RolloutMap::draw(Ui& ui, const WorkbenchState& state, Requests& requests) {
  const Scope scope(ui, "Success map");
  static const std::vector<std::string> kMouse{"Select", "Paint", "Erase"};
  static const std::vector<std::string> kAcross{"x", "y", "z"};
  heading(ui, "Success map");
  const auto drawn = field(ui, state);
  workbench::FieldSettings colours;
  if (!drawn->categorical) colours.limits = {{0.0, 1.0}};  // A share.
  shading_.update(drawn, colours);
  const spatial::Grid& grid = of_->model->grid;
  if (!painting_ && chosen_of_ != state.insight) {
    chosen_ = spatial::CellSet(grid);
    for (const spatial::CellIndex cell : state.insight->starts) chosen_.insert(cell);
    chosen_of_ = state.insight;
  }
  index_ = std::clamp(index_, 0, grid.n - 1);
  form_label(ui, "Across");
  if (segmented(ui, "Across", axis_, kAcross, {.help = "The axis that the slice is across"})) {
    const auto& selected = state.insight->selected;
    index_ = coordinate_along(grid.coordinates(selected ? selected->start : of_->model->start), axis_);
  }
  form_label(ui, "Slice");
  const std::string format = std::string(kAxes[static_cast<std::size_t>(axis_)]) + " = %d";
  slider_int(ui, "Slice", index_, 0, grid.n - 1, format.c_str(), {.help = "Which one; the wheel over it, too"});
  const float side = std::min(ImGui::GetContentRegionAvail().x, ui.px(300));
  const std::string value =
      hovered_ ? fmt::format("{}: {}", start_words(grid, grid.index(*hovered_)),
                             said(shading_.field(),
                                  shading_.field().values[static_cast<std::size_t>(grid.index(*hovered_).value)]))
               : fmt::format("{} = {}", kAxes[static_cast<std::size_t>(axis_)], index_);
  const bool hovered = canvas(ui, "Cells", {side, side}, value,
                              {.help = static_cast<Mouse>(mouse_) == Mouse::kSelect
                                           ? "Click a start to see its rollout, wheel to step through the slices"
                                           : "Drag over the cells from which the agent shall start"});
  const Rect rect = item_rect();
  take_mouse(state, rect, hovered, requests);
  draw_hatch(ui, rect);
  const ImTextureID texture = ui.textures().texture(fmt::format("success map {}", axis_), shading_.slice(axis_, index_),
                                                    shading_.version(axis_), Sampling::kNearest);
  ImGui::GetWindowDrawList()->AddImage(texture, {rect.x0, rect.y0}, {rect.x1, rect.y1});
  draw_marks(ui, state, rect);
  small_text(ui, value, ui.theme().text_dim);
  form_label(ui, "Mouse");
  segmented(ui, "Mouse", mouse_, kMouse, {.help = "Select one start, or paint which cells are starts"});
  if (static_cast<Mouse>(mouse_) != Mouse::kSelect) {
    form_label(ui, "Brush");
    slider_int(ui, "Brush", radius_, 1, 5, "%d cells", {.help = "From its middle, within the slice"});
  }
  colour_legend(ui, shading_, std::numeric_limits<double>::quiet_NaN(), {});
}

}  // namespace trocar::ui
