#include "ui/panels/export_tracks.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "engine/film/pace.h"
#include "engine/film/property.h"
#include "ui/format.h"
#include "ui/icons.h"
#include "ui/panels/common.h"
#include "ui/panels/export_sources.h"

namespace trocar::ui {
namespace {

using film::Composition;
using film::Property;
using film::Source;
using workbench::FilmDraft;

/// The last index of the cells of the field that the source shows; of the paper's lattice where it is not known.
double last_slice(const workbench::Project& project, const Source& source) {
  const std::string& of = source.field ? source.field->of : source.of;
  for (const auto& [id, entry] : project.models) {
    if (entry->model && (fmt::format("{}", id.value) == of || entry->name == of)) return entry->model->grid.n - 1;
  }
  return spatial::Grid{}.n - 1;
}

/// What a slider reaches over; a job may go further.
std::array<double, 2> range_of(const Property& property) {
  constexpr double kTurn = 2.0 * std::numbers::pi;
  if (property.name == "orbit.yaw") return {-kTurn, kTurn};
  if (property.name == "zoom") return {0.5, 5.0};
  if (property.name == "trail") return {0.0, 20.0};
  if (property.name == "speed") return {0.1, 10.0};
  return {property.low, property.high};
}

double frame_s(const Composition& film) {
  return 1.0 / film.fps;
}

/// Shown as "45°" or "1.50×".
std::string words_of(const Property& property, double value) {
  return fmt::format("{:.{}f}{}", property.factor * value, property.decimals, property.unit);
}

/// Where the film goes on by one of its keys.
void draw_keys(Ui& ui, FilmDraft& draft, const Property& property, double at_s, std::vector<film::Key>& keys) {
  static const std::vector<std::string> kEases{"Even", "Smooth", "Hold", "Spline"};
  std::size_t removed = keys.size();
  const float left = ImGui::GetCursorPosX();
  const float wide = ImGui::GetContentRegionAvail().x;
  const float button = ui.px(32);
  for (std::size_t i = 0; i < keys.size(); ++i) {
    film::Key& key = keys[i];
    const std::string name = seconds(key.t_s);
    const Scope own(ui, name);
    ImGui::PushID(static_cast<int>(i));
    const bool here = std::abs(key.t_s - at_s) < 0.5 * frame_s(draft.film);
    if (toggle(ui, "Go there", here, {.icon = icon::kClock, .icon_only = true, .help = "Shows the film at this key"})) {
      // Keys of the speed do not count holds.
      draft.at_s = &property == &film::speed_property() ? film::film_time_of(draft.film.pace, key.t_s) : key.t_s;
    }
    ImGui::SameLine(0.0F, ui.px(8));
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(name.c_str());
    ImGui::SameLine(left + ui.px(112));
    ImGui::TextUnformatted(words_of(property, key.value).c_str());
    note_item(ui, "text", "Value", words_of(property, key.value), {});
    ImGui::SameLine(left + std::max(ui.px(180), wide - button - ui.px(6) - ui.px(130)));
    auto ease = static_cast<int>(key.ease);
    if (combo(ui, "Ease", ease, kEases,
              {.help = "How it goes on to the next key",
               .reason = i + 1 == keys.size() ? "Nothing comes after the last key" : "",
               .width = std::max(ui.px(60), ImGui::GetContentRegionAvail().x - button - ui.px(6))})) {
      key.ease = static_cast<film::Ease>(ease);
    }
    ImGui::SameLine(left + wide - button);
    if (icon_button(ui, "Remove key",
                    {.icon = icon::kTrash,
                     .help = "It goes from the key before to the one after",
                     .style = ButtonStyle::kQuiet})) {
      removed = i;
    }
    ImGui::PopID();
  }
  if (removed < keys.size()) keys.erase(keys.begin() + static_cast<std::ptrdiff_t>(removed));
}

/// Why the number changes nothing that is seen; "" if it does.
std::string_view idle_reason(const film::Overlays& overlays, const Property& property) {
  if (property.name == "trail" && !overlays.has(film::Overlay::kTrail))
    return "No trail is drawn: switch it on in Look";
  if (property.name == "ghost" && !overlays.has(film::Overlay::kGhost))
    return "No ghost is drawn: switch it on in Look";
  return "";
}

/// A slider for what it is at the instant, a button for a key there, and its keys. `Of` is the film or a source of it;
/// `at_s` the instant by the time in which its keys are.
template <typename Of>
void draw_property(Ui& ui, FilmDraft& draft, Of& of, const Property& property, const std::array<double, 2>& range,
                   double at_s) {
  const std::string shown(property.shown);
  std::vector<film::Key> keys = film::keys_of(of, property.name);
  const double now = film::value_of(of, property.name, at_s);
  const double apart_s = 0.5 * frame_s(draft.film);
  const auto here =
      std::find_if(keys.begin(), keys.end(), [&](const film::Key& key) { return std::abs(key.t_s - at_s) < apart_s; });
  const film::Key added{at_s, now, here == keys.end() ? film::Ease::kSmooth : here->ease};
  form_label(ui, shown);
  auto value = static_cast<float>(property.factor * now);
  const std::string format = fmt::format("%.{}f{}", property.decimals, property.unit == " %" ? " %%" : property.unit);
  const float wide = ImGui::GetContentRegionAvail().x;
  const bool slid = slider_float(
      ui, shown, value, static_cast<float>(property.factor * range[0]), static_cast<float>(property.factor * range[1]),
      format.c_str(),
      {.help = property.help, .reason = idle_reason(draft.film.overlays, property), .width = wide - ui.px(38)});
  const Scope scope(ui, shown);
  ImGui::SameLine(0.0F, 0.0F);
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::max(0.0F, ImGui::GetContentRegionAvail().x - ui.px(32)));
  if (toggle(ui, "Key here", here != keys.end(),
             {.icon = icon::kField, .icon_only = true, .help = "A key at the instant that is shown, or none"})) {
    if (here != keys.end()) {
      // What was seen stays as long as it is the only one.
      if (keys.size() == 1) film::set_fixed_value(of, property.name, now);
      keys.erase(here);
    } else {
      keys = film::with_key_at(std::move(keys), added, apart_s);
    }
  } else if (slid) {
    const double wanted = std::clamp(static_cast<double>(value) / property.factor, property.low, property.high);
    if (keys.empty()) {
      film::set_fixed_value(of, property.name, wanted);
    } else {
      keys = film::with_key_at(std::move(keys), {added.t_s, wanted, added.ease}, apart_s);
    }
  }
  if (!keys.empty()) {
    const Scope list(ui, "Keys");
    draw_keys(ui, draft, property, at_s, keys);
  }
  film::set_keys(of, property.name, std::move(keys));
}

/// Where the picture stands, by the time that all sources have in common.
void draw_holds(Ui& ui, const WorkbenchState& state, FilmDraft& draft) {
  heading(ui, "Holds");
  const Scope scope(ui, "Holds");
  std::vector<film::Hold>& holds = draft.film.pace.holds;
  std::size_t removed = holds.size();
  const float left = ImGui::GetCursorPosX();
  const float wide = ImGui::GetContentRegionAvail().x;
  for (std::size_t i = 0; i < holds.size(); ++i) {
    const std::string name = seconds(holds[i].at_s);
    const Scope own(ui, name);
    ImGui::PushID(static_cast<int>(i));
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(("At " + name).c_str());
    ImGui::SameLine(left + ui.px(96));
    auto lasts = static_cast<float>(holds[i].for_s);
    if (slider_float(ui, "For", lasts, 0.1F, 10.0F, "%.1f s",
                     {.help = "Film seconds for which the picture stands", .width = wide - ui.px(96) - ui.px(40)})) {
      holds[i].for_s = static_cast<double>(lasts);
    }
    ImGui::SameLine(left + wide - ui.px(32));
    if (icon_button(ui, "Remove hold",
                    {.icon = icon::kTrash, .help = "The film goes on there", .style = ButtonStyle::kQuiet})) {
      removed = i;
    }
    ImGui::PopID();
  }
  if (removed < holds.size()) holds.erase(holds.begin() + static_cast<std::ptrdiff_t>(removed));
  const auto& preview = state.film_preview;
  const bool known = preview && preview->picture && !state.film_preview_pending;
  const double at_s = known ? preview->common_s : 0.0;
  const bool there = std::any_of(holds.begin(), holds.end(),
                                 [&](const film::Hold& hold) { return std::abs(hold.at_s - at_s) < 1e-3; });
  if (button(ui, "Hold here",
             {.icon = icon::kPause,
              .help = "The picture stands for a second at the instant that is shown",
              .reason = !known  ? "There is no picture yet"
                        : there ? "The picture stands here already"
                                : ""})) {
    const auto after = std::upper_bound(holds.begin(), holds.end(), at_s,
                                        [](double t_s, const film::Hold& hold) { return t_s < hold.at_s; });
    holds.insert(after, {at_s, 1.0});
  }
}

}  // namespace

