#include "engine/exchange/column_guess.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "engine/demonstration/name.h"
#include "engine/exchange/column_names.h"
#include "engine/exchange/number_table.h"
#include "engine/exchange/text_lines.h"

namespace trocar::exchange {
namespace {

/// As much of a file as is looked at.
constexpr std::size_t kRowsRead = 2000;
constexpr double kUsualRate_hz = 30.0;

/// The numbers of one column in the first rows; NaN where there is none.
using Values = std::vector<double>;

struct Looked {
  const NumberTable& table;
  std::vector<Values> columns;
};

Looked look_at(const NumberTable& table) {
  Looked looked{table, std::vector<Values>(table.width())};
  for (std::size_t row = 0; row < std::min(table.rows(), kRowsRead); ++row) {
    const std::vector<double> values = table.read_all(row);
    for (std::size_t i = 0; i < values.size(); ++i) looked.columns[i].push_back(values[i]);
  }
  return looked;
}

double largest(const Values& values) {
  double most = 0.0;
  for (const double value : values) most = std::isfinite(value) ? std::max(most, std::abs(value)) : most;
  return most;
}

bool numeric(const Values& values) {
  return std::count_if(values.begin(), values.end(), [](double value) { return std::isfinite(value); }) * 2 >
         static_cast<std::ptrdiff_t>(values.size());
}

double usual_step(const Values& values) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < values.size(); ++i) {
    if (std::isfinite(values[i] - values[i - 1])) steps.push_back(values[i] - values[i - 1]);
  }
  if (steps.empty()) return 0.0;
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  return *middle;
}

/// Recordings are made at 1 to 1000 Hz.
std::string time_unit(const Values& values) {
  const double step = usual_step(values);
  if (step > 2e5) return "ns";
  if (step > 2e3) return "us";
  return step > 1.0 ? "ms" : "s";
}

bool rises(const Values& values) {
  std::size_t up = 0;
  for (std::size_t i = 1; i < values.size(); ++i) up += values[i] > values[i - 1] ? 1 : 0;
  return values.size() > 1 && up * 10 >= (values.size() - 1) * 9;
}

/// True if the four columns from `first` are of length 1 together in nearly every row.
bool unit_length(const std::vector<Values>& columns, std::size_t first, std::size_t count, double length) {
  if (first + count > columns.size() || columns[first].empty()) return false;
  std::size_t good = 0;
  for (std::size_t row = 0; row < columns[first].size(); ++row) {
    double squares = 0.0;
    for (std::size_t i = 0; i < count; ++i) squares += columns[first + i][row] * columns[first + i][row];
    good += std::abs(std::sqrt(squares) - length) < 0.02 ? 1 : 0;
  }
  return good * 10 >= columns[first].size() * 9;
}

class Guesser {
 public:
  explicit Guesser(const NumberTable& table) : looked_(look_at(table)) {}

  std::optional<ColumnGuess> guess(ColumnMap layout) {
    guess_.map = std::move(layout);
    const bool named = !looked_.table.names().empty() && by_names();
    if (!named && !by_numbers()) return std::nullopt;
    if (guess_.map.time.column.empty()) {
      guess_.map.time.rate_hz = kUsualRate_hz;
      doubt(fmt::format("no time is recognised; {:g} rows a second are assumed", kUsualRate_hz));
    }
    return std::move(guess_);
  }

 private:
  struct Group {
    std::map<Quantity, std::map<int, std::size_t>> parts;  ///< The first column of each.
    std::string length_unit;
    std::string angle_unit;
  };

  void doubt(std::string sentence) { guess_.doubts.push_back(std::move(sentence)); }
  ColumnName name(std::size_t i) const {
    const std::vector<std::string>& names = looked_.table.names();
    const bool unique = i < names.size() && std::count(names.begin(), names.end(), names[i]) == 1 &&
                        demonstration::check_name(names[i]) && !names[i].starts_with('#');
    return unique ? names[i] : fmt::format("#{}", i + 1);
  }
  std::vector<ColumnName> all_of(const std::map<int, std::size_t>& parts) const {
    std::vector<ColumnName> columns;
    for (const auto& [part, column] : parts) columns.push_back(name(column));
    return columns;
  }

