/// What a column's name says. Private to the module.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace trocar::exchange {

enum class Quantity { kTime, kPosition, kQuaternion, kMatrix, kEuler, kJaw, kJoint };

struct NamedColumn {
  Quantity quantity = Quantity::kTime;
  int part = 0;      ///< x, y, z of a position, roll, pitch, yaw; x, y, z, w of a quaternion; row by row of a matrix; a
                     ///< joint from 0.
  int arm = -1;      ///< 0 left, 1 right, -1: the name does not tell.
  std::string unit;  ///< As in the name, or empty.
};

/// Nothing for a name that tells nothing of use. "PSM1.pose.position.x_mm", "left_qw", "Timestamp (ms)", "joint_3" …
std::optional<NamedColumn> understood(std::string_view name);

/// Lower-case words: parted by anything that is no letter or digit, and before a capital.
std::vector<std::string> words_of(std::string_view name);

/// The unit that the name says: "s" of "Zeit [s]"; empty if it says none.
std::string unit_in(std::string_view name);

}  // namespace trocar::exchange
