#include "ui/panels/rollout_band.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "ui/format.h"
#include "ui/panels/rollout_parts.h"
#include "ui/widgets/stroke.h"

namespace trocar::ui {
namespace {

using learning::DeviationBand;

/// Where band and count lie; both run along the same steps.
struct BandPlaces {
  Rect band;
  Rect count;
  std::size_t last = 0;  ///< Step.
  double most_m = 0.0;

  float x_of(std::size_t step) const {
    return band.x0 + static_cast<float>(step) / static_cast<float>(last) * band.width();
  }
  ImVec2 in_band(std::size_t step, double value_m) const {
    return {x_of(step), band.y1 - static_cast<float>(value_m / most_m) * band.height()};
  }
  ImVec2 in_count(std::size_t step, double share) const {
    return {x_of(step), count.y1 - static_cast<float>(share) * count.height()};
  }
};

std::string step_words(const DeviationBand& band, std::size_t step) {
  if (step >= band.median.size()) return fmt::format("fewer than {} go on", learning::kLeastInBand);
  return fmt::format("median {}, half in {} to {}, 90 % in {} to {}, {} of {} go on", millimetres(band.median[step]),
                     millimetres(band.lower[step]), millimetres(band.upper[step]), millimetres(band.low[step]),
                     millimetres(band.high[step]), count(band.count[step]), count(band.count.front()));
}

void draw_band_part(const BandPlaces& places, const std::vector<double>& low, const std::vector<double>& high,
                    ImU32 colour) {
  for (std::size_t i = 0; i + 1 < high.size(); ++i) {
    ImGui::GetWindowDrawList()->AddQuadFilled(places.in_band(i, high[i]), places.in_band(i + 1, high[i + 1]),
                                              places.in_band(i + 1, low[i + 1]), places.in_band(i, low[i]), colour);
  }
}

/// A rollout goes on up to the step at which it ends: the count has steps, not slopes.
void draw_going_on(Ui& ui, const BandPlaces& places, const DeviationBand& band) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Rgba colour = ui.theme().text_dim;
  std::vector<ImVec2> top;
  const std::size_t last = band.count.size() - 1;
  for (std::size_t i = 0; i <= last; ++i) {
    const double share = static_cast<double>(band.count[i]) / static_cast<double>(band.count.front());
    if (i > 0) top.push_back({places.x_of(i), top.back().y});
    top.push_back(places.in_count(i, share));
    if (i == last) break;
    list.AddRectFilled(top.back(), {places.x_of(i + 1), places.count.y1}, to_u32(colour, 0.30F));
  }
  stroke(list, top, to_u32(colour), std::max(ui.px(1), 1.0F));
}

/// The second model's: its middle one, and thin where half and 90 % lie.
void draw_other(Ui& ui, const BandPlaces& places, const DeviationBand& band) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (const std::vector<double>* values : {&band.low, &band.lower, &band.median, &band.upper, &band.high}) {
    std::vector<ImVec2> line;
    for (std::size_t i = 0; i < values->size(); ++i) line.push_back(places.in_band(i, (*values)[i]));
    const bool middle = values == &band.median;
    stroke(list, line, to_u32(ui.theme().warning, middle ? 1.0F : 0.45F), ui.px(middle ? 2.0F : 1.0F));
  }
}

void draw_band_words(Ui& ui, const BandPlaces& places, const DeviationBand& band, float left) {
  const FontScope font(ui.fonts().small);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImU32 dim = to_u32(ui.theme().text_dim);
  const float line = ui.fonts().small->FontSize;
  list.AddText({left, places.band.y0}, dim, fmt::format("{:.1f}", 1e3 * places.most_m).c_str());
  list.AddText({left, places.band.y1 - line}, dim, "0 mm");
  list.AddText({left, places.count.y0}, dim, count(band.count.front()).c_str());
  list.AddText({left, places.count.y1 - line}, dim, "go on");
  list.AddText({places.count.x0, places.count.y1 + ui.px(1)}, dim, "step 0");
  const std::string end = fmt::format("step {}", places.last);
  list.AddText({places.count.x1 - ImGui::CalcTextSize(end.c_str()).x, places.count.y1 + ui.px(1)}, dim, end.c_str());
}

}  // namespace

void draw_deviation_band(Ui& ui, const workbench::ModelInsight& insight) {
  const Scope scope(ui, "Deviation");
  heading(ui, "Deviation from the expert");
  const DeviationBand& band = insight.spread->band;
  const DeviationBand* other =
      insight.second && insight.second->spread->band.median.size() > 1 ? &insight.second->spread->band : nullptr;
  if (insight.second) dim_text(ui, "A filled: " + insight.entry->name + "; B lines: " + insight.second->entry->name);
  if (band.median.size() < 2) {
    wrapped_text(ui, fmt::format("Needs {} rollouts of some steps", learning::kLeastInBand), ui.theme().text_dim);
    return;
  }
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  const float line = ui.fonts().small->FontSize;
  const float of_band = ui.px(100);
  const float of_count = std::max(ui.px(34), 2.0F * line + ui.px(2));
  const float height = ui.px(4) + of_band + ui.px(6) + of_count + line + ui.px(2);
  BandPlaces places;
  places.band = {at.x + ui.px(44), at.y + ui.px(4), at.x + width - ui.px(4), at.y + ui.px(4) + of_band};
  places.count = {places.band.x0, places.band.y1 + ui.px(6), places.band.x1, places.band.y1 + ui.px(6) + of_count};
  places.last = std::max(band.median.size(), other == nullptr ? 0 : other->median.size()) - 1;
  places.most_m = std::max(*std::max_element(band.high.begin(), band.high.end()), 1e-4);
  if (other != nullptr)
    places.most_m = std::max(places.most_m, *std::max_element(other->high.begin(), other->high.end()));
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const bool inside = Rect{at.x, at.y, at.x + width, at.y + height}.contains(mouse.x, mouse.y);
  const float along = std::clamp((mouse.x - places.band.x0) / places.band.width(), 0.0F, 1.0F);
  const std::size_t step = inside ? static_cast<std::size_t>(std::lround(along * static_cast<float>(places.last))) : 0;
  std::string value = step_words(band, step);
  if (insight.second)
    value = fmt::format("step {}: A {}", step, value);
  else
    value = fmt::format("step {}: {}", step, value);
  if (other != nullptr) value += "; B " + step_words(*other, step);
  chart_area(ui, "Band", {width, height}, value,
             {.help = "The middle rollout, where half and 90 % of them are, and how many still go on, step by step"});
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (const Rect& area : {places.band, places.count}) {
    list.AddRectFilled({area.x0, area.y0}, {area.x1, area.y1}, to_u32(ui.theme().header));
  }
  draw_band_part(places, band.low, band.high, to_u32(ui.theme().accent, 0.20F));
  draw_band_part(places, band.lower, band.upper, to_u32(ui.theme().accent, 0.30F));
  std::vector<ImVec2> middle;
  for (std::size_t i = 0; i < band.median.size(); ++i) middle.push_back(places.in_band(i, band.median[i]));
  stroke(list, middle, to_u32(ui.theme().accent), ui.px(2));
  if (other != nullptr) draw_other(ui, places, *other);
  draw_going_on(ui, places, band);
  const float x = places.x_of(step);
  if (inside) list.AddLine({x, places.band.y0}, {x, places.count.y1}, to_u32(ui.theme().text_dim));
  draw_band_words(ui, places, band, at.x);
  wrapped_text(ui, value, ui.theme().text_dim);
}

}  // namespace trocar::ui
