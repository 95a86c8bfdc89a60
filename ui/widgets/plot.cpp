#include "ui/widgets/plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "ui/format.h"
#include "ui/widgets/plot_lines.h"

namespace trocar::ui {
namespace {

constexpr float kLeft = 78.0F;  // As the timeline's names, so that a time stays where it is; all at 100 %.
constexpr float kRight = 10.0F;
constexpr float kLegend = 18.0F;
constexpr float kBelow = 7.0F;  // Half of the lowest value's height, where no times follow.
constexpr float kTimes = 17.0F;
constexpr float kLeastArea = 44.0F;

double cursor_of(const PlotSpec& spec) {
  return spec.cursor_s.value_or(spec.playhead_s);
}

// Speeds begin with the first few samples, and the playhead with the first: what is but a little beyond an end is its.
std::optional<double> value_near(const plot::Curve& curve, double t_s) {
  constexpr double kNear_s = 0.05;
  if (curve.empty()) return std::nullopt;
  const double within_s = std::clamp(t_s, curve.x().front(), curve.x().back());
  return curve.value_at(std::abs(within_s - t_s) <= kNear_s ? within_s : t_s);
}

std::string value_words(const PlotLine& line, double t_s) {
  const std::optional<double> value = value_near(*line.curve, t_s);
  return value ? number(*value) : "–";
}

std::string read_out(const PlotSpec& spec) {
  std::string words = "at " + seconds(cursor_of(spec));
  for (const PlotLine& line : spec.lines) {
    words += fmt::format(", {} {} {}", line.name, value_words(line, cursor_of(spec)), spec.unit);
  }
  return words;
}

PlotArea area_of(const Ui& ui, const PlotSpec& spec, const Rect& rect) {
  const float below = spec.time_axis ? ui.px(kTimes) : ui.px(kBelow);
  return {{rect.x0 + ui.px(kLeft), rect.y0 + ui.px(kLegend), rect.x1 - ui.px(kRight), rect.y1 - below},
          spec.begin_s,
          spec.end_s,
          spec.values};
}

ImVec2 size_of(std::string_view words) {
  return ImGui::CalcTextSize(words.data(), words.data() + words.size());
}

void write(ImVec2 at, Rgba colour, std::string_view words) {
  ImGui::GetWindowDrawList()->AddText({std::round(at.x), std::round(at.y)}, to_u32(colour), words.data(),
                                      words.data() + words.size());
}

// Title, then each line with its value at the cursor, as far as there is room: above the lines, never over them.
void draw_legend(const Ui& ui, const PlotSpec& spec, const Rect& rect) {
  const FontScope font(ui.fonts().small);
  const float y = rect.y0 + 0.5F * (ui.px(kLegend) - ImGui::GetFontSize());
  float x = rect.x0 + ui.px(10);
  const std::string title = fmt::format("{}, {}", spec.label, spec.unit);
  write({x, y}, ui.theme().text, title);
  x = std::max(x + size_of(title).x + ui.px(14), rect.x0 + ui.px(kLeft));
  const float middle = rect.y0 + 0.5F * ui.px(kLegend);
  for (const PlotLine& line : spec.lines) {
    const std::string words = fmt::format("{} {}", line.name, value_words(line, cursor_of(spec)));
    const float stroke = ui.px(24);
    // Room for a few digits more, so that entries do not wander while the cursor moves.
    const float width = std::max(size_of(words).x, size_of(line.name + " −0000.0").x);
    if (x + stroke + ui.px(6) + size_of(words).x > rect.x1 - ui.px(kRight)) return;
    draw_sample(ui, line, x, x + stroke, std::round(middle));
    write({x + stroke + ui.px(6), y}, line.style == LineStyle::kGhost ? ui.theme().text_dim : ui.theme().text, words);
    x += stroke + ui.px(6) + width + ui.px(12);
  }
  const std::string at = "at " + seconds(cursor_of(spec));
  if (x + size_of(at).x < rect.x1 - ui.px(kRight)) {
    write({rect.x1 - ui.px(kRight) - size_of(at).x, y}, ui.theme().text_dim, at);
  }
}

// The borders of high contrast are too bright to lie behind lines.
float grid_strength(const Theme& theme) {
  return theme.outlined ? 0.25F : 0.5F;
}

void draw_value_axis(const Ui& ui, const PlotArea& area) {
  const FontScope font(ui.fonts().small);
  const float text = ImGui::GetFontSize();
  const plot::Axis axis = plot::axis_over(area.values.low, area.values.high, static_cast<double>(area.rect.height()),
                                          static_cast<double>(1.9F * text));
  ImDrawList& list = *ImGui::GetWindowDrawList();
  float free_below = area.rect.y1 + 0.5F * text;
  for (std::size_t i = 0; i < axis.ticks.size(); ++i) {
    const float y = std::round(area.y_of(axis.ticks[i]));
    list.AddRectFilled({area.rect.x0, y}, {area.rect.x1, y + 1.0F},
                       to_u32(ui.theme().line, (axis.ticks[i] == 0.0 ? 2.0F : 1.0F) * grid_strength(ui.theme())));
    const float top = std::max(y - 0.5F * text, area.rect.y0 - 0.3F * text);
    if (top + text > free_below + 1.0F) continue;
    write({area.rect.x0 - ui.px(6) - size_of(axis.labels[i]).x, top}, ui.theme().text_dim, axis.labels[i]);
    free_below = top;
  }
}

void draw_time_axis(const Ui& ui, const PlotSpec& spec, const PlotArea& area) {
  const FontScope font(ui.fonts().small);
  const plot::Axis axis =
      plot::axis_over(area.begin_s, area.end_s, static_cast<double>(area.rect.width()), static_cast<double>(ui.px(70)));
  ImDrawList& list = *ImGui::GetWindowDrawList();
  float free_from = area.rect.x0 - ui.px(kLeft);
  for (std::size_t i = 0; i < axis.ticks.size(); ++i) {
    if (axis.ticks[i] < 0.0) continue;
    const float x = std::round(area.x_of(axis.ticks[i]));
    list.AddRectFilled({x, area.rect.y0}, {x + 1.0F, area.rect.y1}, to_u32(ui.theme().line, grid_strength(ui.theme())));
    if (!spec.time_axis) continue;
    const std::string words = axis.labels[i] + " s";
    const float left = std::min(x - 0.5F * size_of(words).x, area.rect.x1 + ui.px(kRight) - size_of(words).x);
    if (left < free_from) continue;
    write({left, area.rect.y1 + ui.px(2)}, ui.theme().text_dim, words);
    free_from = left + size_of(words).x + ui.px(6);
  }
}

void shade_beyond(const Ui& ui, const PlotArea& area, double limit, bool above, const std::string& words) {
  if (!(limit > area.values.low && limit < area.values.high)) return;
  const Rect& rect = area.rect;
  const float y = std::round(area.y_of(limit));
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled({rect.x0, above ? rect.y0 : y}, {rect.x1, above ? y : rect.y1}, to_u32(ui.theme().danger, 0.13F));
  draw_dashes(ui, {rect.x0, y}, {rect.x1, y}, to_u32(ui.theme().danger, 0.8F), std::max(ui.px(1), 1.0F));
  const FontScope font(ui.fonts().small);
  const float room = above ? y - rect.y0 : rect.y1 - y;
  // Within the shade, where only what is too much can be.
  if (room < ImGui::GetFontSize() || size_of(words).x > 0.5F * rect.width()) return;
  write({rect.x1 - size_of(words).x - ui.px(4), above ? y - ImGui::GetFontSize() : y}, ui.theme().text_dim, words);
}

void draw_spans(const Ui& ui, const PlotSpec& spec, const PlotArea& area) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (const PlotSpan& span : spec.spans) {
    const float x0 = std::max(area.x_of(span.begin_s), area.rect.x0);
    const float x1 = std::min(std::max(area.x_of(span.end_s), x0 + ui.px(2)), area.rect.x1);
    if (x1 <= area.rect.x0 || x0 >= area.rect.x1) continue;
    list.AddRectFilled({x0, area.rect.y0}, {x1, area.rect.y1}, to_u32(span.colour, 0.16F));
    // A bar along the top: the shade alone would be colour alone.
    list.AddRectFilled({x0, area.rect.y0}, {x1, area.rect.y0 + ui.px(3)}, to_u32(span.colour));
  }
}

void draw_cursors(const Ui& ui, const PlotSpec& spec, const PlotArea& area) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Rect& rect = area.rect;
  const auto bar = [&](double t_s, Rgba colour, float half) {
    const float x = std::round(area.x_of(t_s));
    if (x >= rect.x0 && x <= rect.x1) list.AddRectFilled({x - half, rect.y0}, {x + half, rect.y1}, to_u32(colour));
  };
  bar(spec.playhead_s, ui.theme().accent, 1.0F);
  if (spec.cursor_s) bar(*spec.cursor_s, ui.theme().text_dim, 0.5F);
  const double at_s = cursor_of(spec);
  if (at_s < area.begin_s || at_s > area.end_s) return;
  for (const PlotLine& line : spec.lines) {
    const std::optional<double> value = value_near(*line.curve, at_s);
    if (value) draw_mark(ui, line, {area.x_of(at_s), area.y_of(*value)});
  }
}

