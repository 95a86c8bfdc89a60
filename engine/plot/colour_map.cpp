#include "engine/plot/colour_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>

#include "engine/plot/oklab.h"

namespace trocar::plot {
namespace {

constexpr int kSteps = 1024;
using Table = std::array<Rgba, kSteps + 1>;

constexpr Rgba hex(std::uint32_t rgb) {
  return {static_cast<std::uint8_t>(rgb >> 16U), static_cast<std::uint8_t>(rgb >> 8U), static_cast<std::uint8_t>(rgb),
          255};
}

// Evenly spaced colours of the published maps; between them a spline in Oklab is closer than a byte or two.
constexpr std::array kViridisKeys{0x440154U, 0x481568U, 0x482677U, 0x453781U, 0x3F4788U, 0x39558CU, 0x32648EU,
                                  0x2D718EU, 0x287D8EU, 0x238A8DU, 0x1F968BU, 0x20A386U, 0x29AF7FU, 0x3CBC75U,
                                  0x56C667U, 0x74D055U, 0x94D840U, 0xB8DE29U, 0xDCE318U, 0xFDE725U};
constexpr std::array kCividisKeys{0x00204DU, 0x00306FU, 0x2A406CU, 0x48526BU, 0x5E626EU, 0x727374U,
                                  0x878479U, 0x9E9677U, 0xB6A971U, 0xD0BE67U, 0xEAD357U, 0xFFEA46U};
constexpr std::array kMagmaKeys{0x000004U, 0x150E38U, 0x3B0F70U, 0x641A80U, 0x8C2981U, 0xB63679U,
                                0xDE4968U, 0xF76F5CU, 0xFE9F6DU, 0xFECE91U, 0xFCFDBFU};
constexpr std::array kTurboKeys{0x23171BU, 0x463699U, 0x4958DDU, 0x3E7BF7U, 0x2F9EF5U, 0x26BDE1U, 0x27D7C3U,
                                0x35EBA2U, 0x4EF983U, 0x6FFE67U, 0x96FA50U, 0xBDEF3EU, 0xDFDC32U, 0xF9C229U,
                                0xFFA323U, 0xFF801DU, 0xF45C17U, 0xD93B10U, 0xB82008U, 0x9B0F00U, 0x900D00U};
constexpr std::array kOkabeIto{0xE69F00U, 0x56B4E9U, 0x009E73U, 0xF0E442U, 0x0072B2U, 0xD55E00U, 0xCC79A7U, 0x000000U};
static_assert(kOkabeIto.size() == kCategoryCount);

/// Catmull–Rom through four values at −1, 0, 1, 2.
double spline(double p0, double p1, double p2, double p3, double u) {
  return p1 + 0.5 * u * (p2 - p0 + u * (2.0 * p0 - 5.0 * p1 + 4.0 * p2 - p3 + u * (3.0 * (p1 - p2) + p3 - p0)));
}

Oklab between(std::span<const Oklab> keys, double t) {
  const auto last = static_cast<std::ptrdiff_t>(keys.size()) - 1;
  const double at = t * static_cast<double>(last);
  const auto i = std::min(static_cast<std::ptrdiff_t>(at), last - 1);
  const double u = at - static_cast<double>(i);
  // Beyond the ends the curve is continued straight.
  const auto key = [&](std::ptrdiff_t k) -> Oklab {
    if (k >= 0 && k <= last) return keys[static_cast<std::size_t>(k)];
    const Oklab& end = keys[static_cast<std::size_t>(k < 0 ? 0 : last)];
    const Oklab& inner = keys[static_cast<std::size_t>(k < 0 ? 1 : last - 1)];
    return {2 * end.lightness - inner.lightness, 2 * end.a - inner.a, 2 * end.b - inner.b};
  };
  const std::array<Oklab, 4> p{key(i - 1), key(i), key(i + 1), key(i + 2)};
  return {spline(p[0].lightness, p[1].lightness, p[2].lightness, p[3].lightness, u),
          spline(p[0].a, p[1].a, p[2].a, p[3].a, u), spline(p[0].b, p[1].b, p[2].b, p[3].b, u)};
}

Table table_through(std::span<const std::uint32_t> rgb_keys) {
  std::vector<Oklab> keys;
  keys.reserve(rgb_keys.size());
  for (const std::uint32_t rgb : rgb_keys) keys.push_back(to_oklab(hex(rgb)));
  Table table;
  for (int i = 0; i <= kSteps; ++i) {
    table[static_cast<std::size_t>(i)] = from_oklab(between(keys, i / static_cast<double>(kSteps)));
  }
  return table;
}

Table grey_table() {
  Table table;
  for (int i = 0; i <= kSteps; ++i) {
    // Neither black nor white, so that both ends differ from lines and paper.
    table[static_cast<std::size_t>(i)] = from_oklab({0.20 + 0.75 * i / kSteps, 0.0, 0.0});
  }
  return table;
}

/// Blue below, orange above, the lightest and colourless in the middle; both sides equally dark at equal distance.
Table diverging_table() {
  constexpr double kBlue = 250.0 / 180.0 * std::numbers::pi;
  constexpr double kOrange = 52.0 / 180.0 * std::numbers::pi;
  Table table;
  for (int i = 0; i <= kSteps; ++i) {
    const double side = 2.0 * i / kSteps - 1.0;
    const double far = std::abs(side);
    const double lightness = 0.965 - 0.36 * far - 0.225 * far * far;
    const double chroma = 0.115 * std::sin(0.62 * std::numbers::pi * std::pow(far, 0.85));
    table[static_cast<std::size_t>(i)] = from_oklab(oklab_of(lightness, chroma, side < 0.0 ? kBlue : kOrange));
  }
  return table;
}

const Table& table_of(ColourMap map) {
  static const Table viridis = table_through(kViridisKeys);
  static const Table cividis = table_through(kCividisKeys);
  static const Table magma = table_through(kMagmaKeys);
  static const Table turbo = table_through(kTurboKeys);
  static const Table grey = grey_table();
  static const Table diverging = diverging_table();
  switch (map) {
    case ColourMap::kCividis:
      return cividis;
    case ColourMap::kMagma:
      return magma;
    case ColourMap::kTurbo:
      return turbo;
    case ColourMap::kGrey:
      return grey;
    case ColourMap::kDiverging:
      return diverging;
    default:
      return viridis;
  }
}

constexpr std::array<std::string_view, 7> kMapNames{"viridis", "cividis",   "magma",      "turbo",
                                                    "grey",    "diverging", "categorical"};

}  // namespace

std::string_view to_string(ColourMap map) {
  return kMapNames[static_cast<std::size_t>(map)];
}

Result<ColourMap> colour_map_from(std::string_view text) {
  for (std::size_t i = 0; i < kMapNames.size(); ++i) {
    if (kMapNames[i] == text) return static_cast<ColourMap>(i);
  }
  return fail(ErrorCode::kInvalidArgument,
              "no colour map is named \"" + std::string(text) +
                  "\"; there are viridis, cividis, magma, turbo, grey, diverging, categorical");
}

Rgba colour(ColourMap map, double t) {
  if (map == ColourMap::kCategorical) return category(std::isfinite(t) ? static_cast<int>(t) : 0);
  const double clamped = t > 0.0 ? std::min(t, 1.0) : 0.0;
  return table_of(map)[static_cast<std::size_t>(std::lround(clamped * kSteps))];
}

Rgba category(int number) {
  const int wrapped = ((number % kCategoryCount) + kCategoryCount) % kCategoryCount;
  return hex(kOkabeIto[static_cast<std::size_t>(wrapped)]);
}

}  // namespace trocar::plot
