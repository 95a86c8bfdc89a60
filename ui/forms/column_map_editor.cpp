#include "ui/forms/column_map_editor.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

#include "ui/icons.h"

namespace trocar::ui {
namespace {

using exchange::ArmColumns;
using exchange::ColumnName;

constexpr std::array<std::string_view, 6> kJointNames{"Yaw", "Pitch", "Insertion", "Roll", "Wrist pitch", "Wrist yaw"};
const std::vector<std::string> kLengths{"m", "cm", "mm"};
const std::vector<std::string> kAngles{"rad", "deg"};

std::size_t columns_of(std::string_view rotation_kind) {
  return rotation_kind.starts_with("quaternion") ? 4 : rotation_kind.starts_with("matrix") ? 9 : 3;
}

/// Names of the parts of a rotation, in the order in which the map has them.
std::string part_of_rotation(std::string_view kind, std::size_t i) {
  if (kind.starts_with("matrix")) return fmt::format("r{}{}", i / 3 + 1, i % 3 + 1);
  if (kind == "euler") return fmt::format("Angle {}", i + 1);
  const std::string_view order = kind == "quaternion_wxyz" ? "wxyz" : "xyzw";
  return fmt::format("q{}", order[i]);
}

/// "0.1, 2" as numbers; false unless there are as many as are wanted.
bool parse_numbers(std::string_view text, const std::vector<double*>& into) {
  std::vector<double> read;
  while (!text.empty()) {
    const std::size_t begin = text.find_first_not_of(" ,;");
    if (begin == std::string_view::npos) break;
    text.remove_prefix(begin);
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{}) return false;
    read.push_back(value);
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  }
  if (read.size() != into.size()) return false;
  for (std::size_t i = 0; i < read.size(); ++i) *into[i] = read[i];
  return true;
}

/// The columns that follow `first` in the table, as many as are wanted: what belongs together mostly stands together.
std::vector<ColumnName> run_of(const std::vector<exchange::TableColumn>& columns, std::size_t first,
                               std::size_t count) {
  std::vector<ColumnName> names;
  for (std::size_t i = 0; i < count; ++i) {
    names.push_back(columns.empty() ? "#1" : columns[std::min(first + i, columns.size() - 1)].name);
  }
  return names;
}

}  // namespace

bool ColumnMapEditor::choose(Ui& ui, std::string_view label, std::string& chosen, const std::vector<std::string>& names,
                             std::string_view help) {
  form_label(ui, label);
  int at = static_cast<int>(std::find(names.begin(), names.end(), chosen) - names.begin());
  if (at == static_cast<int>(names.size())) at = 0;
  if (!combo(ui, label, at, names, {.help = help})) return false;
  chosen = names[static_cast<std::size_t>(at)];
  return true;
}

bool ColumnMapEditor::choose_column(Ui& ui, std::string_view label, ColumnName& chosen, std::string_view none) {
  std::vector<std::string> names;
  std::vector<ColumnName> values;
  if (!none.empty()) {
    names.emplace_back(none);
    values.emplace_back();
  }
  for (const exchange::TableColumn& column : *columns_) {
    names.push_back(column.cells.empty() ? column.name : fmt::format("{}   {}", column.name, column.cells.front()));
    values.push_back(column.name);
  }
  int at = static_cast<int>(std::find(values.begin(), values.end(), chosen) - values.begin());
  if (at == static_cast<int>(values.size())) {
    // A column that the table does not have stays until another is chosen.
    names.push_back(chosen + " (not there)");
    values.push_back(chosen);
  }
  form_label(ui, label);
  if (!combo(ui, label, at, names, {.help = "The column of the table, with its first number"})) return false;
  chosen = values[static_cast<std::size_t>(at)];
  return true;
}

bool ColumnMapEditor::type_numbers(Ui& ui, std::string_view label, std::vector<double*> numbers,
                                   std::string_view help) {
  std::string told;
  for (const double* number : numbers) told += fmt::format("{}{:g}", told.empty() ? "" : ", ", *number);
  const std::string path = ui.items().path_of(label);
  const auto typed = typed_.find(path);
  std::string text = typed == typed_.end() ? told : typed->second;
  form_label(ui, label);
  const bool finished = text_field(ui, label, text, "", {.help = help});
  typed_.erase(path);
  if (finished) return parse_numbers(text, numbers);
  if (text != told) typed_[path] = text;
  return false;
}

