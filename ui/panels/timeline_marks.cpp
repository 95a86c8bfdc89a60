#include "ui/panels/timeline_marks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "ui/format.h"

namespace trocar::ui {
namespace {

ImDrawList& list() {
  return *ImGui::GetWindowDrawList();
}

float clamped_x(const LaneLayout& layout, double t_s) {
  return std::round(std::clamp(layout.x_of(t_s), layout.lanes.x0, layout.lanes.x1));
}

void draw_gate(Ui& ui, const LaneLayout& layout, double t_s, bool in, bool lit) {
  const float x = std::round(layout.x_of(t_s));
  if (x < layout.lanes.x0 - 1.0F || x > layout.lanes.x1 + 1.0F) return;
  const Rgba colour = lit ? ui.theme().accent : ui.theme().text_dim;
  const float tab = ui.px(8);
  const float x0 = in ? x - tab : x;
  list().AddRectFilled({x - 1.0F, layout.gates.y0}, {x + 1.0F, layout.lanes.y1}, to_u32(colour));
  list().AddRectFilled({x0, layout.gates.y0}, {x0 + tab, layout.gates.y1}, to_u32(colour), ui.px(2));
  note_rect(ui, "slider", in ? "In gate" : "Out gate", fmt::format("{:.3f}", t_s),
            {x0, layout.gates.y0, x0 + tab, layout.gates.y1}, {.help = "Drag to trim"});
}

void draw_used(Ui& ui, const LaneLayout& layout) {
  const float x0 = clamped_x(layout, layout.gate_in_s);
  const float x1 = clamped_x(layout, layout.gate_out_s);
  const Rect& row = layout.gates;
  list().AddRectFilled({x0, row.y0 + ui.px(2)}, {x1, row.y1 - ui.px(2)}, to_u32(ui.theme().raised));
  const FontScope font(ui.fonts().small);
  const float text = ImGui::GetFontSize();
  list().AddText({layout.names.x0, std::round(row.centre_y() - 0.5F * text)}, to_u32(ui.theme().text_dim), "In, out");
  const std::string words = seconds(layout.gate_out_s - layout.gate_in_s);
  const float width = ImGui::CalcTextSize(words.c_str()).x;
  if (width + ui.px(12) > x1 - x0) return;
  list().AddText({std::round(0.5F * (x0 + x1 - width)), std::round(row.centre_y() - 0.5F * text)},
                 to_u32(ui.theme().text_dim), words.c_str());
}

}  // namespace

void draw_gates(Ui& ui, const LaneLayout& layout, TimelineMouse::Drag drag) {
  draw_used(ui, layout);
  const Rect& lanes = layout.lanes;
  const float in = clamped_x(layout, layout.gate_in_s);
  const float out = clamped_x(layout, layout.gate_out_s);
  const ImU32 veil = to_u32(ui.theme().panel, 0.72F);
  if (in > lanes.x0) list().AddRectFilled({lanes.x0, lanes.y0}, {in, lanes.y1}, veil);
  if (out < lanes.x1) list().AddRectFilled({out, lanes.y0}, {lanes.x1, lanes.y1}, veil);
  draw_gate(ui, layout, layout.gate_in_s, true, drag == TimelineMouse::Drag::kGateIn);
  draw_gate(ui, layout, layout.gate_out_s, false, drag == TimelineMouse::Drag::kGateOut);
}

void draw_selection(Ui& ui, const LaneLayout& layout, const workbench::TimeSpan& selection) {
  const float x0 = clamped_x(layout, selection.begin_s);
  const float x1 = clamped_x(layout, selection.end_s);
  const Rect& lanes = layout.lanes;
  const Rgba colour = ui.theme().text;
  list().AddRectFilled({x0, lanes.y0}, {x1, lanes.y1}, to_u32(ui.theme().accent, 0.22F));
  // A bar on the ruler, and a line at each end: a span that is too short to see is still two lines.
  list().AddRectFilled({x0, layout.ruler.y1 - ui.px(5)}, {std::max(x1, x0 + 2.0F), layout.ruler.y1},
                       to_u32(ui.theme().accent));
  const auto edge = [&](double t_s, float x, float side, std::string_view label) {
    if (layout.x_of(t_s) < lanes.x0 || layout.x_of(t_s) > lanes.x1) return;
    const float half = std::max(1.0F, ui.px(1));
    list().AddRectFilled({x - half, layout.ruler.y1 - ui.px(5)}, {x + half, lanes.y1}, to_u32(colour));
    const float foot = ui.px(4) * side;
    for (const float y : {lanes.y0, lanes.y1 - 2.0F * half}) {
      list().AddRectFilled({std::min(x, x + foot), y}, {std::max(x, x + foot), y + 2.0F * half}, to_u32(colour));
    }
    note_rect(ui, "mark", label, fmt::format("{:.3f}", t_s), {x - ui.px(4), lanes.y0, x + ui.px(4), lanes.y1},
              {.help = "Drag to change the selection"});
  };
  edge(selection.begin_s, x0, 1.0F, "Selection begin");
  edge(selection.end_s, x1, -1.0F, "Selection end");
}

void draw_zoomed(Ui& ui, const LaneLayout& layout, const workbench::TimeSpan& span) {
  const float x0 = clamped_x(layout, span.begin_s);
  const float x1 = clamped_x(layout, span.end_s);
  list().AddRectFilled({x0, layout.ruler.y0}, {x1, layout.lanes.y1}, to_u32(ui.theme().text, 0.08F));
  list().AddRect({x0, layout.ruler.y0}, {x1, layout.lanes.y1}, to_u32(ui.theme().text_dim));
}

void draw_playhead(Ui& ui, const LaneLayout& layout, double t_s) {
  const float x = std::round(layout.x_of(t_s));
  if (x < layout.lanes.x0 || x > layout.lanes.x1) return;
  const ImU32 colour = to_u32(ui.theme().accent);
  const float half = ui.px(5);
  const float y = layout.ruler.y1 - ui.px(7);
  list().AddRectFilled({x - 1.0F, y}, {x + 1.0F, layout.lanes.y1}, colour);
  list().AddRectFilled({x - half, y - ui.px(6)}, {x + half, y}, colour, ui.px(2));
  list().AddTriangleFilled({x - half, y}, {x + half, y}, {x, y + ui.px(6)}, colour);
}

void draw_snap(Ui& ui, const LaneLayout& layout, double t_s) {
  const float x = std::round(layout.x_of(t_s));
  if (x < layout.lanes.x0 || x > layout.lanes.x1) return;
  const float half = ui.px(4);
  const float y = layout.gates.centre_y();
  list().AddQuad({x - half, y}, {x, y - half}, {x + half, y}, {x, y + half}, to_u32(ui.theme().text), ui.px(2));
}

void draw_gaps(Ui& ui, const LaneLayout& layout, const std::vector<Run>& gaps) {
  const Scope scope(ui, "Gaps");
  int number = 0;
  for (const Run& gap : gaps) {
    ++number;
    const float x0 = std::max(layout.x_of(gap.begin_s), layout.lanes.x0);
    const float x1 = std::min(std::max(layout.x_of(gap.end_s), x0 + ui.px(2)), layout.lanes.x1);
    if (x1 <= x0) continue;
    const Rect rect{x0, layout.lanes.y0, x1, layout.lanes.y1};
    list().PushClipRect({rect.x0, rect.y0}, {rect.x1, rect.y1}, true);
    list().AddRectFilled({rect.x0, rect.y0}, {rect.x1, rect.y1}, to_u32(ui.theme().danger, 0.12F));
    for (float x = rect.x0 - rect.height(); x < rect.x1; x += ui.px(9)) {
      list().AddLine({x, rect.y1}, {x + rect.height(), rect.y0}, to_u32(ui.theme().danger, 0.5F), ui.px(1));
    }
    list().PopClipRect();
    note_rect(ui, "gap", fmt::format("Gap {}", number), seconds(gap.end_s - gap.begin_s), rect);
  }
}

}  // namespace trocar::ui
