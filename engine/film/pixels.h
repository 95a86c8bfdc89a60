/// Parts of pictures: captions touch few pixels, so only those go through the drawing library. Private to the module.
#pragma once

#include "engine/core/image.h"

namespace trocar::film {

/// A part of a picture in whole pixels.
struct Part {
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;
};

/// What of `part` lies inside of a picture of that size; may be empty.
Part clipped(const Part& part, int width, int height);
/// Precondition: inside of `image`.
Image copy_of(const Image& image, const Part& part);
/// Precondition: `piece` at (x, y) lies inside of `image`.
void put(Image& image, const Image& piece, int x, int y);

}  // namespace trocar::film
