#include "engine/workbench/jobs/film_renderer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/core/check.h"
#include "engine/film/property.h"

namespace trocar::workbench {
namespace {

/// Letters are 14 units high at least; below this many pixels they are hard to read.
constexpr double kLeastLetter_px = 9.0;
constexpr double kSmallestLetter = 14.0;

void warn_of_band(const PaneLook& look, const std::string& title, Diagnostics& diagnostics) {
  using film::Overlay;
  if (look.inset) return;
  const film::Band band = film::band_for(look.overlays, look.width, look.height);
  if (band == film::Band::kNone) return;
  const bool hands = look.overlays.has(Overlay::kPedals) || look.overlays.has(Overlay::kJaws);
  if (band == film::Band::kShort && hands) {
    diagnostics.warn(fmt::format("{} is too small for pedals and jaws: they are left out", title));
  }
  if (kSmallestLetter * film::unit_of(band, look.width, look.height) < kLeastLetter_px) {
    diagnostics.warn(
        fmt::format("the captions of {} are smaller than {} pixels: make the film larger", title, kLeastLetter_px));
  }
}

bool is_scene(const FilmSource& source) {
  return source.said.kind == film::SourceKind::kRecording || source.said.kind == film::SourceKind::kRollout;
}

void darken(Image& picture, double brightness) {
  if (brightness >= 1.0) return;
  const auto factor = static_cast<unsigned>(std::lround(256.0 * std::max(0.0, brightness)));
  for (std::size_t i = 0; i < picture.rgba.size(); ++i) {
    if (i % 4 != 3) picture.rgba[i] = static_cast<std::uint8_t>(picture.rgba[i] * factor / 256U);
  }
}

film::Stages stages(const FilmSource& source, film::Sync sync) {
  return source.shown ? film::stages_of(*source.shown, source.in_s, source.out_s, sync) : film::still_stages(sync);
}

}  // namespace

Result<FilmRenderer> FilmRenderer::create(const film::Composition& wanted, const Project& project,
                                          Diagnostics& diagnostics, RolloutShelf* shelf) {
  TROCAR_RETURN_IF_ERROR(film::check(wanted));
  film::Composition film = wanted;
  film.width += film.width % 2;
  film.height += film.height % 2;
  if (film.width != wanted.width || film.height != wanted.height) {
    diagnostics.warn(fmt::format("a film has an even width and height: {}×{} became {}×{}", wanted.width, wanted.height,
                                 film.width, film.height));
  }
  for (const std::string& sentence : film::idle_keys(film)) diagnostics.warn(sentence);
  RolloutShelf own;
  TROCAR_ASSIGN_OR_RETURN(std::vector<FilmSource> sources,
                          film_sources(project, film, shelf != nullptr ? *shelf : own));
  std::vector<film::Stages> parts;
  for (const FilmSource& source : sources) parts.push_back(stages(source, film.pace.sync));
  TROCAR_ASSIGN_OR_RETURN(film::TimeMap map, film::TimeMap::create(std::move(parts), film.pace, film.fps));
  FilmRenderer renderer(std::move(film), std::move(sources), std::move(map));
  TROCAR_RETURN_IF_ERROR(renderer.make_panes(diagnostics));
  return renderer;
}

PaneLook FilmRenderer::look_of(std::size_t source) const {
  const bool inside = film_.layout == film::Layout::kPictureInPicture;
  PaneLook look;
  look.width = cells_[source].width;
  look.height = cells_[source].height;
  look.overlays = film_.overlays;
  look.quality = film_.quality;
  look.inset = inside && source > 0;
  look.lines_at_right = inside && source == 0 && film_.corner == film::Corner::kTopLeft;
  look.colours_at_left = inside && source == 0 && film_.corner == film::Corner::kTopRight;
  return look;
}

Status FilmRenderer::make_panes(Diagnostics& diagnostics) {
  cells_ = film::cells_of(film_, film_.width, film_.height);
  for (std::size_t i = 0; i < sources_.size(); ++i) {
    const PaneLook look = look_of(i);
    if (is_scene(sources_[i])) warn_of_band(look, sources_[i].title, diagnostics);
    TROCAR_ASSIGN_OR_RETURN(std::unique_ptr<FilmPane> pane, make_pane(sources_[i], look));
    panes_.push_back(std::move(pane));
  }
  return {};
}

std::vector<std::array<double, 2>> FilmRenderer::spans_s() const {
  std::vector<std::array<double, 2>> spans;
  for (const FilmSource& source : sources_) {
    spans.push_back(source.shown ? std::array{source.shown->begin_s, source.shown->end_s} : std::array{0.0, 0.0});
  }
  return spans;
}

std::size_t FilmRenderer::other_of(std::size_t source) const {
  for (std::size_t step = 1; step < sources_.size(); ++step) {
    const std::size_t other = (source + step) % sources_.size();
    if (is_scene(sources_[other])) return other;
  }
  return source;
}

Status FilmRenderer::fit_inset(double film_s) {
  if (film_.layout != film::Layout::kPictureInPicture || film_.share_keys.empty()) return {};
  film::Composition now = film_;
  now.share = film::value_of(film_, film::share_property().name, film_s);
  const film::Cell cell = film::cells_of(now, film_.width, film_.height)[1];
  if (cell == cells_[1]) return {};
  const bool moved = cell.width == cells_[1].width && cell.height == cells_[1].height;
  cells_[1] = cell;
  if (moved) return {};
  TROCAR_ASSIGN_OR_RETURN(panes_[1], make_pane(sources_[1], look_of(1)));
  return {};
}

Result<Image> FilmRenderer::frame(Studio& studio, int number) {
  const film::Moment moment = map_.at(number);
  TROCAR_RETURN_IF_ERROR(fit_inset(moment.film_s));
  std::vector<Image> pictures;
  for (std::size_t i = 0; i < panes_.size(); ++i) {
    PaneMoment of_pane{moment.film_s, moment.speed, moment.sources[i], nullptr, 0.0};
    if (const std::size_t other = other_of(i); other != i && film_.overlays.has(film::Overlay::kGhost)) {
      of_pane.ghost = sources_[other].shown.get();
      of_pane.ghost_s = moment.sources[other].at_s;
    }
    TROCAR_ASSIGN_OR_RETURN(Image picture, panes_[i]->frame(studio, of_pane));
    darken(picture, film::value_of(sources_[i].said, "brightness", moment.film_s));
    pictures.push_back(std::move(picture));
  }
  return film::composed(std::move(pictures), cells_, film_.width, film_.height);
}

std::vector<std::string> FilmRenderer::credits() const {
  std::vector<std::string> out;
  for (const FilmSource& source : sources_) out.push_back(credit_of(source));
  return out;
}

std::string FilmRenderer::title() const {
  std::string text;
  for (const FilmSource& source : sources_) text += (text.empty() ? "" : " | ") + source.title;
  return text;
}

std::string FilmRenderer::caption_text(int number) const {
  const film::Moment moment = map_.at(number);
  std::string text;
  for (std::size_t i = 0; i < panes_.size(); ++i) {
    const std::string own = panes_[i]->caption_at(moment.sources[i]);
    if (own.empty()) continue;
    if (!text.empty()) text += "\n";
    if (panes_.size() > 1) text += sources_[i].title + ": ";
    text += own;
    if (moment.sources[i].waiting) text += " (waiting)";
    if (moment.sources[i].over) text += " (finished)";
  }
  return text;
}

}  // namespace trocar::workbench
