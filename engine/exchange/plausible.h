/// What no recording of a surgical tool reaches: beyond it, another unit or another thing was meant. Private to the
/// module.
#pragma once

namespace trocar::exchange {

/// A month; beyond it a time is surely in another unit.
constexpr double kLongest_s = 2.7e6;
constexpr double kFarthest_m = 1000.0;
/// Further from a rotation than any rounding explains: of a quaternion's length from 1, of a matrix's rows from unit
/// vectors at right angles.
constexpr double kFarFromRotation = 0.1;
/// What the digits of a file explain.
constexpr double kRounded = 1e-5;

}  // namespace trocar::exchange
