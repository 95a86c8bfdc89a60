#include "ui/panels/opacity_editor.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "ui/icons.h"
#include "ui/widgets/stroke.h"

namespace trocar::ui {
namespace {

using plot::OpacityCurve;
using plot::OpacityKnot;

constexpr float kOpacityHeight = 96.0F;  // At 100 %, as what follows.
constexpr float kOpacityRadius = 5.0F;
constexpr float kOpacityReach = 12.0F;
constexpr double kLeastKnotGap = 0.01;
constexpr std::size_t kOpacityBins = 64;
constexpr int kDrawnOpacity = 5;  ///< After automatic and the presets.
constexpr std::string_view kOpacityHelp =
    "Place on the colour scale to the right, how much it hides upwards. Drag a knot, double-click for a new one or to "
    "take one away; up and down shift the chosen one";

double to_percent(double value) {
  return std::round(100.0 * value) / 100.0;
}

std::string opacity_words(const OpacityKnot& knot) {
  return fmt::format("{:.2f} → {:.2f}", knot.position, knot.height);
}

/// As near to `wanted` as its neighbours allow.
void move_knot(std::vector<OpacityKnot>& knots, std::size_t knot, const OpacityKnot& wanted) {
  const double low = knot == 0 ? 0.0 : knots[knot - 1].position + kLeastKnotGap;
  const double high = knot + 1 == knots.size() ? 1.0 : knots[knot + 1].position - kLeastKnotGap;
  if (low <= high) knots[knot].position = std::clamp(to_percent(wanted.position), low, high);
  knots[knot].height = std::clamp(to_percent(wanted.height), 0.0, 1.0);
}

/// Where it is put among them; nothing where there is no room.
std::optional<std::size_t> add_knot(std::vector<OpacityKnot>& knots, const OpacityKnot& wanted) {
  const OpacityKnot knot{std::clamp(to_percent(wanted.position), 0.0, 1.0),
                         std::clamp(to_percent(wanted.height), 0.0, 1.0)};
  if (knots.size() >= plot::kMostOpacityKnots) return std::nullopt;
  const auto near = [&](const OpacityKnot& one) {
    return std::abs(one.position - knot.position) < 0.9 * kLeastKnotGap;
  };
  if (std::any_of(knots.begin(), knots.end(), near)) return std::nullopt;
  const auto after =
      std::find_if(knots.begin(), knots.end(), [&](const auto& one) { return one.position > knot.position; });
  const std::ptrdiff_t place = after - knots.begin();
  knots.insert(after, knot);
  return static_cast<std::size_t>(place);
}

void remove_knot(std::vector<OpacityKnot>& knots, std::size_t knot) {
  if (knots.size() > 1) knots.erase(knots.begin() + static_cast<std::ptrdiff_t>(knot));
}

bool choose_opacity(Ui& ui, std::optional<OpacityCurve>& curve) {
  static const std::vector<std::string> kNames{"automatic",       "linear ramp", "only the highest",
                                               "only the lowest", "uniform",     "as drawn"};
  int chosen = 0;
  if (curve) {
    const auto preset = plot::preset_of(*curve);
    chosen = preset ? 1 + static_cast<int>(*preset) : kDrawnOpacity;
  }
  // "As drawn" is no choice before something is drawn.
  const std::span<const std::string> names(kNames.data(), chosen == kDrawnOpacity ? kNames.size() : kNames.size() - 1);
  if (!combo(ui, "Opacity curve", chosen, names,
             {.help = "What the cloud hides by its values; automatic: clear where most values lie"})) {
    return false;
  }
  if (chosen == 0) curve.reset();
  if (chosen > 0 && chosen < kDrawnOpacity) curve = plot::opacity_curve(static_cast<plot::OpacityPreset>(chosen - 1));
  return true;
}

}  // namespace

struct OpacityEditor::Ground {
  Rect rect;