  void take_time(std::size_t i, const std::string& unit) {
    guess_.map.time.column = name(i);
    const bool known = unit == "s" || unit == "ms" || unit == "us" || unit == "ns";
    guess_.map.time.unit = known ? unit : time_unit(looked_.columns[i]);
    if (!known)
      doubt(fmt::format("{} is taken as a time in {} by the size of its steps", name(i), guess_.map.time.unit));
  }

  std::string length_unit(const std::map<int, std::size_t>& parts, const std::string& told) {
    if (told == "m" || told == "cm" || told == "mm") return told;
    double most = 0.0;
    for (const auto& [part, column] : parts) most = std::max(most, largest(looked_.columns[column]));
    const std::string unit = most > 2.0 ? "mm" : "m";
    doubt(fmt::format("positions are taken as {} by their size, up to {:.3g}", unit, most));
    return unit;
  }

  std::string angle_unit(const std::map<int, std::size_t>& parts, const std::string& told) {
    if (told == "rad" || told == "deg") return told;
    double most = 0.0;
    for (const auto& [part, column] : parts) most = std::max(most, largest(looked_.columns[column]));
    const std::string unit = most > 6.3 ? "deg" : "rad";
    doubt(fmt::format("{} is taken as an angle in {} by its size, up to {:.3g}", name(parts.begin()->second), unit,
                      most));
    return unit;
  }

  /// The first column, under whatever name, where it rises from row to row and nothing else is made of it.
  void take_first_as_time() {
    const std::vector<std::string>& names = looked_.table.names();
    if (names.empty() || looked_.columns.empty() || !numeric(looked_.columns[0]) || understood(names[0])) return;
    const std::vector<double>& values = looked_.columns[0];
    const std::string unit = unit_in(names[0]);
    std::size_t rising = 0;
    std::size_t counting = 0;
    for (std::size_t i = 1; i < values.size(); ++i) {
      rising += values[i] > values[i - 1] ? 1 : 0;
      counting += values[i] == values[i - 1] + 1.0 ? 1 : 0;
    }
    // Whole numbers one after the other count rows, unless a unit says otherwise.
    const bool counts = unit.empty() && counting + 1 == values.size();
    if (values.size() < 3 || counts || 10 * rising < 9 * (values.size() - 1)) return;
    take_time(0, unit);
    doubt(fmt::format("{} is taken as the time, because it comes first and rises", name(0)));
  }

  bool by_names() {
    std::map<int, Group> groups;
    for (std::size_t i = 0; i < looked_.table.names().size(); ++i) {
      const auto told = understood(looked_.table.names()[i]);
      if (!told || i >= looked_.columns.size() || !numeric(looked_.columns[i])) continue;
      if (told->quantity == Quantity::kTime) {
        if (guess_.map.time.column.empty()) take_time(i, told->unit);
        continue;
      }
      Group& group = groups[told->arm];
      group.parts[told->quantity].try_emplace(told->part, i);
      if (told->quantity == Quantity::kPosition) {
        if (!group.length_unit.empty() && group.length_unit != told->unit) {
          doubt(fmt::format("{} is named in {}, another axis of that tool in {}; all are taken as {}", name(i),
                            told->unit.empty() ? "no unit" : told->unit, group.length_unit, group.length_unit));
        } else {
          group.length_unit = told->unit;
        }
      }
      if (told->quantity == Quantity::kEuler || told->quantity == Quantity::kJoint) group.angle_unit = told->unit;
      if (told->quantity == Quantity::kJaw) jaw_units_[i] = told->unit;
    }
    if (guess_.map.time.column.empty()) take_first_as_time();
    bool any = false;
    for (auto& [arm, group] : groups) {
      // What names no arm is the left one's, unless that is there by name.
      const std::size_t side = arm == 1 ? 1 : 0;
      if (!guess_.map.arms[side].empty() || !take_group(group, guess_.map.arms[side])) continue;
      if (arm < 0) doubt("no name tells an arm; it is taken as the left one");
      any = true;
    }
    return any;
  }

  bool take_group(Group& group, ArmColumns& into) {
    const auto whole = [&group](Quantity quantity, std::size_t count) { return group.parts[quantity].size() == count; };
    if (whole(Quantity::kPosition, 3)) {
      auto& parts = group.parts[Quantity::kPosition];
      into.position = PositionColumns{all_of(parts), length_unit(parts, group.length_unit)};
      take_rotation(group, into);
    } else if (whole(Quantity::kJoint, 6)) {
      auto& parts = group.parts[Quantity::kJoint];
      into.joints = JointColumns{all_of(parts), angle_unit(parts, group.angle_unit), "m"};
    } else {
      return false;
    }
    if (whole(Quantity::kJaw, 1)) take_jaw(group.parts[Quantity::kJaw].begin()->second, into);
    return true;
  }

