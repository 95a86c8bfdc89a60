// The timeline's ruler: seconds, frames of a film, or steps on the lattice.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "ui/panels/timeline_lanes.h"

namespace trocar::ui {
namespace {

constexpr double kFrame_s = 1.0 / 30.0;  // As `transport.frame_forward`.

class Ruler {
 public:
  Ruler(Ui& ui, const LaneLayout& layout) : ui_(ui), layout_(layout) {}

  void tick(double t_s, bool major) const {
    const float x = std::round(layout_.x_of(t_s));
    const float tall = major ? ui_.px(8) : ui_.px(4);
    list().AddRectFilled({x, layout_.ruler.y1 - tall}, {x + 1.0F, layout_.ruler.y1}, to_u32(ui_.theme().text_disabled));
    if (major)
      list().AddRectFilled({x, layout_.lanes.y0}, {x + 1.0F, layout_.lanes.y1}, to_u32(ui_.theme().line, 0.45F));
  }

  void words(double t_s, const std::string& words) const {
    const float x = std::round(layout_.x_of(t_s));
    const ImVec2 size = ImGui::CalcTextSize(words.c_str());
    if (x + size.x >= layout_.ruler.x1) return;
    list().AddText({x + ui_.px(4), layout_.ruler.y0 + ui_.px(1)}, to_u32(ui_.theme().text_dim), words.c_str());
  }

 private:
  static ImDrawList& list() { return *ImGui::GetWindowDrawList(); }
  Ui& ui_;
  const LaneLayout& layout_;
};

/// Every fifth mark has its words; marks are whole multiples of `each_s / 5`.
template <typename Words>
void draw_even(const Ruler& ruler, const LaneLayout& layout, double each_s, int parts, Words words) {
  const double minor = each_s / parts;
  const auto first = static_cast<std::int64_t>(std::ceil(layout.range.begin_s / minor));
  for (std::int64_t i = std::max<std::int64_t>(first, 0); static_cast<double>(i) * minor <= layout.range.end_s; ++i) {
    const double t_s = static_cast<double>(i) * minor;
    const bool major = i % parts == 0;
    ruler.tick(t_s, major);
    if (major) ruler.words(t_s, words(t_s));
  }
}

void draw_seconds(const Ruler& ruler, const LaneLayout& layout, float least_px) {
  const double step_s = ruler_step(layout.range, layout.lanes.width(), least_px);
  const int digits = step_s >= 1.0 ? 0 : step_s >= 0.1 ? 1 : step_s >= 0.01 ? 2 : 3;
  draw_even(ruler, layout, step_s, 5, [digits](double t_s) { return fmt::format("{:.{}f} s", t_s, digits); });
}

void draw_frames(const Ruler& ruler, const LaneLayout& layout, float least_px) {
  const TimeRange in_frames{layout.range.begin_s / kFrame_s, layout.range.end_s / kFrame_s};
  const double frames = std::max(ruler_step(in_frames, layout.lanes.width(), least_px), 1.0);
  const int parts = std::fmod(frames, 5.0) == 0.0 ? 5 : static_cast<int>(std::min(frames, 5.0));
  draw_even(ruler, layout, frames * kFrame_s, parts, [](double t_s) { return fmt::format("{:.0f}", t_s / kFrame_s); });
}

// Steps are not even in time: a tool that hurries has them close together, one that rests has none.
void draw_steps(const Ruler& ruler, const LaneLayout& layout, std::span<const double> times, float least_px) {
  const auto begin = std::lower_bound(times.begin(), times.end(), layout.range.begin_s);
  const auto end = std::upper_bound(begin, times.end(), layout.range.end_s);
  float words_until = -1e9F;
  float tick_until = -1e9F;
  for (auto at = begin; at != end; ++at) {
    const float x = layout.x_of(*at);
    if (x < tick_until) continue;
    const auto number = 1 + std::distance(times.begin(), at);
    const bool major = x >= words_until && (number % 5 == 0 || end - begin < 12);
    ruler.tick(*at, major);
    tick_until = x + 3.0F;
    if (!major) continue;
    ruler.words(*at, fmt::format("{}", number));
    words_until = x + least_px;
  }
}

}  // namespace

void draw_ruler(Ui& ui, const LaneLayout& layout, RulerUnit unit, std::span<const double> step_times) {
  const FontScope font(ui.fonts().small);
  const Ruler ruler(ui, layout);
  switch (unit) {
    case RulerUnit::kTime:
      draw_seconds(ruler, layout, ui.px(64));
      break;
    case RulerUnit::kFrame:
      draw_frames(ruler, layout, ui.px(64));
      break;
    case RulerUnit::kGridStep:
      draw_steps(ruler, layout, step_times, ui.px(40));
      break;
  }
  ImGui::GetWindowDrawList()->AddRectFilled({layout.names.x0, layout.ruler.y1},
                                            {layout.lanes.x1, layout.ruler.y1 + 1.0F}, to_u32(ui.theme().line));
}

}  // namespace trocar::ui
