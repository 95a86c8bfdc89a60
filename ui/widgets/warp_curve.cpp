#include "ui/widgets/warp_curve.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "engine/demonstration/time_warp.h"
#include "ui/icons.h"
#include "ui/widgets/plot_lines.h"
#include "ui/widgets/stroke.h"

namespace trocar::ui {
namespace {

using Eigen::Vector2d;

constexpr float kHeight = 150.0F;  // At 100 %, as what follows.
constexpr float kKnotRadius = 5.0F;
constexpr float kKnotReach = 12.0F;
/// Knots come no nearer to each other, in either time.
constexpr double kLeastStep_s = 0.01;
constexpr int kPieces = 96;
constexpr std::string_view kCurveHelp =
    "Old time to the right, new time upwards. Drag a knot, double-click for a new one; up and down shift the chosen "
    "one";

std::string knot_words(const Vector2d& knot) {
  return fmt::format("{:.2f} → {:.2f} s", knot.x(), knot.y());
}

double to_hundredths(double t_s) {
  return std::round(100.0 * t_s) / 100.0;
}

}  // namespace

struct WarpCurve::Ground {
  PlotArea area;
  double begin_s = 0.0;
  double end_s = 0.0;

  ImVec2 at(const Vector2d& knot) const { return {area.x_of(knot.x()), area.y_of(knot.y())}; }
  Vector2d under(ImVec2 mouse) const {
    const double up = static_cast<double>((area.rect.y1 - mouse.y) / area.rect.height());
    return {area.time_at(mouse.x), area.values.low + up * (area.values.high - area.values.low)};
  }
  /// `knot` as near to `wanted` as its neighbours allow; the last one keeps its old time.
  void move(std::vector<Vector2d>& knots, std::size_t knot, const Vector2d& wanted) const {
    const bool last = knot + 1 == knots.size();
    const Vector2d low = knot == 0 ? Vector2d(begin_s, begin_s) : knots[knot - 1];
    const double high_x = last ? end_s : knots[knot + 1].x();
    const double high_y = last ? 1e6 : knots[knot + 1].y();
    const auto between = [](double value, double least, double most) {
      return std::clamp(to_hundredths(value), least + kLeastStep_s,
                        std::max(most - kLeastStep_s, least + kLeastStep_s));
    };
    if (!last) knots[knot].x() = between(wanted.x(), low.x(), high_x);
    knots[knot].y() = between(wanted.y(), low.y(), high_y);
  }
  /// On the curve as it is. Nothing where there is no room.
  std::optional<std::size_t> add(std::vector<Vector2d>& knots, double old_s) const {
    std::vector<Vector2d> all{{begin_s, begin_s}};
    all.insert(all.end(), knots.begin(), knots.end());
    const Vector2d knot(to_hundredths(old_s), to_hundredths(demonstration::MonotoneCurve(all).at(old_s)));
    const auto after = std::find_if(all.begin(), all.end(), [&](const Vector2d& each) { return each.x() > knot.x(); });
    if (after == all.begin() || after == all.end()) return std::nullopt;
    const Vector2d room = (knot - *(after - 1)).cwiseMin(*after - knot);
    if (room.minCoeff() < kLeastStep_s) return std::nullopt;
    const std::ptrdiff_t place = after - all.begin() - 1;
    knots.insert(knots.begin() + place, knot);
    return static_cast<std::size_t>(place);
  }
};

bool WarpCurve::take_mouse(const Ui& ui, const Ground& ground, std::vector<Vector2d>& knots) {
  const ImGuiIO& io = ImGui::GetIO();
  const auto distance = [&](const Vector2d& knot) {
    const ImVec2 at = ground.at(knot);
    return std::hypot(at.x - io.MousePos.x, at.y - io.MousePos.y);
  };
  const auto nearest = std::min_element(
      knots.begin(), knots.end(), [&](const Vector2d& a, const Vector2d& b) { return distance(a) < distance(b); });
  const bool on_knot = distance(*nearest) <= ui.px(kKnotReach);
  if (ImGui::IsItemHovered() && on_knot) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(0) && !on_knot) {
    const auto added = ground.add(knots, ground.under(io.MousePos).x());
    if (added) chosen_ = *added;
    return added.has_value();
  }
  if (ImGui::IsItemActivated() && on_knot) {
    chosen_ = static_cast<std::size_t>(nearest - knots.begin());
    dragging_ = true;
  }
  if (!ImGui::IsItemActive()) dragging_ = false;
  if (!dragging_ || (io.MouseDelta.x == 0.0F && io.MouseDelta.y == 0.0F)) return false;
  const std::vector<Vector2d> before = knots;
  ground.move(knots, chosen_, ground.under(io.MousePos));
  return knots != before;
}

