#include "engine/plot/oklab.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace trocar::plot {
namespace {

using Triple = std::array<double, 3>;
using Matrix = std::array<Triple, 3>;

Triple product(const Matrix& m, const Triple& v) {
  Triple out{};
  for (std::size_t i = 0; i < 3; ++i) out[i] = m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2];
  return out;
}

double linear_from_srgb(std::uint8_t byte) {
  const double s = byte / 255.0;
  return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
}

std::uint8_t srgb_from_linear(double linear) {
  const double s = linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
  return static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(s, 0.0, 1.0)));
}

Triple linear_of(Rgba c) {
  return {linear_from_srgb(c.r), linear_from_srgb(c.g), linear_from_srgb(c.b)};
}

Rgba srgb_of(const Triple& linear) {
  return {srgb_from_linear(linear[0]), srgb_from_linear(linear[1]), srgb_from_linear(linear[2]), 255};
}

// Ottosson's published constants: linear sRGB to cone response, and its cube root to Oklab.
constexpr Matrix kConesFromRgb{{{0.4122214708, 0.5363325363, 0.0514459929},
                                {0.2119034982, 0.6806995451, 0.1073969566},
                                {0.0883024619, 0.2817188376, 0.6299787005}}};
constexpr Matrix kRgbFromCones{{{4.0767416621, -3.3077115913, 0.2309699292},
                                {-1.2684380046, 2.6097574011, -0.3413193965},
                                {-0.0041960863, -0.7034186147, 1.7076147010}}};
constexpr Matrix kLabFromRoots{{{0.2104542553, 0.7936177850, -0.0040720468},
                                {1.9779984951, -2.4285922050, 0.4505937099},
                                {0.0259040371, 0.7827717662, -0.8086757660}}};
constexpr Matrix kRootsFromLab{
    {{1.0, 0.3963377774, 0.2158037573}, {1.0, -0.1055613458, -0.0638541728}, {1.0, -0.0894841775, -1.2914855480}}};

}  // namespace

Oklab to_oklab(Rgba colour) {
  Triple cones = product(kConesFromRgb, linear_of(colour));
  for (double& x : cones) x = std::cbrt(x);
  const Triple lab = product(kLabFromRoots, cones);
  return {lab[0], lab[1], lab[2]};
}

Rgba from_oklab(const Oklab& colour) {
  Triple cones = product(kRootsFromLab, {colour.lightness, colour.a, colour.b});
  for (double& x : cones) x = x * x * x;
  return srgb_of(product(kRgbFromCones, cones));
}

Oklab oklab_of(double lightness, double chroma, double hue_rad) {
  return {lightness, chroma * std::cos(hue_rad), chroma * std::sin(hue_rad)};
}

double distance(const Oklab& x, const Oklab& y) {
  return std::hypot(x.lightness - y.lightness, x.a - y.a, x.b - y.b);
}

}  // namespace trocar::plot
