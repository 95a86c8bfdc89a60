/// How far the dVRK's jaws go; what checks report and edits refuse. A test holds it to the kinematics' model.
#pragma once

#include <numbers>

namespace trocar::demonstration {

constexpr double kJawLow_rad = -40.0 * std::numbers::pi / 180.0;
constexpr double kJawHigh_rad = 80.0 * std::numbers::pi / 180.0;
/// A jaw opens when it passes the one upwards, and closes when it passes the other downwards.
constexpr double kJawOpen_rad = 0.3;
constexpr double kJawClosed_rad = 0.1;
/// Faster than any jaw turns.
constexpr double kJawRate_rad_s = 8.0;
/// The rounding of an angle that was typed in degrees or kept in single precision.
constexpr double kJawRounding_rad = 1e-6;

}  // namespace trocar::demonstration
