/// One frame of a film before it is rendered, as the window shows it.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "engine/core/image.h"
#include "engine/film/composition.h"

namespace trocar::workbench {

struct FilmPreview {
  film::Composition of;                  ///< As `look_of` leaves it.
  std::shared_ptr<const Image> picture;  ///< Null: `error` says why.
  std::uint64_t number = 0;              ///< Changes with each picture.
  int frame = 0;                         ///< Its number in the film …
  int frames = 0;                        ///< … which has so many, loops included.
  double length_s = 0.0;                 ///< Of one pass of the film.
  double common_s = 0.0;                 ///< Of what its sources have in common, as `film::Hold` counts.
  /// What there is of each source, of its own time, whatever its gates; nothing of what stands still.
  std::vector<std::array<double, 2>> spans_s;
  std::string warning;  ///< What the renderer says about the film; "": nothing.
  std::string error;
};

}  // namespace trocar::workbench
