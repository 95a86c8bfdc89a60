#include "ui/panels/export_look.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <string>
#include <vector>

#include "engine/film/composition_words.h"

namespace trocar::ui {
namespace {

using film::Composition;

/// "Colour bar" of "colour-bar".
std::string shown_word(std::string_view word) {
  std::string shown(word);
  std::replace(shown.begin(), shown.end(), '-', ' ');
  shown.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(shown.front())));
  return shown;
}

/// The preset, with what it says nothing of: what is filmed, and into which file.
Composition begun_with(std::string_view preset, const Composition& film) {
  Composition begun = film::preset_from(preset).value_or(film);
  begun.sources = film.sources;
  begun.path = film.path;
  begun.codec = film.codec;
  if (!begun.sources.empty()) begun.layout = film::layout_for(begun.layout, begun.sources.size());
  return begun;
}

void draw_preset(Ui& ui, Composition& film) {
  std::vector<std::string> names{"Own"};
  int chosen = 0;
  for (const std::string_view preset : film::preset_names()) {
    if (begun_with(preset, film) == film) chosen = static_cast<int>(names.size());
    names.emplace_back(preset);
  }
  form_label(ui, "Preset");
  if (combo(ui, "Preset", chosen, names, {.help = "All of this page, size and rate at once"}) && chosen > 0) {
    film = begun_with(names[static_cast<std::size_t>(chosen)], film);
  }
}

void draw_layout(Ui& ui, Composition& film) {
  static const std::vector<std::string> kLayoutNames{"Single", "Side by side", "Above", "2×2", "3×3", "Inset"};
  static const std::vector<std::string> kCornerNames{"Top left", "Top right", "Bottom left", "Bottom right"};
  auto layout = static_cast<int>(film.layout);
  form_label(ui, "Layout");
  if (segmented(ui, "Layout", layout, kLayoutNames, {.help = "How the sources lie in a frame"})) {
    film.layout = static_cast<film::Layout>(layout);
  }
  if (film.layout != film::Layout::kPictureInPicture) return;
  auto corner = static_cast<int>(film.corner);
  form_label(ui, "Corner");
  if (combo(ui, "Corner", corner, kCornerNames, {.help = "Where the second source lies in the first"})) {
    film.corner = static_cast<film::Corner>(corner);
  }
  auto share = static_cast<float>(film.share);
  form_label(ui, "Share");
  if (slider_float(ui, "Share", share, 0.1F, 0.5F, "%.2f of the width", {.help = "How wide the inset is"})) {
    film.share = static_cast<double>(share);
  }
}

void draw_pace(Ui& ui, Composition& film) {
  static const std::vector<std::string> kSyncNames{"Clock", "Segments", "Grasp"};
  static const std::vector<std::string> kSpeedNames{"0.5×", "1×", "2×", "4×", "8×"};
  constexpr std::array<double, 5> kSpeeds{0.5, 1.0, 2.0, 4.0, 8.0};
  auto sync = static_cast<int>(film.pace.sync);
  form_label(ui, "Together by");
  if (segmented(ui, "Together by", sync, kSyncNames,
                {.help = "What begins together: all, each segment (the faster side waits), or the grasp"})) {
    film.pace.sync = static_cast<film::Sync>(sync);
  }
  const auto* found = std::find(kSpeeds.begin(), kSpeeds.end(), film.pace.speed);
  int speed = found == kSpeeds.end() ? -1 : static_cast<int>(found - kSpeeds.begin());
  form_label(ui, "Speed");
  const std::string varies = film.pace.ramps.empty() ? "" : "The job has a speed that changes";
  if (segmented(ui, "Speed", speed, kSpeedNames,
                {.help = "Seconds of the sources for each second of film", .reason = varies})) {
    film.pace.speed = kSpeeds[static_cast<std::size_t>(speed)];
  }
  std::int64_t loops = film.pace.loops;
  form_label(ui, "Times");
  number_field(ui, "Times", loops, 1, 1000, {.help = "How often the film is shown, one after the other"});
  film.pace.loops = static_cast<int>(std::clamp<std::int64_t>(loops, 0, 1000));
  auto quality = static_cast<int>(film.quality);
  static const std::vector<std::string> kQualityNames{"Fast", "Fine"};
  form_label(ui, "Drawing");
  if (segmented(ui, "Drawing", quality, kQualityNames, {.help = "Fine: four samples a pixel, softer shadows"})) {
    film.quality = static_cast<film::Quality>(quality);
  }
}

void draw_overlays(Ui& ui, film::Overlays& overlays) {
  heading(ui, "Overlays");
  const Scope scope(ui, "Overlays");
  bool first = true;
  for (const auto& word : film::kOverlays) {
    const std::string name = shown_word(word.text);
    const float wide = ImGui::CalcTextSize(name.c_str()).x + 2.0F * ImGui::GetStyle().FramePadding.x;
    if (!first) flow(wide, ui.px(4));
    first = false;
    const bool on = overlays.has(word.value);
    if (toggle(ui, name, on, {.help = "Written over the film; captions also beside it, as .srt and .vtt"})) {
      overlays.set(word.value, !on);
    }
  }
  wrapped_text(ui, "That a script made something is written in any case", ui.theme().text_dim);
}

}  // namespace

void draw_film_look(Ui& ui, Composition& film) {
  const Scope scope(ui, "Look");
  draw_preset(ui, film);
  draw_layout(ui, film);
  draw_pace(ui, film);
  draw_overlays(ui, film.overlays);
}

}  // namespace trocar::ui