void draw_inside(const Ui& ui, const PlotSpec& spec, const PlotArea& area) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Rect& rect = area.rect;
  list.PushClipRect({rect.x0, rect.y0}, {rect.x1, rect.y1}, true);
  for (const plot::Band& limit : spec.limits) {
    shade_beyond(ui, area, limit.high, true, limit.label);
    shade_beyond(ui, area, limit.low, false, limit.label);
  }
  draw_spans(ui, spec, area);
  for (const PlotLine& line : spec.lines) {
    if (line.style == LineStyle::kGhost) draw_line(ui, area, line);
  }
  for (const PlotLine& line : spec.lines) {
    if (line.style != LineStyle::kGhost) draw_line(ui, area, line);
  }
  const ImU32 veil = to_u32(ui.theme().panel, 0.72F);
  list.AddRectFilled({rect.x0, rect.y0}, {area.x_of(spec.gate_in_s), rect.y1}, veil);
  list.AddRectFilled({area.x_of(spec.gate_out_s), rect.y0}, {rect.x1, rect.y1}, veil);
  draw_cursors(ui, spec, area);
  list.PopClipRect();
}

void take_wheel(const PlotArea& area, PlotActs& acts) {
  const ImGuiIO& io = ImGui::GetIO();
  const double span_s = area.end_s - area.begin_s;
  if (io.MouseWheel != 0.0F && io.KeyShift) {
    acts.pan_s -= 0.1 * span_s * static_cast<double>(io.MouseWheel);
  } else if (io.MouseWheel != 0.0F) {
    acts.zoom = std::pow(0.85, static_cast<double>(io.MouseWheel));
    acts.zoom_at_s = area.time_at(io.MousePos.x);
  }
  acts.pan_s -= 0.1 * span_s * static_cast<double>(io.MouseWheelH);
}

