#include "ui/panels/rollout_axes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "engine/figure/outcome_colours.h"
#include "ui/format.h"
#include "ui/icons.h"
#include "ui/panels/rollout_parts.h"

namespace trocar::ui {
namespace {

using learning::RolloutMeasure;

/// All but the start: a cell has no more and less.
constexpr std::size_t kAxisCount = learning::kRolloutMeasures - 1;
/// More lines than these would be one area.
constexpr std::size_t kMostLines = 300;
/// Pixels at 100 %: what lies so near to the end of a drag is meant, too.
constexpr float kNear = 4.0F;
/// Half as wide as what shows a range, which a click on it lets go.
constexpr float kHandle = 5.0F;

RolloutMeasure on_axis(std::size_t place) {
  return static_cast<RolloutMeasure>(place + 1);
}

float height_of(const Rect& line, double low, double high, double value) {
  if (high <= low) return line.centre_y();
  return line.y1 - static_cast<float>((value - low) / (high - low)) * line.height();
}

double value_at(const Rect& line, double low, double high, float y) {
  if (line.height() <= 0.0F) return low;
  return low + static_cast<double>((line.y1 - y) / line.height()) * (high - low);
}

std::string end_of_axis(RolloutMeasure measure, double value) {
  if (measure == RolloutMeasure::kEnd) return end_sign(static_cast<learning::RolloutEnd>(std::lround(value)));
  if (measure == RolloutMeasure::kDivergence) return value < 0.0 ? "never" : number(value);
  const std::string words = measure_words(measure, value);
  return words.substr(0, words.find(' '));
}

float distance_to(const std::vector<ImVec2>& line, ImVec2 mouse) {
  float least = std::numeric_limits<float>::infinity();
  for (std::size_t i = 1; i < line.size(); ++i) {
    const ImVec2 a = line[i - 1];
    const ImVec2 along{line[i].x - a.x, line[i].y - a.y};
    const float length2 = std::max(along.x * along.x + along.y * along.y, 1e-6F);
    const float t = std::clamp(((mouse.x - a.x) * along.x + (mouse.y - a.y) * along.y) / length2, 0.0F, 1.0F);
    least = std::min(least, std::hypot(a.x + t * along.x - mouse.x, a.y + t * along.y - mouse.y));
  }
  return least;
}

/// From the least to the most of the values that a range holds.
std::string held_words(const RolloutBrush& brush, RolloutMeasure measure, const RolloutBrush::Range& range) {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const double value : brush.values(measure)) {
    if (!(value >= range[0] && value <= range[1])) continue;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  if (low > high) return "none";
  return measure_words(measure, low) + " to " + measure_words(measure, high);
}

}  // namespace

void RolloutAxes::take_mouse(Ui& ui, RolloutBrush& brush, RolloutMeasure measure, const Ends& ends, const Rect& line) {
  const float near = ui.px(kNear);
  const float y = ImGui::GetIO().MousePos.y;
  if (ImGui::IsItemActivated()) pressed_y_ = y;
  const float moved = std::abs(y - pressed_y_);
  if (ImGui::IsItemActive() && moved >= near) {
    const double low = value_at(line, ends.low, ends.high, std::max(y, pressed_y_) + near);
    const double high = value_at(line, ends.low, ends.high, std::min(y, pressed_y_) - near);
    brush.set(measure, RolloutBrush::Range{low, high});
  }
  if (ImGui::IsItemDeactivated() && moved < near) clicked_ = measure;
}

void RolloutAxes::axis(Ui& ui, RolloutBrush& brush, std::size_t place, ImVec2 size) {
  const RolloutMeasure measure = on_axis(place);
  const std::string& name = measure_names()[place + 1];
  Ends ends{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (const double value : brush.values(measure)) {
    if (!std::isfinite(value)) continue;
    ends.low = std::min(ends.low, value);
    ends.high = std::max(ends.high, value);
  }
  const bool known = ends.low <= ends.high;
  if (!known) ends = {};
  std::string words = known ? measure_words(measure, ends.low) + " to " + measure_words(measure, ends.high) : "unknown";
  if (const auto& range = brush.range(measure)) words += ", brushed " + held_words(brush, measure, *range);
  chart_area(
      ui, name, size, words,
      {.help = name + ": " + words +
               "; drag along the axis to keep what lies there, click to let go; click a line to select its rollout"});
  const Rect rect = item_rect();
  const float head = 2.0F * ui.fonts().small->FontSize + ui.px(4);
  const float x = rect.centre_x();
  const Rect line{x, rect.y0 + head + ui.fonts().small->FontSize, x, rect.y1 - ui.fonts().small->FontSize - ui.px(4)};
  if (known) take_mouse(ui, brush, measure, ends, line);
  lines_.push_back(line);
  ends_.push_back(ends);
}

std::vector<std::size_t> RolloutAxes::drawn_of(const WorkbenchState& state) const {
  const std::size_t listed = state.insight->listed->size();
  std::vector<std::size_t> places(std::min(kMostLines, listed));
  for (std::size_t n = 0; n < places.size(); ++n) places[n] = n * listed / places.size();
  return places;
}

RolloutAxes::Line RolloutAxes::line_of(const RolloutBrush& brush, std::size_t place) const {
  Line points;
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    const double value = brush.values(on_axis(axis))[place];
    if (!std::isfinite(value)) continue;
    points.push_back({lines_[axis].x0, height_of(lines_[axis], ends_[axis].low, ends_[axis].high, value)});
  }
  return points;
}

std::optional<std::size_t> RolloutAxes::pointed(const Ui& ui, const WorkbenchState& state,
                                                const RolloutBrush& brush) const {
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  for (const bool kept : {true, false}) {
    float nearest = ui.px(kNear);
    std::optional<std::size_t> found;
    for (const std::size_t place : drawn_of(state)) {
      if (brush.keeps(place) != kept) continue;
      const float away = distance_to(line_of(brush, place), mouse);
      if (away > nearest || (away == nearest && found)) continue;
      nearest = away;
      found = place;
    }
    if (found) return found;
  }
  return std::nullopt;
}

void RolloutAxes::take_click(Ui& ui, const WorkbenchState& state, RolloutBrush& brush, Requests& requests) {
  const std::size_t axis = static_cast<std::size_t>(*clicked_) - 1;
  const auto& range = brush.range(*clicked_);
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  if (range && std::abs(mouse.x - lines_[axis].x0) <= ui.px(kHandle)) {
    brush.set(*clicked_, std::nullopt);
  } else if (const auto place = pointed(ui, state, brush)) {
    select_start(state, (*state.insight->listed)[*place].start, requests);
  } else {
    brush.set(*clicked_, std::nullopt);
  }
}

void RolloutAxes::draw_lines(Ui& ui, const WorkbenchState& state, const RolloutBrush& brush) const {
  const std::vector<learning::Rollout>& listed = *state.insight->listed;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const auto draw_line = [&](std::size_t place, ImU32 colour, float width) {
    const Line points = line_of(brush, place);
    if (points.size() > 1) list.AddPolyline(points.data(), static_cast<int>(points.size()), colour, 0, ui.px(width));
  };
  for (const bool kept : {false, true}) {
    for (const std::size_t place : drawn_of(state)) {
      if (brush.keeps(place) != kept) continue;
      const Rgba colour = kept ? figure::outcome_colour(listed[place].end) : ui.theme().text_disabled;
      draw_line(place, to_u32(colour, kept ? 0.6F : 0.15F), 1.0F);
    }
  }
  for (std::size_t i = 0; i < listed.size(); ++i) {
    if (state.rollouts.selected == listed[i].start) draw_line(i, to_u32(ui.theme().text), 2.5F);
  }
}

void RolloutAxes::draw_axes(Ui& ui, const RolloutBrush& brush) const {
  const FontScope font(ui.fonts().small);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float size = ImGui::GetFontSize();
  const float apart = lines_.size() > 1 ? lines_[1].x0 - lines_[0].x0 : ui.px(40);
  const float left = lines_.front().x0 - 0.5F * apart + ui.px(2);
  const float right = lines_.back().x0 + 0.5F * apart - ui.px(2);
  const auto middle = [&](float x, float y, const std::string& words, Rgba colour, float room) {
    const std::string shown = fitted(words, room);
    const float width = ImGui::CalcTextSize(shown.c_str()).x;
    const float at = std::max(std::min(x - 0.5F * width, right - width), left);
    list.AddText({std::round(at), y}, to_u32(colour), shown.c_str());
  };
  for (std::size_t place = 0; place < lines_.size(); ++place) {
    const Rect& line = lines_[place];
    const RolloutMeasure measure = on_axis(place);
    const float width = std::max(ui.px(1), 1.0F);
    list.AddRectFilled({line.x0 - 0.5F * width, line.y0}, {line.x0 + 0.5F * width, line.y1},
                       to_u32(ui.theme().text_dim));
    // Names stand in two rows, so that each has the room of two axes.
    const float name_y = line.y0 - (place % 2 == 0 ? 3.0F : 2.0F) * size - ui.px(3);
    const auto& range = brush.range(measure);
    middle(line.x0, name_y, measure_names()[place + 1], range ? ui.theme().accent : ui.theme().text, 1.9F * apart);
    middle(line.x0, line.y0 - size - ui.px(1), end_of_axis(measure, ends_[place].high), ui.theme().text_dim,
           apart - ui.px(2));
    middle(line.x0, line.y1 + ui.px(2), end_of_axis(measure, ends_[place].low), ui.theme().text_dim, apart - ui.px(2));
    if (!range) continue;
    const float top = std::max(height_of(line, ends_[place].low, ends_[place].high, (*range)[1]), line.y0);
    const float bottom = std::min(height_of(line, ends_[place].low, ends_[place].high, (*range)[0]), line.y1);
    const float half = ui.px(kHandle);
    list.AddRectFilled({line.x0 - half, top}, {line.x0 + half, bottom}, to_u32(ui.theme().accent, 0.35F));
    list.AddRect({line.x0 - half, top}, {line.x0 + half, bottom}, to_u32(ui.theme().accent), 0.0F, 0, ui.px(1.5F));
  }
}

void RolloutAxes::draw_all(Ui& ui, const WorkbenchState& state, RolloutBrush& brush, ImVec2 each, Requests& requests) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::GetWindowDrawList()->AddRectFilled(at, {at.x + each.x * static_cast<float>(kAxisCount), at.y + each.y},
                                            to_u32(ui.theme().ground), ui.px(3));
  for (std::size_t place = 0; place < kAxisCount; ++place) {
    if (place > 0) ImGui::SameLine(0.0F, 0.0F);
    axis(ui, brush, place, each);
  }
  if (clicked_) take_click(ui, state, brush, requests);
  clicked_.reset();
  draw_lines(ui, state, brush);
  draw_axes(ui, brush);
}

