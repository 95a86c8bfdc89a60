/// Which columns of a foreign table are what, and in which units and frame; kept as a small JSON file.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/result.h"

namespace trocar::exchange {

/// A column by the name in the table's header, or as "#3" by its place, from 1; in JSON that is the number 3.
using ColumnName = std::string;

struct PositionColumns {
  std::vector<ColumnName> columns;  ///< x, y, z of the tool tip.
  std::string unit = "m";           ///< m, cm, mm.
};

struct RotationColumns {
  std::vector<ColumnName> columns;       ///< 4, 9 or 3.
  std::string kind = "quaternion_xyzw";  ///< Or quaternion_wxyz, matrix_rows, matrix_columns, euler.
  std::string order = "xyz";  ///< Of Euler angles: lower case about fixed axes, upper case about moving ones.
  std::string unit = "rad";   ///< Of Euler angles: rad, deg.
};

struct JawColumn {
  ColumnName column;
  std::string unit = "rad";  ///< rad, deg; or ratio: `closed` … `open` in the table are 0 … `open_deg` of the jaws.
  double closed = 0.0;
  double open = 1.0;
  double open_deg = 60.0;
};

/// In place of position and rotation: the tool is where the arm's forward kinematics puts it on the board.
struct JointColumns {
  std::vector<ColumnName> columns;   ///< Yaw, pitch, insertion, roll, wrist pitch, wrist yaw.
  std::string unit = "rad";          ///< rad, deg.
  std::string insertion_unit = "m";  ///< m, cm, mm.
};

struct ArmColumns {
  std::optional<PositionColumns> position;
  std::optional<RotationColumns> rotation;
  std::optional<JawColumn> jaw;
  std::optional<JointColumns> joints;

  bool empty() const { return !position && !joints; }
};

struct TimeColumn {
  ColumnName column;       ///< Empty: by the rate.
  std::string unit = "s";  ///< s, ms, us, ns.
  double rate_hz = 0.0;
};

/// From the table's frame F to the board W: mirrored (x, y or z: that axis is turned round, as for a left-handed
/// source), scaled, turned, moved, in that order.
struct FrameMap {
  std::string mirror = "none";
  double scale = 1.0;
  std::array<double, 4> rotation_wxyz{1.0, 0.0, 0.0, 0.0};
  std::array<double, 3> translation_m{};
};

struct ColumnMap {
  // Of text alone.
  std::string delimiter = ",";  ///< , ; | tab, or space for blanks in any number.
  std::string decimal = ".";    ///< Or a comma.
  std::string comment = "#";    ///< Lines that begin with it are left out; may be empty.
  int header_lines = 1;         ///< The last of them names the columns; 0: they have numbers only.

  TimeColumn time;
  std::array<ArmColumns, 2> arms;  ///< left, right.
  FrameMap frame;
};

std::string to_json(const ColumnMap& map);
/// Errors: kInvalidArgument naming what is missing, unknown or out of range.
Result<ColumnMap> column_map_from_json(std::string_view json);

/// How many metres, radians or seconds one of a unit is: m, cm, mm; rad, deg; s, ms, us, ns.
double unit_factor(std::string_view unit);

}  // namespace trocar::exchange