  void take_rotation(Group& group, ArmColumns& into) {
    RotationColumns rotation;
    if (group.parts[Quantity::kQuaternion].size() == 4) {
      rotation.columns = all_of(group.parts[Quantity::kQuaternion]);
    } else if (group.parts[Quantity::kMatrix].size() == 9) {
      rotation.kind = "matrix_rows";
      rotation.columns = all_of(group.parts[Quantity::kMatrix]);
    } else if (group.parts[Quantity::kEuler].size() == 3) {
      rotation.kind = "euler";
      rotation.columns = all_of(group.parts[Quantity::kEuler]);
      rotation.unit = angle_unit(group.parts[Quantity::kEuler], group.angle_unit);
      doubt("roll, pitch and yaw are taken as turns about the fixed axes x, y, z in that order");
    } else {
      return;
    }
    into.rotation = std::move(rotation);
  }

  void take_jaw(std::size_t i, ArmColumns& into) {
    JawColumn jaw;
    jaw.column = name(i);
    const std::string& told = jaw_units_[i];
    const Values& values = looked_.columns[i];
    const double least = *std::min_element(values.begin(), values.end());
    if (told == "rad" || told == "deg") {
      jaw.unit = told;
    } else {
      const double most = largest(values);
      jaw.unit = most > 6.3 ? "deg" : least >= 0.0 && std::abs(most - 1.0) < 1e-6 ? "ratio" : "rad";
      doubt(fmt::format("{} is taken as a jaw in {} by its size, up to {:.3g}", jaw.column, jaw.unit, most));
    }
    into.jaw = std::move(jaw);
  }

  /// Time, then for each arm a position with a quaternion or a matrix behind it, or six joints; each with a jaw where a
  /// column is left over.
  bool by_numbers() {
    const std::vector<Values>& columns = looked_.columns;
    std::size_t at = 0;
    if (!columns.empty() && rises(columns[0])) {
      take_time(0, "");
      at = 1;
    }
    std::vector<std::size_t> begins;
    for (std::size_t i = at; i + 3 < columns.size(); ++i) {
      const bool quaternion = unit_length(columns, i + 3, 4, 1.0) && !unit_length(columns, i, 4, 1.0);
      if (!quaternion && !unit_length(columns, i + 3, 9, std::sqrt(3.0))) continue;
      begins.push_back(i);
      i += quaternion ? 6 : 11;
    }
    for (std::size_t nth = 0; nth < std::min<std::size_t>(begins.size(), 2); ++nth) {
      const std::size_t end = nth + 1 < begins.size() ? begins[nth + 1] : columns.size();
      take_pose(begins[nth], end, guess_.map.arms[nth]);
    }
    if (begins.empty()) return take_joint_array(at);
    doubt("what is what is told by the numbers alone; the first arm is taken as the left one");
    return true;
  }

  void take_pose(std::size_t begin, std::size_t end, ArmColumns& into) {
    std::map<int, std::size_t> position;
    for (int i = 0; i < 3; ++i) position[i] = begin + static_cast<std::size_t>(i);
    into.position = PositionColumns{all_of(position), length_unit(position, "")};
    RotationColumns rotation;
    const bool quaternion = unit_length(looked_.columns, begin + 3, 4, 1.0);
    const std::size_t count = quaternion ? 4 : 9;
    if (!quaternion) rotation.kind = "matrix_rows";
    if (quaternion) doubt("quaternions are taken as x, y, z, w");
    for (std::size_t i = 0; i < count; ++i) rotation.columns.push_back(name(begin + 3 + i));
    into.rotation = std::move(rotation);
    if (begin + 3 + count < end) take_jaw(begin + 3 + count, into);
  }

  /// 6 or 7 columns an arm.
  bool take_joint_array(std::size_t at) {
    const std::size_t left = looked_.columns.size() - at;
    const std::size_t each = left == 7 || left == 14 ? 7 : left == 6 || left == 12 ? 6 : 0;
    for (std::size_t nth = 0; each != 0 && nth < left / each; ++nth) {
      std::map<int, std::size_t> joints;
      for (int i = 0; i < 6; ++i) joints[i] = at + nth * each + static_cast<std::size_t>(i);
      guess_.map.arms[nth].joints = JointColumns{all_of(joints), angle_unit(joints, ""), "m"};
      if (each == 7) take_jaw(at + nth * each + 6, guess_.map.arms[nth]);
    }
    if (each != 0) doubt("columns are taken as joints, by their number alone");
    return each != 0;
  }

