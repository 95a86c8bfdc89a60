/// Draws one frame of a film before it is rendered, by the renderer of the film itself.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "engine/workbench/film_preview.h"
#include "engine/workbench/jobs/film_renderer.h"
#include "engine/workbench/project.h"
#include "engine/workbench/studio.h"

namespace trocar::workbench {

struct FilmPreviewRequest {
  film::Composition film;
  double at_s = 0.0;  ///< Of the film; kept within it.
  std::shared_ptr<const Project> project;
};

/// Keeps what it needs for the next instant of the same film. Threads: made, used and destroyed in one thread, which
/// holds no other GL context.
class FilmPreviewMaker {
 public:
  /// The pixels are those of the film.
  std::shared_ptr<const FilmPreview> make(const FilmPreviewRequest& request);

 private:
  Status prepare(const FilmPreviewRequest& request);

  std::optional<Studio> studio_;
  std::optional<FilmRenderer> renderer_;  ///< Of the two that follow.
  film::Composition film_;
  std::shared_ptr<const Project> project_;
  std::string warning_;
  RolloutShelf shelf_;
  std::uint64_t number_ = 0;
};

}  // namespace trocar::workbench