  ImVec2 at(const OpacityKnot& knot) const {
    return {rect.x0 + static_cast<float>(knot.position) * rect.width(),
            rect.y1 - static_cast<float>(knot.height) * rect.height()};
  }
  OpacityKnot under(ImVec2 mouse) const {
    return {static_cast<double>((mouse.x - rect.x0) / rect.width()),
            static_cast<double>((rect.y1 - mouse.y) / rect.height())};
  }
};

void OpacityEditor::follow(const FieldShading& shading) {
  if (revision_ == shading.revision()) return;
  revision_ = shading.revision();
  fitted_ = plot::fitted_opacity(shading.colouring(), shading.field().values);
  histogram_.assign(kOpacityBins, 0.0F);
  for (const double value : shading.field().values) {
    if (!std::isfinite(value)) continue;
    const double place = shading.colouring().scale.position(value) * static_cast<double>(kOpacityBins);
    histogram_[std::min(static_cast<std::size_t>(place), kOpacityBins - 1)] += 1.0F;
  }
  const float most = *std::max_element(histogram_.begin(), histogram_.end());
  if (most <= 0.0F) return;
  for (float& bin : histogram_) bin /= most;
}

bool OpacityEditor::take_mouse(const Ui& ui, const Ground& ground, Knots& knots) {
  const ImGuiIO& io = ImGui::GetIO();
  const auto distance = [&](const OpacityKnot& knot) {
    const ImVec2 at = ground.at(knot);
    return std::hypot(at.x - io.MousePos.x, at.y - io.MousePos.y);
  };
  const auto nearest = std::min_element(knots.begin(), knots.end(),
                                        [&](const auto& a, const auto& b) { return distance(a) < distance(b); });
  const bool on_knot = distance(*nearest) <= ui.px(kOpacityReach);
  const auto place = static_cast<std::size_t>(nearest - knots.begin());
  if (ImGui::IsItemHovered() && on_knot) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(0)) {
    const std::size_t before = knots.size();
    if (on_knot) {
      remove_knot(knots, place);
    } else if (const auto added = add_knot(knots, ground.under(io.MousePos))) {
      chosen_ = *added;
    }
    dragging_ = false;
    return knots.size() != before;
  }
  if (ImGui::IsItemActivated() && on_knot) {
    chosen_ = place;
    dragging_ = true;
  }
  if (!ImGui::IsItemActive()) dragging_ = false;
  if (!dragging_ || (io.MouseDelta.x == 0.0F && io.MouseDelta.y == 0.0F)) return false;
  const Knots before = knots;
  move_knot(knots, chosen_, ground.under(io.MousePos));
  return knots != before;
}

bool OpacityEditor::take_keys(Ui& ui, Knots& knots) const {
  if (!ui.focus().is_on(ui.items().items().back())) return false;
  const int step = (ui.input().pressed(Key::kUp) ? 1 : 0) - (ui.input().pressed(Key::kDown) ? 1 : 0);
  if (step == 0) return false;
  const Knots before = knots;
  move_knot(knots, chosen_, {knots[chosen_].position, knots[chosen_].height + 0.02 * step});
  return knots != before;
}

void OpacityEditor::draw_curve(Ui& ui, const FieldShading& shading, const Ground& ground,
                               const OpacityCurve& shown) const {
  const Theme& theme = ui.theme();
  const Rect& area = ground.rect;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float each = area.width() / static_cast<float>(kOpacityBins);
  for (std::size_t i = 0; i < kOpacityBins; ++i) {
    const float x0 = std::round(area.x0 + each * static_cast<float>(i));
    const float x1 = std::max(std::round(area.x0 + each * static_cast<float>(i + 1)), x0 + 1.0F);
    // As on the colour bar, where the few values would not be seen otherwise.
    const float height = std::sqrt(histogram_[i]) * area.height();
    list.AddRectFilled({x0, area.y1 - height}, {x1, area.y1}, to_u32(theme.text_dim, 0.35F));
    const Rgba colour =
        shading.colouring().colour_at((static_cast<double>(i) + 0.5) / static_cast<double>(kOpacityBins));
    list.AddRectFilled({x0, area.y1 + ui.px(2)}, {x1, area.y1 + ui.px(7)}, to_u32(colour));
  }
  std::vector<ImVec2> points{{area.x0, ground.at(shown.knots.front()).y}};
  for (const OpacityKnot& knot : shown.knots) points.push_back(ground.at(knot));
  points.push_back({area.x1, ground.at(shown.knots.back()).y});
  stroke(list, points, to_u32(theme.accent), ui.px(2));
  for (std::size_t i = 0; i < shown.knots.size(); ++i) {
    const ImVec2 at = ground.at(shown.knots[i]);
    const float radius = ui.px(kOpacityRadius);
    list.AddCircleFilled(at, radius, to_u32(i == chosen_ ? theme.accent : theme.panel));
    list.AddCircle(at, radius, to_u32(theme.text), 0, std::max(ui.px(1.5F), 1.0F));
    note_rect(ui, "mark", fmt::format("Knot {}", i + 1), opacity_words(shown.knots[i]),
              {at.x - radius, at.y - radius, at.x + radius, at.y + radius});
  }
}

