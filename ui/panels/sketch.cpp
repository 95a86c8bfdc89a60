#include "ui/panels/sketch.h"

namespace trocar::ui {
namespace {

ImVec2 at(const Rect& place, const workbench::SketchPoint& point) {
  return {place.x0 + point.x * place.width(), place.y0 + point.y * place.height()};
}

}  // namespace

void draw_sketch(const Ui& ui, const workbench::PathSketch& sketch, const Rect& place) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled({place.x0, place.y0}, {place.x1, place.y1}, to_u32(ui.theme().ground), ui.px(3));
  for (const workbench::SketchPoint& peg : workbench::sketch_pegs()) {
    list.AddCircleFilled(at(place, peg), ui.px(1), to_u32(ui.theme().text_disabled), 6);
  }
  for (std::size_t arm = 0; arm < sketch.arms.size(); ++arm) {
    const auto& points = sketch.arms[arm];
    for (std::size_t i = 1; i < points.size(); ++i) {
      const auto& segment = points[i - 1].segment;
      const Rgba colour = segment ? segment_colour(*segment) : ui.theme().text_dim;
      list.AddLine(at(place, points[i - 1]), at(place, points[i]), to_u32(colour), ui.px(1.5F));
    }
    if (points.empty()) continue;
    const ImVec2 end = at(place, points.back());
    const float half = ui.px(2);
    if (arm == 0) {
      list.AddCircleFilled(end, half, to_u32(ui.theme().text), 8);
    } else {
      list.AddRectFilled({end.x - half, end.y - half}, {end.x + half, end.y + half}, to_u32(ui.theme().text));
    }
  }
}

const workbench::PathSketch& SketchCache::of(const std::shared_ptr<const demonstration::Demonstration>& document) {
  Kept& kept = kept_[document->id];
  if (kept.of != document) kept = {document, workbench::path_sketch(*document)};
  return kept.sketch;
}

}  // namespace trocar::ui
