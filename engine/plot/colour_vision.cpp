#include "engine/plot/colour_vision.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace trocar::plot {
namespace {

constexpr std::array<std::string_view, 5> kVisionNames{"full", "protan", "deutan", "tritan", "grey"};

/// Rows of a matrix on linear red, green and blue.
using Matrix = std::array<std::array<double, 3>, 3>;

constexpr Matrix kProtan{
    {{0.152286, 1.052583, -0.204868}, {0.114503, 0.786281, 0.099216}, {-0.003882, -0.048116, 1.051998}}};
constexpr Matrix kDeutan{
    {{0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881}}};
constexpr Matrix kTritan{
    {{1.255528, -0.076749, -0.178779}, {-0.078411, 0.930809, 0.147602}, {0.004733, 0.691367, 0.303900}}};
constexpr Matrix kGrey{{{0.2126, 0.7152, 0.0722}, {0.2126, 0.7152, 0.0722}, {0.2126, 0.7152, 0.0722}}};

const Matrix& matrix_of(ColourVision vision) {
  switch (vision) {
    case ColourVision::kProtan:
      return kProtan;
    case ColourVision::kDeutan:
      return kDeutan;
    case ColourVision::kTritan:
      return kTritan;
    default:
      return kGrey;
  }
}

std::array<double, 256> linear_table() {
  std::array<double, 256> table{};
  for (std::size_t i = 0; i < table.size(); ++i) {
    const double v = static_cast<double>(i) / 255.0;
    table[i] = v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
  }
  return table;
}

constexpr std::size_t kFineness = 4096;

std::array<std::uint8_t, kFineness + 1> srgb_table() {
  std::array<std::uint8_t, kFineness + 1> table{};
  for (std::size_t i = 0; i < table.size(); ++i) {
    const double v = static_cast<double>(i) / kFineness;
    const double s = v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1.0 / 2.4) - 0.055;
    table[i] = static_cast<std::uint8_t>(std::lround(255.0 * s));
  }
  return table;
}

}  // namespace

std::string_view to_string(ColourVision vision) {
  return kVisionNames[static_cast<std::size_t>(vision)];
}

Result<ColourVision> colour_vision_from(std::string_view text) {
  const auto* found = std::find(kVisionNames.begin(), kVisionNames.end(), text);
  if (found != kVisionNames.end()) return static_cast<ColourVision>(found - kVisionNames.begin());
  return fail(ErrorCode::kInvalidArgument,
              "no colour vision is named \"" + std::string(text) + "\"; there are full, protan, deutan, tritan, grey");
}

const std::vector<ColourVision>& all_colour_visions() {
  static const std::vector<ColourVision> visions{ColourVision::kFull, ColourVision::kProtan, ColourVision::kDeutan,
                                                 ColourVision::kTritan, ColourVision::kGrey};
  return visions;
}

Rgba seen_with(ColourVision vision, Rgba colour) {
  if (vision == ColourVision::kFull) return colour;
  static const std::array<double, 256> kLinear = linear_table();
  static const std::array<std::uint8_t, kFineness + 1> kSrgb = srgb_table();
  const Matrix& m = matrix_of(vision);
  const std::array<double, 3> in{kLinear[colour.r], kLinear[colour.g], kLinear[colour.b]};
  const auto channel = [&](std::size_t row) {
    const double v = m[row][0] * in[0] + m[row][1] * in[1] + m[row][2] * in[2];
    return kSrgb[static_cast<std::size_t>(std::lround(std::clamp(v, 0.0, 1.0) * kFineness))];
  };
  return {channel(0), channel(1), channel(2), colour.a};
}

}  // namespace trocar::plot