  Looked looked_;
  ColumnGuess guess_;
  std::map<std::size_t, std::string> jaw_units_;
};

/// How well a delimiter suits the first lines; larger is better.
struct Suits {
  bool header = false;  ///< The first line has as many cells as the others: decimal commas are no delimiter.
  bool even = false;    ///< The others have as many as each other.
  std::size_t cells = 0;
  auto operator<=>(const Suits&) const = default;
};

Suits suits(const std::vector<std::string_view>& lines, char delimiter) {
  std::size_t fewest = std::string_view::npos;
  std::size_t most = 0;
  for (std::size_t i = lines.size() > 1 ? 1 : 0; i < lines.size(); ++i) {
    const std::size_t cells = cells_of(lines[i], delimiter).size();
    fewest = std::min(fewest, cells);
    most = std::max(most, cells);
  }
  if (lines.empty() || fewest < 2) return {};
  return {cells_of(lines.front(), delimiter).size() == fewest, fewest == most, fewest};
}

/// The delimiter that cuts the first lines, the header among them, into the same number of cells; of several, the most.
std::string likely_delimiter(const std::vector<std::string_view>& lines) {
  std::string best = ",";
  Suits of_best;
  for (const std::string delimiter : {"tab", ";", ",", "|", "space"}) {
    const char c = delimiter == "tab" ? '\t' : delimiter == "space" ? ' ' : delimiter[0];
    const Suits here = suits(lines, c);
    if (here > of_best) {
      best = delimiter;
      of_best = here;
    }
  }
  return best;
}

/// True if at least one cell is a number with a comma and none has a point.
bool decimal_commas(const std::vector<std::string_view>& lines, char delimiter) {
  bool comma = false;
  for (std::size_t i = lines.size() > 1 ? 1 : 0; i < lines.size(); ++i) {
    for (const std::string_view cell : cells_of(lines[i], delimiter)) {
      double value = 0.0;
      if (cell.find('.') != std::string_view::npos) return false;
      comma = comma || (cell.find(',') != std::string_view::npos && parse_cell(cell, true, value));
    }
  }
  return comma;
}

ColumnMap layout_of(std::string_view text) {
  constexpr std::size_t kLinesRead = 20;
  ColumnMap map;
  std::vector<std::string_view> lines;
  while (!text.empty() && lines.size() < kLinesRead) {
    const std::string_view line = take_line(text);
    const bool blank = line.find_first_not_of(" \t") == std::string_view::npos;
    if (!blank && !line.starts_with(map.comment)) lines.push_back(line);
  }
  map.delimiter = likely_delimiter(lines);
  const char delimiter = TextLayout::of(map).delimiter;
  map.decimal.assign(1, delimiter != ',' && decimal_commas(lines, delimiter) ? ',' : '.');
  map.header_lines = 0;
  for (const std::string_view line : lines) {
    const std::vector<std::string_view> cells = cells_of(line, delimiter);
    const bool numbers = std::any_of(cells.begin(), cells.end(), [&map](std::string_view cell) {
      double value = 0.0;
      return !cell.empty() && parse_cell(cell, map.decimal == ",", value);
    });
    if (numbers) break;
    ++map.header_lines;
  }
  return map;
}

}  // namespace

Result<std::optional<ColumnGuess>> guess_columns_of_text(std::string_view text) {
  ColumnMap layout = layout_of(text);
  TROCAR_ASSIGN_OR_RETURN(const NumberTable table, NumberTable::of_text(text, TextLayout::of(layout)));
  if (table.width() > 10'000) return fail(ErrorCode::kCorrupt, "the table has more than 10,000 columns");
  return Guesser(table).guess(std::move(layout));
}

Result<std::optional<ColumnGuess>> guess_columns_of_npy(std::string_view bytes) {
  TROCAR_ASSIGN_OR_RETURN(const NumberTable table, NumberTable::of_npy(bytes));
  if (table.width() > 10'000) return fail(ErrorCode::kCorrupt, "the array has more than 10,000 columns");
  return Guesser(table).guess({});
}

}  // namespace trocar::exchange
