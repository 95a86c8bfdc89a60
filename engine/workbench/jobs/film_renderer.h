/// Frames of a film by number, in any order: for the file, and for who wants to see one before.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "engine/core/diagnostics.h"
#include "engine/film/frame_layout.h"
#include "engine/workbench/jobs/film_pane.h"

namespace trocar::workbench {

/// Threads: that of the studio.
class FilmRenderer {
 public:
  /// Warns of a size that was made even, and of captions that cannot all be drawn or are too small to be read.
  /// Rollouts that it films are put on `shelf`, or taken from there; without one they are run.
  /// Errors: those of `film::check`, `film_sources`, `make_pane` and `film::TimeMap::create`.
  static Result<FilmRenderer> create(const film::Composition& film, const Project& project, Diagnostics& diagnostics,
                                     RolloutShelf* shelf = nullptr);

  int width() const { return film_.width; }    ///< Even.
  int height() const { return film_.height; }  ///< Even.
  int frame_count() const { return map_.frame_count(); }
  const film::TimeMap& map() const { return map_; }
  /// What there is of each source, of its own time, whatever its gates; nothing of what stands still.
  std::vector<std::array<double, 2>> spans_s() const;

  /// Precondition: 0 ≤ number < frame_count(). Depends on the number alone.
  Result<Image> frame(Studio& studio, int number);
  /// What the captions say in a frame: a line for each source; where there are several, with its title.
  std::string caption_text(int number) const;
  /// Of each source a line, as `credit_of`.
  std::vector<std::string> credits() const;
  /// The titles in a row.
  std::string title() const;

 private:
  FilmRenderer(film::Composition film, std::vector<FilmSource> sources, film::TimeMap map)
      : film_(std::move(film)), sources_(std::move(sources)), map_(std::move(map)) {}
  PaneLook look_of(std::size_t source) const;
  Status make_panes(Diagnostics& diagnostics);
  /// An inset whose share has keys has another size from frame to frame.
  Status fit_inset(double film_s);
  /// The next source with a scene of its own; its own number if there is none.
  std::size_t other_of(std::size_t source) const;

  film::Composition film_;
  std::vector<FilmSource> sources_;
  film::TimeMap map_;
  std::vector<film::Cell> cells_;
  std::vector<std::unique_ptr<FilmPane>> panes_;
};

}  // namespace trocar::workbench