bool WarpCurve::take_keys(Ui& ui, const Ground& ground, std::vector<Vector2d>& knots) const {
  if (!ui.focus().is_on(ui.items().items().back())) return false;
  const int step = (ui.input().pressed(Key::kUp) ? 1 : 0) - (ui.input().pressed(Key::kDown) ? 1 : 0);
  if (step == 0) return false;
  const double by_s = std::max(to_hundredths(0.02 * (ground.end_s - ground.begin_s)), kLeastStep_s);
  const std::vector<Vector2d> before = knots;
  ground.move(knots, chosen_, knots[chosen_] + Vector2d(0.0, step * by_s));
  return knots != before;
}

bool WarpCurve::draw_buttons(Ui& ui, const Ground& ground, std::vector<Vector2d>& knots) {
  bool changed = false;
  const std::string chosen = fmt::format("Knot {} of {}", chosen_ + 1, knots.size());
  if (toggle_shown_as(ui, "Next knot", chosen, false, {.help = "Choose the next knot"})) {
    chosen_ = (chosen_ + 1) % knots.size();
  }
  flow(button_width(ui, "Add knot", icon::kPlus), ui.px(6));
  if (button(ui, "Add knot", {.icon = icon::kPlus, .help = "In the middle before the chosen one"})) {
    const double low_s = chosen_ == 0 ? ground.begin_s : knots[chosen_ - 1].x();
    const auto added = ground.add(knots, 0.5 * (low_s + knots[chosen_].x()));
    if (added) chosen_ = *added;
    changed = added.has_value();
  }
  const bool last = chosen_ + 1 == knots.size();
  flow(button_width(ui, "Remove knot", icon::kTrash), ui.px(6));
  if (button(ui, "Remove knot",
             {.icon = icon::kTrash, .help = "Take the chosen one away", .reason = last ? "The end stays" : ""})) {
    knots.erase(knots.begin() + static_cast<std::ptrdiff_t>(chosen_));
    changed = true;
  }
  chosen_ = std::min(chosen_, knots.size() - 1);
  return changed;
}

bool WarpCurve::draw(Ui& ui, std::string_view label, double begin_s, double end_s, std::vector<Vector2d>& knots) {
  const Scope scope(ui, label);
  chosen_ = std::min(chosen_, knots.size() - 1);
  if (!dragging_) high_s_ = std::max(end_s + 0.25 * (end_s - begin_s), begin_s + 1.1 * (knots.back().y() - begin_s));
  const ImVec2 size{std::max(ImGui::GetContentRegionAvail().x, ui.px(60)), ui.px(kHeight)};
  ImGui::InvisibleButton("curve", size);
  const Rect rect = item_rect();
  if (ImGui::IsItemHovered()) ui.set_hint(kCurveHelp);
  const float edge = ui.px(kKnotRadius + 3.0F);
  const Rect inner{rect.x0 + edge, rect.y0 + edge, rect.x1 - edge, rect.y1 - edge};
  const Ground ground{{inner, begin_s, end_s, {begin_s, high_s_}}, begin_s, end_s};
  bool changed = take_mouse(ui, ground, knots);
  note_rect(ui, "plot", "Time warp", knot_words(knots[chosen_]), rect, {.help = kCurveHelp});
  changed |= take_keys(ui, ground, knots);

  const Theme& theme = ui.theme();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled({rect.x0, rect.y0}, {rect.x1, rect.y1}, to_u32(theme.header));
  list.AddRect({rect.x0, rect.y0}, {rect.x1, rect.y1}, to_u32(theme.line));
  // As time was, for comparison.
  draw_dashes(ui, ground.at({begin_s, begin_s}), ground.at({end_s, end_s}), to_u32(theme.text_dim, 0.7F),
              std::max(ui.px(1), 1.0F));
  std::vector<Vector2d> all{{begin_s, begin_s}};
  all.insert(all.end(), knots.begin(), knots.end());
  const demonstration::MonotoneCurve curve(all);
  std::array<ImVec2, kPieces + 1> points;
  for (int i = 0; i <= kPieces; ++i) {
    const double old_s = begin_s + (end_s - begin_s) * i / kPieces;
    points[static_cast<std::size_t>(i)] = ground.at({old_s, curve.at(old_s)});
  }
  stroke(list, points, to_u32(theme.accent), ui.px(2));
  for (std::size_t i = 0; i < knots.size(); ++i) {
    const ImVec2 at = ground.at(knots[i]);
    const float radius = ui.px(kKnotRadius);
    list.AddCircleFilled(at, radius, to_u32(i == chosen_ ? theme.accent : theme.panel));
    list.AddCircle(at, radius, to_u32(theme.text), 0, std::max(ui.px(1.5F), 1.0F));
    note_rect(ui, "mark", fmt::format("Knot {}", i + 1), knot_words(knots[i]),
              {at.x - radius, at.y - radius, at.x + radius, at.y + radius});
  }
  small_text(
      ui, fmt::format("{} s long, was {}", to_hundredths(knots.back().y() - begin_s), to_hundredths(end_s - begin_s)),
      theme.text_dim);
  changed |= draw_buttons(ui, ground, knots);
  return changed;
}

}  // namespace trocar::ui
