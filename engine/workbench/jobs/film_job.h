/// Renders a film's job into a file, with its subtitles beside it.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "engine/core/progress.h"
#include "engine/core/result.h"
#include "engine/film/composition.h"
#include "engine/workbench/project.h"

namespace trocar::workbench {

struct FilmJob {
  film::Composition film;
  std::shared_ptr<const Project> project;
  std::filesystem::path path;  ///< Empty: as the composition says.
};

struct FilmReport {
  std::filesystem::path path;
  int frames = 0;
  int width = 0;
  int height = 0;
  double seconds = 0.0;  ///< Wall time.
  std::string codec;
  std::filesystem::path subtitles;      ///< SubRip. Empty: without captions there are none.
  std::filesystem::path web_subtitles;  ///< The same as WebVTT, for a page's <track>.
  std::vector<std::string> warnings;
};

/// The same job gives the same frames: frame k depends on k and on the project alone. Threads: any that holds no GL
/// context. Errors: those of `FilmRenderer::create` and `open_film_sink`; kInvalidArgument without a path; kCancelled,
/// which leaves no file. A pause holds it between two frames.
Result<FilmReport> render_film(const FilmJob& job, Progress& progress);

/// Whether that film can be in that file: its size, rate, codec and crf. Errors: kInvalidArgument.
Status check_film_file(const film::Composition& film, const std::filesystem::path& path);

/// Whether something of the film needs models open whole.
bool needs_models(const film::Composition& film);

}  // namespace trocar::workbench
