#include "engine/core/image.h"

#include <algorithm>
#include <cstdlib>

namespace trocar {
namespace {

std::size_t offset(const Image& image, int x, int y) {
  return 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x));
}

}  // namespace

Image::Image(int w, int h, Rgba fill)
    : width(w), height(h), rgba(4 * static_cast<std::size_t>(w) * static_cast<std::size_t>(h)) {
  for (std::size_t i = 0; i < rgba.size(); i += 4) {
    rgba[i] = fill.r;
    rgba[i + 1] = fill.g;
    rgba[i + 2] = fill.b;
    rgba[i + 3] = fill.a;
  }
}

Rgba Image::at(int x, int y) const {
  const std::size_t i = offset(*this, x, y);
  return {rgba[i], rgba[i + 1], rgba[i + 2], rgba[i + 3]};
}

void Image::set(int x, int y, Rgba colour) {
  const std::size_t i = offset(*this, x, y);
  rgba[i] = colour.r;
  rgba[i + 1] = colour.g;
  rgba[i + 2] = colour.b;
  rgba[i + 3] = colour.a;
}

ImageDifference difference(const Image& a, const Image& b) {
  if (a.width != b.width || a.height != b.height) return {255.0, 255};
  if (a.rgba.empty()) return {};
  ImageDifference result;
  double sum = 0.0;
  for (std::size_t i = 0; i < a.rgba.size(); ++i) {
    const int step = std::abs(static_cast<int>(a.rgba[i]) - static_cast<int>(b.rgba[i]));
    sum += step;
    result.worst = std::max(result.worst, step);
  }
  result.mean = sum / static_cast<double>(a.rgba.size());
  return result;
}

}  // namespace trocar
