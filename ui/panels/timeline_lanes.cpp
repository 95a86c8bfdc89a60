#include "ui/panels/timeline_lanes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "engine/spatial/units.h"
#include "ui/format.h"

namespace trocar::ui {
namespace {

constexpr float kRulerHeight = 30.0F;  // All at 100 %.
constexpr float kSegmentsHeight = 24.0F;
constexpr float kAuthorityHeight = 21.0F;
constexpr float kJawHeight = 27.0F;
constexpr float kFlagsHeight = 17.0F;

constexpr Rgba kInk{16, 18, 21, 255};  // On the light colours of segments and authorities.

class Lanes {
 public:
  Lanes(Ui& ui, const LaneLayout& layout) : ui_(ui), layout_(layout), y_(layout.lanes.y0) {}

  void begin(std::string_view name, float height);
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

void Lanes::begin(std::string_view name, float height) {
  height_ = height;
  const FontScope font(ui_.fonts().small);
  const float text = ImGui::GetFontSize();
  list().AddText({layout_.names.x0, std::round(y_ + 0.5F * (height - text))}, to_u32(ui_.theme().text_dim), name.data(),
                 name.data() + name.size());
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
  const float w0 = std::max(x0, layout_.x_of(layout_.gate_in_s));
  const float w1 = std::min(x1, layout_.x_of(layout_.gate_out_s));
  if (size_of(words).x + ui_.px(8) > w1 - w0) words = short_words;
  const ImVec2 size = size_of(words);
  if (words.empty() || size.x + 2.0F > w1 - w0) return;
  const float x = w0 + ui_.px(6) + size.x > w1 - ui_.px(6) ? w0 + 0.5F * (w1 - w0 - size.x) : w0 + ui_.px(6);
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

void draw_segments(Lanes& lanes, Ui& ui, const LaneLayout& layout, const demonstration::Demonstration& shown) {
  UniqueNames unique;
  lanes.begin("Segments", ui.px(kSegmentsHeight));
  for (const demonstration::SegmentSpan& span : shown.segments) {
    const std::string letter(1, demonstration::letter(span.label));
    const double begin_s = std::max(span.begin_s, layout.gate_in_s);
    const double end_s = std::min(span.end_s, layout.gate_out_s);
    const std::string length = seconds(std::max(end_s - begin_s, 0.0));
    lanes.block(span.begin_s, span.end_s, segment_colour(span.label), fmt::format("{}  {}", letter, length), letter);
    if (end_s <= begin_s) continue;
    const float x0 = std::clamp(layout.x_of(begin_s), layout.lanes.x0, layout.lanes.x1);
    const float x1 = std::clamp(layout.x_of(end_s), layout.lanes.x0, layout.lanes.x1);
    const Rect rect{x0, layout.lanes.y0, x1, layout.lanes.y0 + ui.px(kSegmentsHeight)};
    note_rect(ui, "text", unique("Segment " + letter), length, rect);
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    if (!rect.contains(mouse.x, mouse.y)) continue;
    // The segment may be too narrow for its letter.
    ui.set_hint(fmt::format("Segment {}: {:.2f}–{:.2f} s, {} long", letter, begin_s, end_s, length));
  }
  lanes.end();
}

}  // namespace

float lanes_height(const Ui& ui) {
  float height = ui.px(kRulerHeight);
  for (const float lane : {kSegmentsHeight, kAuthorityHeight, kJawHeight, kJawHeight, kFlagsHeight, kFlagsHeight}) {
    height += ui.px(lane) + 1.0F;
  }
  return height;
}

LaneLayout lay_out(const Ui& ui, const Rect& area, const TimeRange& range) {
  const float names = ui.px(78);
  const float ruler = ui.px(kRulerHeight);
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
  draw_segments(lanes, ui, layout, shown);
  lanes.begin("Authority", ui.px(kAuthorityHeight));
  for (const Run& run : data.authority()) {
    const auto authority = static_cast<demonstration::Authority>(run.state - 1);
    lanes.block(run.begin_s, run.end_s, authority_colour(authority), demonstration::to_string(authority));
  }
  lanes.end();
  const Rgba left = mix(ui.theme().accent, ui.theme().text, 0.1F);
  const Rgba right = mix(ui.theme().warning, ui.theme().text, 0.1F);
  lanes.begin("Jaw L", ui.px(kJawHeight));
  lanes.curve(data.jaw(0), data.jaw_low(), data.jaw_high(), left);
  lanes.end();
  lanes.begin("Jaw R", ui.px(kJawHeight));
  lanes.curve(data.jaw(1), data.jaw_low(), data.jaw_high(), right);
  lanes.end();
  lanes.begin("Holds L, R", ui.px(kFlagsHeight));
  lanes.thin_row(data.flag(demonstration::kLeftHolds), 0, 2, left);
  lanes.thin_row(data.flag(demonstration::kRightHolds), 1, 2, right);
  lanes.end();
  lanes.begin("Pedals", ui.px(kFlagsHeight));
  lanes.thin_row(data.flag(demonstration::kAgentPedal), 0, 2, ui.theme().good);
  lanes.thin_row(data.flag(demonstration::kClutchPedal), 1, 2, ui.theme().text_dim);
  lanes.end();
}

}  // namespace trocar::ui
