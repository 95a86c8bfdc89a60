/// One frame of a film before it is rendered, as the window shows it.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

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
  std::string warning;                   ///< What the renderer says about the film; "": nothing.
  std::string error;
};

}  // namespace trocar::workbench
