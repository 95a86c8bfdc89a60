#include "engine/plot/opacity_curve.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "engine/core/check.h"

namespace trocar::plot {
namespace {

constexpr std::array<std::string_view, kOpacityPresets.size()> kPresetNames{"ramp", "highest", "lowest", "uniform"};
constexpr int kPlaces = 64;
/// Of all values, in one of these places: they are what the rest stands out from.
constexpr double kCommon = 1.0 / 3.0;
constexpr double kFaintShare = 0.7;
constexpr double kFaintHeight = 0.12;

std::optional<double> share_from(std::string_view text) {
  double value = 0.0;
  const auto parsed = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = parsed.ec == std::errc{} && parsed.ptr == text.data() + text.size();
  if (!whole || !(value >= 0.0 && value <= 1.0)) return std::nullopt;
  return value;
}

std::optional<OpacityKnot> knot_from(std::string_view text) {
  const std::size_t colon = text.find(':');
  if (colon == std::string_view::npos) return std::nullopt;
  const std::optional<double> position = share_from(text.substr(0, colon));
  const std::optional<double> height = share_from(text.substr(colon + 1));
  if (!position || !height) return std::nullopt;
  return OpacityKnot{*position, *height};
}

/// The place from which the others are told apart.
double quiet_place(const Colouring& colouring, const std::vector<double>& positions) {
  std::array<std::size_t, kPlaces> counts{};
  for (const double position : positions) ++counts[std::min<std::size_t>(std::size_t(position * kPlaces), kPlaces - 1)];
  const auto most = std::max_element(counts.begin(), counts.end());
  const bool rest = *most < positions.size();  // Without it nothing would be seen.
  if (rest && static_cast<double>(*most) >= kCommon * static_cast<double>(positions.size())) {
    const auto place = static_cast<double>(most - counts.begin());
    // The ends are theirs who lie in the outermost places.
    if (place == 0.0) return 0.0;
    return place == kPlaces - 1.0 ? 1.0 : (place + 0.5) / kPlaces;
  }
  return colouring.map == ColourMap::kDiverging ? 0.5 : 0.0;
}

/// To typed precision, so that what is written reads as it was.
double to_thousandths(double value) {
  return std::round(1e3 * value) / 1e3;
}

}  // namespace

double OpacityCurve::at(double position) const {
  TROCAR_ASSERT(!knots.empty());
  const auto after =
      std::find_if(knots.begin(), knots.end(), [&](const auto& knot) { return knot.position > position; });
  if (after == knots.begin()) return knots.front().height;
  if (after == knots.end()) return knots.back().height;
  const OpacityKnot& before = *(after - 1);
  const double along = (position - before.position) / (after->position - before.position);
  return before.height + along * (after->height - before.height);
}

double OpacityCurve::highest(double low, double high) const {
  double most = std::max(at(low), at(high));
  for (const OpacityKnot& knot : knots) {
    if (knot.position > low && knot.position < high) most = std::max(most, knot.height);
  }
  return most;
}

std::string_view to_string(OpacityPreset preset) {
  return kPresetNames[static_cast<std::size_t>(preset)];
}

OpacityCurve opacity_curve(OpacityPreset preset) {
  switch (preset) {
    case OpacityPreset::kRamp:
      break;
    case OpacityPreset::kHighest:
      return {{{0.8, 0.0}, {0.95, 1.0}}};
    case OpacityPreset::kLowest:
      return {{{0.05, 1.0}, {0.2, 0.0}}};
    case OpacityPreset::kUniform:
      return {{{0.0, 0.3}, {1.0, 0.3}}};
  }
  return {{{0.0, 0.0}, {1.0, 1.0}}};
}

std::optional<OpacityPreset> preset_of(const OpacityCurve& curve) {
  for (const OpacityPreset preset : kOpacityPresets) {
    if (curve == opacity_curve(preset)) return preset;
  }
  return std::nullopt;
}

std::string to_string(const OpacityCurve& curve) {
  if (const auto preset = preset_of(curve)) return std::string(to_string(*preset));
  std::string text;
  for (const OpacityKnot& knot : curve.knots) {
    if (!text.empty()) text += '/';
    text += fmt::format("{:.6g}:{:.6g}", knot.position, knot.height);
  }
  return text;
}

Result<OpacityCurve> opacity_curve_from(std::string_view text) {
  for (const OpacityPreset preset : kOpacityPresets) {
    if (text == to_string(preset)) return opacity_curve(preset);
  }
  OpacityCurve curve;
  curve.knots.clear();
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find('/', at), text.size());
    const std::optional<OpacityKnot> knot = knot_from(text.substr(at, end - at));
    const bool after = knot && (curve.knots.empty() || curve.knots.back().position < knot->position);
    if (!after || curve.knots.size() == kMostOpacityKnots) {
      return fail(ErrorCode::kInvalidArgument,
                  fmt::format("\"{}\" is no curve of opacity; write ramp, highest, lowest, uniform, or up to {} knots "
                              "such as 0:0/0.6:0.1/1:1, place on the scale and height, both 0 to 1, in their order",
                              text, kMostOpacityKnots));
    }
    curve.knots.push_back(*knot);
    at = end + 1;
  }
  return curve;
}

OpacityCurve fitted_opacity(const Colouring& colouring, const std::vector<double>& values) {
  std::vector<double> positions;
  positions.reserve(values.size());
  for (const double value : values) {
    if (std::isfinite(value)) positions.push_back(colouring.scale.position(value));
  }
  if (positions.empty()) return {};
  const double quiet = to_thousandths(quiet_place(colouring, positions));
  const double farthest = std::max(quiet, 1.0 - quiet);
  for (double& position : positions) position = std::abs(position - quiet);
  const auto place = static_cast<std::size_t>(kFaintShare * static_cast<double>(positions.size() - 1));
  std::nth_element(positions.begin(), positions.begin() + static_cast<std::ptrdiff_t>(place), positions.end());
  const double faint = to_thousandths(std::min(positions[place], 0.95 * farthest));
  const double height = to_thousandths(std::min(kFaintHeight, faint / farthest));
  const auto height_at = [&](double distance) {
    if (distance <= faint) return faint > 0.0 ? height * distance / faint : 0.0;
    return height + (1.0 - height) * (distance - faint) / (farthest - faint);
  };
  OpacityCurve curve;
  curve.knots.clear();
  const auto add = [&curve](double position, double h) {
    if (position < 0.0 || position > 1.0) return;
    if (!curve.knots.empty() && position < curve.knots.back().position + 5e-4) return;
    curve.knots.push_back({to_thousandths(position), to_thousandths(h)});
  };
  if (quiet > 0.0) add(0.0, height_at(quiet));
  if (faint > 0.0 && quiet > 0.0) add(quiet - faint, height);
  add(quiet, 0.0);
  if (faint > 0.0 && quiet < 1.0) add(quiet + faint, height);
  if (quiet < 1.0) add(1.0, height_at(1.0 - quiet));
  return curve;
}

}  // namespace trocar::plot
