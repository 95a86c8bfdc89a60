#include "ui/panels/timeline_lanes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "engine/spatial/units.h"
#include "ui/format.h"

namespace trocar::ui {
namespace {

constexpr Rgba kInk{16, 18, 21, 255};  // On the light colours of segments and authorities.

class Lanes {
 public:
  Lanes(Ui& ui, const LaneLayout& layout) : ui_(ui), layout_(layout), y_(layout.lanes.y0) {}

  bool begin(std::string_view name, float height);
  void block(double begin_s, double end_s, Rgba colour, std::string_view words, std::string_view short_words = {});
  void thin_row(const std::vector<Run>& runs, int row, int rows, Rgba colour) const;
  void curve(const std::vector<Extent>& extents, float low, float high, Rgba colour) const;
  void end();

 private:
  ImDrawList& list() const { return *ImGui::GetWindowDrawList(); }
  Ui& ui_;
  const LaneLayout& layout_;
  float y_;
  float height_ = 0.0F;
};

bool Lanes::begin(std::string_view name, float height) {
  if (y_ + height > layout_.lanes.y1) return false;
  height_ = height;
  const FontScope font(ui_.fonts().small);
  const float text = ImGui::GetFontSize();
  list().AddText({layout_.names.x0, std::round(y_ + 0.5F * (height - text))}, to_u32(ui_.theme().text_dim), name.data(),
                 name.data() + name.size());
  return true;
}

void Lanes::end() {
  y_ += height_;
  list().AddRectFilled({layout_.names.x0, y_}, {layout_.lanes.x1, y_ + 1.0F}, to_u32(ui_.theme().line, 0.7F));
  y_ += 1.0F;
}

void Lanes::block(double begin_s, double end_s, Rgba colour, std::string_view words, std::string_view short_words) {
  const float x0 = std::max(layout_.x_of(begin_s), layout_.lanes.x0);
  const float x1 = std::min(layout_.x_of(end_s), layout_.lanes.x1);
  if (x1 <= layout_.lanes.x0 || x0 >= layout_.lanes.x1) return;
  const float y0 = y_ + ui_.px(3);
  const float y1 = y_ + height_ - ui_.px(3);
  list().AddRectFilled({x0, y0}, {std::max(x1 - 1.0F, x0 + 1.0F), y1}, to_u32(colour), ui_.px(3));
  const FontScope font(ui_.fonts().small);
  const auto size_of = [](std::string_view text) {
    return ImGui::CalcTextSize(text.data(), text.data() + text.size());
  };
  if (size_of(words).x + ui_.px(8) > x1 - x0) words = short_words;
  const ImVec2 size = size_of(words);
  if (words.empty() || size.x + ui_.px(4) > x1 - x0) return;
  const float x = x0 + ui_.px(6) + size.x > x1 - ui_.px(6) ? x0 + 0.5F * (x1 - x0 - size.x) : x0 + ui_.px(6);
  list().AddText({std::round(x), std::round(0.5F * (y0 + y1 - size.y))}, to_u32(kInk), words.data(),
                 words.data() + words.size());
}

void Lanes::thin_row(const std::vector<Run>& runs, int row, int rows, Rgba colour) const {
  const float each = (height_ - ui_.px(4)) / static_cast<float>(rows);
  const float y0 = y_ + ui_.px(2) + each * static_cast<float>(row);
  for (const Run& run : runs) {
    const float x0 = std::max(layout_.x_of(run.begin_s), layout_.lanes.x0);
    const float x1 = std::min(layout_.x_of(run.end_s), layout_.lanes.x1);
    if (x1 <= layout_.lanes.x0 || x0 >= layout_.lanes.x1) continue;
    list().AddRectFilled({x0, y0 + 1.0F}, {std::max(x1, x0 + 2.0F), y0 + each - 1.0F}, to_u32(colour), ui_.px(2));
  }
}

void Lanes::curve(const std::vector<Extent>& extents, float low, float high, Rgba colour) const {
  const float top = y_ + ui_.px(3);
  const float bottom = y_ + height_ - ui_.px(3);
  const auto y_of = [&](float value) { return bottom - (value - low) / (high - low) * (bottom - top); };
  const float step = layout_.lanes.width() / static_cast<float>(extents.size());
  float last = bottom;
  for (std::size_t i = 0; i < extents.size(); ++i) {
    const float x0 = std::round(layout_.lanes.x0 + step * static_cast<float>(i));
    const float x1 = std::round(layout_.lanes.x0 + step * static_cast<float>(i + 1));
    if (extents[i].low > extents[i].high) continue;
    const float y0 = std::round(y_of(extents[i].high));
    const float y1 = std::max(std::round(y_of(extents[i].low)), y0 + ui_.px(2));
    list().AddRectFilled({x0, y0}, {x1, bottom}, to_u32(colour, 0.22F));
    // The line bridges the step from the last column, so that it is whole where the jaw moves fast.
    list().AddRectFilled({x0, std::min(y0, last)}, {x1, std::max(y1, std::min(last, y1))}, to_u32(colour));
    last = y0;
  }
}

void draw_segments(Lanes& lanes, const Ui& ui, const demonstration::Demonstration& shown) {
  if (!lanes.begin("Segments", ui.px(24))) return;
  for (const demonstration::SegmentSpan& span : shown.segments) {
    const std::string letter(1, demonstration::letter(span.label));
    const std::string words = fmt::format("{}  {}", letter, seconds(span.end_s - span.begin_s));
    lanes.block(span.begin_s, span.end_s, segment_colour(span.label), words, letter);
  }
  lanes.end();
}

}  // namespace

LaneLayout lay_out(const Ui& ui, const Rect& area, const TimeRange& range) {
  const float names = ui.px(78);
  const float ruler = ui.px(30);
  LaneLayout layout;
  layout.names = {area.x0 + ui.px(10), area.y0 + ruler, area.x0 + names, area.y1};
  layout.ruler = {area.x0 + names, area.y0, area.x1 - ui.px(10), area.y0 + ruler};
  layout.lanes = {area.x0 + names, area.y0 + ruler, area.x1 - ui.px(10), area.y1};
  layout.range = range;
  return layout;
}

void draw_ruler(Ui& ui, const LaneLayout& layout) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const FontScope font(ui.fonts().small);
  const double step = ruler_step(layout.range, layout.lanes.width(), ui.px(64));
  const int digits = step >= 1.0 ? 0 : step >= 0.1 ? 1 : step >= 0.01 ? 2 : 3;
  const double minor = step / 5.0;
  const auto first = static_cast<std::int64_t>(std::ceil(layout.range.begin_s / minor));
  for (std::int64_t i = first; static_cast<double>(i) * minor <= layout.range.end_s; ++i) {
    const double t_s = static_cast<double>(i) * minor;
    if (t_s < 0.0) continue;
    const float x = std::round(layout.x_of(t_s));
    const bool major = i % 5 == 0;
    const float tall = major ? ui.px(8) : ui.px(4);
    list.AddRectFilled({x, layout.ruler.y1 - tall}, {x + 1.0F, layout.ruler.y1}, to_u32(ui.theme().text_disabled));
    if (!major) continue;
    list.AddRectFilled({x, layout.lanes.y0}, {x + 1.0F, layout.lanes.y1}, to_u32(ui.theme().line, 0.45F));
    const std::string words = fmt::format("{:.{}f} s", t_s, digits);
    const ImVec2 size = ImGui::CalcTextSize(words.c_str());
    if (x + size.x < layout.ruler.x1)
      list.AddText({x + ui.px(4), layout.ruler.y0 + ui.px(1)}, to_u32(ui.theme().text_dim), words.c_str());
  }
  list.AddRectFilled({layout.names.x0, layout.ruler.y1}, {layout.lanes.x1, layout.ruler.y1 + 1.0F},
                     to_u32(ui.theme().line));
}

