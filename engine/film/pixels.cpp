#include "engine/film/pixels.h"

#include <algorithm>
#include <cstring>

#include "engine/core/check.h"

namespace trocar::film {
namespace {

std::size_t offset(const Image& image, int x, int y) {
  return 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x));
}

}  // namespace

Part clipped(const Part& part, int width, int height) {
  const int left = std::clamp(part.x, 0, width);
  const int top = std::clamp(part.y, 0, height);
  const int right = std::clamp(part.x + part.width, left, width);
  const int bottom = std::clamp(part.y + part.height, top, height);
  return {left, top, right - left, bottom - top};
}

Image copy_of(const Image& image, const Part& part) {
  TROCAR_CHECK(part.x >= 0 && part.y >= 0 && part.x + part.width <= image.width &&
               part.y + part.height <= image.height);
  Image out;
  out.width = part.width;
  out.height = part.height;
  out.rgba.resize(4 * static_cast<std::size_t>(part.width) * static_cast<std::size_t>(part.height));
  for (int y = 0; y < part.height; ++y) {
    std::memcpy(out.rgba.data() + offset(out, 0, y), image.rgba.data() + offset(image, part.x, part.y + y),
                4 * static_cast<std::size_t>(part.width));
  }
  return out;
}

void put(Image& image, const Image& piece, int x, int y) {
  TROCAR_CHECK(x >= 0 && y >= 0 && x + piece.width <= image.width && y + piece.height <= image.height);
  for (int row = 0; row < piece.height; ++row) {
    std::memcpy(image.rgba.data() + offset(image, x, y + row), piece.rgba.data() + offset(piece, 0, row),
                4 * static_cast<std::size_t>(piece.width));
  }
}

}  // namespace trocar::film
