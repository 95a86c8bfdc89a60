/// The film that is being made in the window, and where one is in it.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "engine/core/result.h"
#include "engine/film/composition.h"
#include "engine/scene/scene.h"
#include "engine/workbench/project.h"

namespace trocar::workbench {

struct FilmDraft {
  film::Composition film;
  double at_s = 0.0;       ///< Of the film: what is shown of it before it is rendered, and where a key is added.
  std::size_t source = 0;  ///< The one whose camera or layer is being chosen.
  std::string job;         ///< The file that it is read from and written to; may be empty.
  bool operator==(const FilmDraft&) const = default;
};

/// A job as it is in a file: what was last opened or written.
struct FilmFile {
  std::filesystem::path path;
  film::Composition film;
};

/// What shows of it: the same film without file and codec.
film::Composition look_of(film::Composition film);
/// With another source at the end, which becomes the chosen one, in a layout that has room for it.
FilmDraft with_source(FilmDraft draft, film::Source source);
/// Without the chosen source. Precondition: there is one.
FilmDraft without_source(FilmDraft draft);
/// With the camera of the chosen source where the 3-D view's is at `draft.at_s`: its path has a key there, in the place
/// of one that was there already, and goes by keys from now on. Keys have the film's angle of view, not that of a
/// preset. Precondition: there is a chosen source.
FilmDraft with_key(FilmDraft draft, const scene::OrbitCamera& view);
/// For each trial of the session a film like this one of one of them, in a file with its name: film.mp4 gives
/// film_SC_1.mp4 and so on. What was excluded is left out. Errors: kInvalidArgument if the film is not of one trial, or
/// is a row of pictures.
Result<std::vector<film::Composition>> films_of_session(const Project& project, const film::Composition& film);

}  // namespace trocar::workbench