void draw_lanes(Ui& ui, const LaneLayout& layout, const demonstration::Demonstration& shown, const LaneData& data) {
  Lanes lanes(ui, layout);
  draw_segments(lanes, ui, shown);
  if (lanes.begin("Authority", ui.px(21))) {
    for (const Run& run : data.authority()) {
      const auto authority = static_cast<demonstration::Authority>(run.state - 1);
      lanes.block(run.begin_s, run.end_s, authority_colour(authority), demonstration::to_string(authority));
    }
    lanes.end();
  }
  const Rgba left = mix(ui.theme().accent, ui.theme().text, 0.1F);
  const Rgba right = mix(ui.theme().warning, ui.theme().text, 0.1F);
  if (lanes.begin("Jaw L", ui.px(27))) {
    lanes.curve(data.jaw(0), data.jaw_low(), data.jaw_high(), left);
    lanes.end();
  }
  if (lanes.begin("Jaw R", ui.px(27))) {
    lanes.curve(data.jaw(1), data.jaw_low(), data.jaw_high(), right);
    lanes.end();
  }
  if (lanes.begin("Holds L, R", ui.px(17))) {
    lanes.thin_row(data.flag(demonstration::kLeftHolds), 0, 2, left);
    lanes.thin_row(data.flag(demonstration::kRightHolds), 1, 2, right);
    lanes.end();
  }
  if (lanes.begin("Pedals", ui.px(17))) {
    lanes.thin_row(data.flag(demonstration::kAgentPedal), 0, 2, ui.theme().good);
    lanes.thin_row(data.flag(demonstration::kClutchPedal), 1, 2, ui.theme().text_dim);
    lanes.end();
  }
}

}  // namespace trocar::ui