bool ColumnMapEditor::draw_layout(Ui& ui, exchange::ColumnMap& map) {
  const Scope scope(ui, "Text");
  static const std::vector<std::string> kDelimiters{",", ";", "tab", "|", "space"};
  static const std::vector<std::string> kDecimals{".", ","};
  bool changed = choose(ui, "Between cells", map.delimiter, kDelimiters, "What parts the cells of a line");
  changed |= choose(ui, "Decimal sign", map.decimal, kDecimals, "In front of the decimals");
  double header = map.header_lines;
  if (type_numbers(ui, "Header lines", {&header}, "The last of them names the columns; 0: none does")) {
    map.header_lines = static_cast<int>(std::clamp(header, 0.0, 100.0));
    changed = true;
  }
  return changed;
}

bool ColumnMapEditor::draw_time(Ui& ui, exchange::TimeColumn& time) {
  static const std::vector<std::string> kUnits{"s", "ms", "us", "ns"};
  bool changed = choose_column(ui, "Time", time.column, "By the rate");
  if (!time.column.empty()) {
    if (changed) time.rate_hz = 0.0;
    return choose(ui, "Time unit", time.unit, kUnits, "Of the numbers in the column") || changed;
  }
  if (changed && time.rate_hz <= 0.0) time.rate_hz = 30.0;
  return type_numbers(ui, "Rate, Hz", {&time.rate_hz}, "Rows in each second") || changed;
}

bool ColumnMapEditor::draw_rotation(Ui& ui, ArmColumns& arm) {
  static const std::vector<std::string> kKinds{"none",        "quaternion_xyzw", "quaternion_wxyz",
                                               "matrix_rows", "matrix_columns",  "euler"};
  static const std::vector<std::string> kOrders{"xyz", "xzy", "yxz", "yzx", "zxy", "zyx",
                                                "XYZ", "XZY", "YXZ", "YZX", "ZXY", "ZYX"};
  std::string kind = arm.rotation ? arm.rotation->kind : "none";
  bool changed = choose(ui, "Rotation", kind, kKinds, "How the turn of the tool is written; none: it points down");
  if (changed && kind == "none") arm.rotation.reset();
  if (changed && kind != "none") {
    if (!arm.rotation) arm.rotation.emplace();
    arm.rotation->kind = kind;
    if (arm.rotation->columns.size() != columns_of(kind))
      arm.rotation->columns = run_of(*columns_, 0, columns_of(kind));
  }
  if (!arm.rotation) return changed;
  exchange::RotationColumns& rotation = *arm.rotation;
  for (std::size_t i = 0; i < rotation.columns.size(); ++i) {
    changed |= choose_column(ui, part_of_rotation(rotation.kind, i), rotation.columns[i]);
  }
  if (rotation.kind != "euler") return changed;
  changed |= choose(ui, "Order", rotation.order, kOrders, "Small letters: about fixed axes; capitals: moving ones");
  return choose(ui, "Rotation unit", rotation.unit, kAngles, "Of the angles") || changed;
}

bool ColumnMapEditor::draw_jaw(Ui& ui, ArmColumns& arm) {
  static const std::vector<std::string> kUnits{"rad", "deg", "ratio"};
  ColumnName column = arm.jaw ? arm.jaw->column : "";
  bool changed = choose_column(ui, "Jaw", column, "None");
  if (changed && column.empty()) arm.jaw.reset();
  if (changed && !column.empty()) {
    if (!arm.jaw) arm.jaw.emplace();
    arm.jaw->column = column;
  }
  if (!arm.jaw) return changed;
  changed |= choose(ui, "Jaw unit", arm.jaw->unit, kUnits, "A ratio goes from closed to open");
  if (arm.jaw->unit != "ratio") return changed;
  return type_numbers(ui, "Closed, open, °", {&arm.jaw->closed, &arm.jaw->open, &arm.jaw->open_deg},
                      "The numbers in the table for closed and open, and how wide open is in degrees") ||
         changed;
}

