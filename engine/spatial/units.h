/// The few conversions that files and screens need; inside everything is SI.
#pragma once

#include <numbers>

namespace trocar::spatial {

constexpr double kMetresPerMillimetre = 1e-3;
constexpr double kRadiansPerDegree = std::numbers::pi / 180.0;

constexpr double from_mm(double mm) {
  return mm * kMetresPerMillimetre;
}
constexpr double to_mm(double metres) {
  return metres / kMetresPerMillimetre;
}
constexpr double from_degrees(double degrees) {
  return degrees * kRadiansPerDegree;
}
constexpr double to_degrees(double radians) {
  return radians / kRadiansPerDegree;
}

}  // namespace trocar::spatial