void RolloutAxes::draw(Ui& ui, const WorkbenchState& state, RolloutBrush& brush, Requests& requests) {
  const Scope scope(ui, "Measures");
  heading(ui, "All measures");
  lines_.clear();
  ends_.clear();
  const float room = ImGui::GetContentRegionAvail().x;
  const ImVec2 each{std::max(std::floor(room / static_cast<float>(kAxisCount)), ui.px(24)),
                    ui.px(130) + 4.0F * ui.fonts().small->FontSize};
  if (each.x * static_cast<float>(kAxisCount) <= room) {
    draw_all(ui, state, brush, each, requests);
  } else {
    // No axis is too narrow for a finger: they scroll sideways.
    ImGui::SetNextWindowContentSize({each.x * static_cast<float>(kAxisCount), 0.0F});
    ImGui::BeginChild("axes", {0.0F, each.y + ImGui::GetStyle().ScrollbarSize}, false,
                      ImGuiWindowFlags_HorizontalScrollbar);
    draw_all(ui, state, brush, each, requests);
    ImGui::EndChild();
  }
  if (!brush.any())
    small_text(ui, "Drag along an axis to keep the rollouts in that range; click a line to select its rollout",
               ui.theme().text_dim);
  draw_brushed(ui, brush);
}

void draw_brushed(Ui& ui, RolloutBrush& brush) {
  if (!brush.any()) return;
  const std::string words = fmt::format("{} of {} brushed", count(static_cast<std::int64_t>(brush.kept())),
                                        count(static_cast<std::int64_t>(brush.values(RolloutMeasure::kStart).size())));
  ImGui::AlignTextToFramePadding();
  text(ui, words);
  note_item(ui, "text", "Brushed", words, {});
  flow(button_width(ui, "Show all", icon::kCross), ui.px(8));
  if (button(ui, "Show all", {.icon = icon::kCross, .help = "Let go of all ranges", .style = ButtonStyle::kQuiet})) {
    brush.clear();
  }
}

}  // namespace trocar::ui
