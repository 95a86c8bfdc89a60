#include "engine/workbench/film_preview_maker.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace trocar::workbench {

Status FilmPreviewMaker::prepare(const FilmPreviewRequest& request) {
  if (!studio_) {
    TROCAR_ASSIGN_OR_RETURN(Studio studio, Studio::create());
    studio_.emplace(std::move(studio));
  }
  if (renderer_ && film_ == request.film && project_ == request.project) return {};
  renderer_.reset();
  Diagnostics diagnostics;
  TROCAR_ASSIGN_OR_RETURN(FilmRenderer renderer,
                          FilmRenderer::create(request.film, *request.project, diagnostics, &shelf_));
  renderer_.emplace(std::move(renderer));
  film_ = request.film;
  project_ = request.project;
  warning_ = diagnostics.warnings().empty() ? "" : diagnostics.warnings().front();
  return {};
}

std::shared_ptr<const FilmPreview> FilmPreviewMaker::make(const FilmPreviewRequest& request) {
  auto preview = std::make_shared<FilmPreview>();
  preview->of = request.film;
  preview->number = ++number_;
  if (!request.project) return preview;
  if (const Status ready = prepare(request); !ready) {
    preview->error = ready.error().text();
    return preview;
  }
  const int pass = renderer_->frame_count() / request.film.pace.loops;
  preview->frames = renderer_->frame_count();
  preview->length_s = (pass - 1) / request.film.fps;
  preview->frame = static_cast<int>(std::lround(std::clamp(request.at_s, 0.0, preview->length_s) * request.film.fps));
  preview->warning = warning_;
  preview->common_s = renderer_->map().at(preview->frame).common_s;
  preview->spans_s = renderer_->spans_s();
  Result<Image> picture = renderer_->frame(*studio_, preview->frame);
  if (picture) {
    preview->picture = std::make_shared<const Image>(std::move(*picture));
  } else {
    preview->error = picture.error().text();
  }
  return preview;
}

}  // namespace trocar::workbench
