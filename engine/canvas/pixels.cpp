#include "engine/canvas/pixels.h"

#include <algorithm>
#include <cstring>

namespace trocar::canvas {
namespace {

std::uint32_t times_alpha(std::uint32_t value, std::uint32_t alpha) {
  const std::uint32_t product = value * alpha + 128;
  return (product + (product >> 8U)) >> 8U;
}

std::uint32_t premultiplied(std::uint32_t abgr) {
  const std::uint32_t a = abgr >> 24U;
  const std::uint32_t r = times_alpha(abgr & 0xFFU, a);
  const std::uint32_t g = times_alpha(abgr >> 8U & 0xFFU, a);
  const std::uint32_t b = times_alpha(abgr >> 16U & 0xFFU, a);
  return a << 24U | r << 16U | g << 8U | b;
}

std::uint32_t straight(std::uint32_t argb) {
  const std::uint32_t a = argb >> 24U;
  if (a == 0) return 0;
  const auto divided = [a](std::uint32_t value) { return std::min(255U, (value * 255U + a / 2) / a); };
  return a << 24U | divided(argb & 0xFFU) << 16U | divided(argb >> 8U & 0xFFU) << 8U | divided(argb >> 16U & 0xFFU);
}

/// Red and blue change places; all there is to do for an opaque pixel, either way. Little-endian.
std::uint32_t swapped(std::uint32_t pixel) {
  return (pixel & 0xFF00FF00U) | (pixel & 0xFFU) << 16U | (pixel >> 16U & 0xFFU);
}

/// Converts a row; the whole opaque ones, which are nearly all, in a loop that the compiler makes wide.
template <typename Convert>
void convert_row(const std::uint8_t* from, std::uint8_t* to, std::size_t width, Convert convert) {
  std::uint32_t all = 0xFFFFFFFFU;
  for (std::size_t x = 0; x < width; ++x) {
    std::uint32_t pixel = 0;
    std::memcpy(&pixel, from + 4 * x, 4);
    all &= pixel;
    pixel = swapped(pixel);
    std::memcpy(to + 4 * x, &pixel, 4);
  }
  if (all >> 24U == 0xFFU) return;
  for (std::size_t x = 0; x < width; ++x) {
    std::uint32_t pixel = 0;
    std::memcpy(&pixel, from + 4 * x, 4);
    pixel = convert(pixel);
    std::memcpy(to + 4 * x, &pixel, 4);
  }
}

}  // namespace

cairo_surface_t* surface_from(const Image& image) {
  cairo_surface_t* surface =
      cairo_image_surface_create(CAIRO_FORMAT_ARGB32, std::max(1, image.width), std::max(1, image.height));
  if (image.empty() || cairo_surface_status(surface) != CAIRO_STATUS_SUCCESS) return surface;
  std::uint8_t* pixels = cairo_image_surface_get_data(surface);
  const auto stride = static_cast<std::size_t>(cairo_image_surface_get_stride(surface));
  const auto width = static_cast<std::size_t>(image.width);
  for (std::size_t y = 0; y < static_cast<std::size_t>(image.height); ++y) {
    convert_row(image.rgba.data() + 4 * width * y, pixels + stride * y, width, premultiplied);
  }
  cairo_surface_mark_dirty(surface);
  return surface;
}

Image image_from(cairo_surface_t* surface) {
  cairo_surface_flush(surface);
  Image image(cairo_image_surface_get_width(surface), cairo_image_surface_get_height(surface));
  const std::uint8_t* pixels = cairo_image_surface_get_data(surface);
  if (pixels == nullptr) return image;
  const auto stride = static_cast<std::size_t>(cairo_image_surface_get_stride(surface));
  const auto width = static_cast<std::size_t>(image.width);
  for (std::size_t y = 0; y < static_cast<std::size_t>(image.height); ++y) {
    convert_row(pixels + stride * y, image.rgba.data() + 4 * width * y, width, straight);
  }
  return image;
}

}  // namespace trocar::canvas