void take_mouse(Ui& ui, const PlotSpec& spec, const PlotArea& area, bool hovered, PlotActs& acts) {
  const ImGuiIO& io = ImGui::GetIO();
  const bool inside = io.MousePos.x >= area.rect.x0 && io.MousePos.x <= area.rect.x1;
  if (hovered) {
    take_wheel(area, acts);
    if (inside) acts.cursor_s = area.time_at(io.MousePos.x);
  }
  for (const PlotSpan& span : spec.spans) {
    if (acts.cursor_s && *acts.cursor_s >= span.begin_s && *acts.cursor_s <= span.end_s) ui.set_hint(span.words);
  }
  if (!ImGui::IsItemActive()) return;
  if (io.MouseDown[0]) {
    acts.seek_s = area.time_at(std::clamp(io.MousePos.x, area.rect.x0, area.rect.x1));
  } else {
    acts.pan_s -= (area.end_s - area.begin_s) * static_cast<double>(io.MouseDelta.x / area.rect.width());
  }
}

}  // namespace

float least_plot_height(const Ui& ui, bool time_axis) {
  return ui.px(kLegend) + ui.px(kLeastArea) + (time_axis ? ui.px(kTimes) : ui.px(kBelow));
}

Rgba arm_colour(const Theme& theme, int arm) {
  // The accent of high contrast is the yellow of its warnings.
  if (arm == 0) return theme.outlined ? Rgba{120, 200, 255, 255} : theme.accent;
  return theme.warning;
}

PlotActs plot(Ui& ui, const PlotSpec& spec) {
  const ImVec2 size{std::max(ImGui::GetContentRegionAvail().x, ui.px(kLeft + kRight + 8.0F)), spec.height};
  ImGui::InvisibleButton(
      std::string(spec.label).c_str(), size,
      ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight | ImGuiButtonFlags_MouseButtonMiddle);
  const bool hovered = ImGui::IsItemHovered();
  constexpr std::string_view kHelp = "Click to seek, wheel or up and down to zoom, right drag to shift";
  if (hovered) {
    ui.take_wheel();
    ui.set_hint(kHelp);
  }
  const Rect rect = item_rect();
  const PlotArea area = area_of(ui, spec, rect);
  PlotActs acts;
  take_mouse(ui, spec, area, hovered, acts);
  note_rect(ui, "plot", spec.label, read_out(spec), rect, {.help = kHelp});
  if (ui.focus().is_on(ui.items().items().back())) {
    const int step = (ui.input().pressed(Key::kUp) ? 1 : 0) - (ui.input().pressed(Key::kDown) ? 1 : 0);
    if (step != 0) acts.zoom = std::pow(0.7, step);
    if (step != 0) acts.zoom_at_s = spec.playhead_s;
  }
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.PushClipRect({rect.x0, rect.y0}, {rect.x1, rect.y1}, true);
  list.AddRectFilled({area.rect.x0, area.rect.y0}, {area.rect.x1, area.rect.y1}, to_u32(ui.theme().header));
  draw_legend(ui, spec, rect);
  draw_value_axis(ui, area);
  draw_time_axis(ui, spec, area);
  draw_inside(ui, spec, area);
  list.AddRect({area.rect.x0, area.rect.y0}, {area.rect.x1, area.rect.y1}, to_u32(ui.theme().line));
  list.PopClipRect();
  return acts;
}

}  // namespace trocar::ui
