/// A picture in memory: 8-bit RGBA, rows from the top, no padding.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace trocar {

/// Straight (not premultiplied) 8-bit colour in sRGB.
struct Rgba {
  std::uint8_t r = 0;
  std::uint8_t g = 0;
  std::uint8_t b = 0;
  std::uint8_t a = 255;
  bool operator==(const Rgba&) const = default;
};

struct Image {
  int width = 0;                   ///< Pixels.
  int height = 0;                  ///< Pixels.
  std::vector<std::uint8_t> rgba;  ///< 4 · width · height bytes.

  Image() = default;
  Image(int w, int h, Rgba fill = {0, 0, 0, 255});

  bool empty() const { return width == 0 || height == 0; }
  Rgba at(int x, int y) const;
  void set(int x, int y, Rgba colour);
  bool operator==(const Image&) const = default;
};

/// How far two pictures of one size are apart, in steps of 255; for golden pictures. Sizes that differ give 255.
struct ImageDifference {
  double mean = 0.0;
  int worst = 0;
};
ImageDifference difference(const Image& a, const Image& b);

}  // namespace trocar