bool OpacityEditor::draw_buttons(Ui& ui, Knots& knots) {
  const std::size_t before = knots.size();
  const std::string chosen = fmt::format("Knot {} of {}", chosen_ + 1, knots.size());
  if (toggle_shown_as(ui, "Next knot", chosen, false, {.help = "Choose the next knot"})) {
    chosen_ = (chosen_ + 1) % knots.size();
  }
  flow(button_width(ui, "Add knot", icon::kPlus), ui.px(6));
  if (button(ui, "Add knot", {.icon = icon::kPlus, .help = "In the middle after the chosen one, or before the last"})) {
    const std::size_t from =
        chosen_ + 1 < knots.size() ? chosen_ : knots.size() - std::min<std::size_t>(knots.size(), 2);
    const OpacityKnot& a = knots[from];
    const OpacityKnot b =
        from + 1 < knots.size() ? knots[from + 1] : OpacityKnot{a.position < 0.5 ? 1.0 : 0.0, a.height};
    if (const auto added = add_knot(knots, {0.5 * (a.position + b.position), 0.5 * (a.height + b.height)}))
      chosen_ = *added;
  }
  flow(button_width(ui, "Remove knot", icon::kTrash), ui.px(6));
  if (button(ui, "Remove knot",
             {.icon = icon::kTrash,
              .help = "Take the chosen one away",
              .reason = knots.size() == 1 ? "The last one stays" : ""})) {
    remove_knot(knots, chosen_);
  }
  chosen_ = std::min(chosen_, knots.size() - 1);
  return knots.size() != before;
}

bool OpacityEditor::draw_typed(Ui& ui, OpacityCurve& shown) {
  std::string text = plot::to_string(shown);
  const std::string before = text;
  if (text_field(ui, "Knots", text, "0:0/0.6:0.1/1:1",
                 {.help = "Place and height of each knot, 0 to 1, as the command line takes them", .width = -1.0F}) &&
      text != before) {
    const auto typed = plot::opacity_curve_from(text);
    error_ = typed ? "" : typed.error().text();
    if (typed) shown = *typed;
    return typed.has_value();
  }
  if (!error_.empty()) wrapped_text(ui, error_, ui.theme().danger);
  return false;
}

bool OpacityEditor::draw(Ui& ui, const FieldShading& shading, std::optional<OpacityCurve>& curve) {
  const Scope scope(ui, "Cloud");
  follow(shading);
  form_label(ui, "Cloud");
  bool changed = choose_opacity(ui, curve);
  OpacityCurve shown = curve ? *curve : fitted_;
  chosen_ = std::min(chosen_, shown.knots.size() - 1);
  ImGui::InvisibleButton("curve", {std::max(ImGui::GetContentRegionAvail().x, ui.px(60)), ui.px(kOpacityHeight)});
  const Rect rect = item_rect();
  if (ImGui::IsItemHovered()) ui.set_hint(kOpacityHelp);
  const float edge = ui.px(kOpacityRadius + 2.0F);
  const Ground ground{{rect.x0 + edge, rect.y0 + edge, rect.x1 - edge, rect.y1 - ui.px(11)}};
  bool drawn = take_mouse(ui, ground, shown.knots);
  chosen_ = std::min(chosen_, shown.knots.size() - 1);
  note_rect(ui, "plot", "Curve", opacity_words(shown.knots[chosen_]), rect, {.help = kOpacityHelp});
  drawn |= take_keys(ui, shown.knots);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled({rect.x0, rect.y0}, {rect.x1, rect.y1}, to_u32(ui.theme().header), ui.px(3));
  draw_curve(ui, shading, ground, shown);
  drawn |= draw_buttons(ui, shown.knots);
  drawn |= draw_typed(ui, shown);
  if (drawn) {
    curve = shown;
    error_.clear();
  }
  return changed || drawn;
}

}  // namespace trocar::ui