void draw_film_tracks(Ui& ui, const WorkbenchState& state, FilmDraft& draft, int& of) {
  const Scope scope(ui, "Keys");
  std::vector<std::string> names{"The film"};
  UniqueNames unique;
  for (const Source& source : draft.film.sources) names.push_back(unique(name_of_source(*state.project, source)));
  of = std::clamp(of, 0, static_cast<int>(names.size()) - 1);
  form_label(ui, "Of");
  combo(ui, "Of", of, names, {.help = "Whose numbers change as the film goes"});
  if (of == 0) {
    draw_property(ui, draft, draft.film, film::speed_property(), range_of(film::speed_property()),
                  film::running_of(draft.film.pace, draft.at_s));
    if (draft.film.layout == film::Layout::kPictureInPicture) {
      draw_property(ui, draft, draft.film, film::share_property(), range_of(film::share_property()), draft.at_s);
    }
    draw_holds(ui, state, draft);
    return;
  }
  Source& source = draft.film.sources[static_cast<std::size_t>(of) - 1];
  for (const Property& property : film::all_source_properties()) {
    if (!film::has_property(source, property)) continue;
    std::array<double, 2> range = range_of(property);
    if (property.name == "slice") range[1] = last_slice(*state.project, source);
    draw_property(ui, draft, source, property, range, draft.at_s);
  }
  wrapped_text(ui, "Without keys a number holds for the whole film; with keys a slider sets the key at the instant",
               ui.theme().text_dim);
}

}  // namespace trocar::ui