bool ColumnMapEditor::draw_arm(Ui& ui, ArmColumns& arm) {
  static const std::vector<std::string> kKinds{"Not there", "Position", "Joints"};
  int kind = arm.joints ? 2 : arm.position ? 1 : 0;
  form_label(ui, "Given by");
  bool changed = segmented(ui, "Given by", kind, kKinds,
                           {.help = "Where the tool is in space, or the angles of the arm's joints"});
  if (changed) {
    arm = {};
    if (kind == 1) arm.position = exchange::PositionColumns{run_of(*columns_, 0, 3), "m"};
    if (kind == 2) arm.joints = exchange::JointColumns{run_of(*columns_, 0, kJointNames.size()), "rad", "m"};
  }
  if (arm.position) {
    constexpr std::array<std::string_view, 3> kAxes{"x", "y", "z"};
    for (std::size_t i = 0; i < arm.position->columns.size() && i < kAxes.size(); ++i) {
      changed |= choose_column(ui, kAxes[i], arm.position->columns[i]);
    }
    changed |= choose(ui, "Unit", arm.position->unit, kLengths, "Of the three");
    changed |= draw_rotation(ui, arm);
  }
  if (arm.joints) {
    for (std::size_t i = 0; i < arm.joints->columns.size() && i < kJointNames.size(); ++i) {
      changed |= choose_column(ui, kJointNames[i], arm.joints->columns[i]);
    }
    changed |= choose(ui, "Unit", arm.joints->unit, kAngles, "Of the angles");
    changed |= choose(ui, "Insertion unit", arm.joints->insertion_unit, kLengths, "Of the third joint");
  }
  return arm.empty() ? changed : draw_jaw(ui, arm) || changed;
}

bool ColumnMapEditor::draw_frame(Ui& ui, exchange::FrameMap& frame) {
  static const std::vector<std::string> kMirrors{"none", "x", "y", "z"};
  bool changed =
      choose(ui, "Turned round", frame.mirror, kMirrors, "For a left-handed source: this axis is turned round");
  changed |= type_numbers(ui, "Scale", {&frame.scale}, "Lengths are multiplied by it");
  auto& q = frame.rotation_wxyz;
  changed |= type_numbers(ui, "Turn w, x, y, z", {&q[0], &q[1], &q[2], &q[3]},
                          "The quaternion from the table's axes to those of the board");
  std::array<double, 3> p_mm{};
  for (std::size_t i = 0; i < p_mm.size(); ++i) p_mm[i] = 1e3 * frame.translation_m[i];
  if (type_numbers(ui, "Move x, y, z, mm", {p_mm.data(), p_mm.data() + 1, p_mm.data() + 2},
                   "Where the table's origin is on the board, in its frame")) {
    for (std::size_t i = 0; i < p_mm.size(); ++i) frame.translation_m[i] = 1e-3 * p_mm[i];
    changed = true;
  }
  return changed;
}

bool ColumnMapEditor::draw(Ui& ui, exchange::ColumnMap& map, const std::vector<exchange::TableColumn>& columns,
                           bool text) {
  const Scope scope(ui, "Map");
  columns_ = &columns;
  bool changed = text && draw_layout(ui, map);
  changed |= draw_time(ui, map.time);
  constexpr std::array<std::string_view, 2> kSides{"Left", "Right"};
  for (std::size_t side = 0; side < kSides.size(); ++side) {
    const Scope arm(ui, kSides[side]);
    heading(ui, side == 0 ? "Left arm" : "Right arm");
    changed |= draw_arm(ui, map.arms[side]);
  }
  if (button(ui, "Swap the arms", {.icon = icon::kRefresh, .help = "What is the left arm's becomes the right one's"})) {
    std::swap(map.arms[0], map.arms[1]);
    changed = true;
  }
  const Scope frame(ui, "Frame");
  heading(ui, "To the board");
  return draw_frame(ui, map.frame) || changed;
}

}  // namespace trocar::ui
