#include "engine/exchange/column_names.h"

#include <algorithm>
#include <array>
#include <utility>

namespace trocar::exchange {
namespace {

using Words = std::vector<std::string>;

bool is_lower(char c) {
  return c >= 'a' && c <= 'z';
}
bool is_upper(char c) {
  return c >= 'A' && c <= 'Z';
}
bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

bool has_any(const Words& words, std::initializer_list<std::string_view> wanted) {
  return std::any_of(words.begin(), words.end(), [&](const std::string& word) {
    return std::find(wanted.begin(), wanted.end(), word) != wanted.end();
  });
}

int arm_of(const Words& words) {
  if (has_any(words, {"left", "l", "psm2", "robot0", "arm0", "lhs"})) return 0;
  if (has_any(words, {"right", "r", "psm1", "robot1", "arm1", "rhs"})) return 1;
  return -1;
}

std::string unit_of(const Words& words) {
  for (const char* unit : {"mm", "cm", "ms", "us", "ns", "deg", "rad", "m", "s"}) {
    if (has_any(words, {unit})) return unit;
  }
  if (has_any(words, {"degrees", "degree"})) return "deg";
  if (has_any(words, {"millis", "milliseconds", "msec"})) return "ms";
  if (has_any(words, {"micros", "microseconds", "usec"})) return "us";
  if (has_any(words, {"nanos", "nanoseconds", "nsec", "nsecs"})) return "ns";
  return has_any(words, {"sec", "secs", "seconds"}) ? "s" : "";
}

/// 0, 1, 2 for x, y, z; with `w` 3; else -1. The last word that is a letter counts.
int axis_of(const Words& words) {
  int axis = -1;
  for (const std::string& word : words) {
    if (word == "w") axis = 3;
    if (word.size() == 1 && word[0] >= 'x' && word[0] <= 'z') axis = word[0] - 'x';
  }
  return axis;
}

std::optional<NamedColumn> column(Quantity quantity, int part) {
  if (part < 0) return std::nullopt;
  return NamedColumn{quantity, part, -1, ""};
}

/// "qx" … "qw", "quat_x", "orientation.w".
std::optional<NamedColumn> quaternion(const Words& words) {
  const std::array<std::string_view, 4> parts{"qx", "qy", "qz", "qw"};
  for (int i = 0; i < 4; ++i) {
    if (has_any(words, {parts[static_cast<std::size_t>(i)]})) return column(Quantity::kQuaternion, i);
  }
  if (!has_any(words, {"q", "quat", "quaternion", "rot", "rotation", "ori", "orientation"})) return std::nullopt;
  return column(Quantity::kQuaternion, axis_of(words));
}

/// "r11" … "r33"; rows from 1, or from 0 as "r00" … "r22" (told apart by who has them all).
std::optional<NamedColumn> matrix(const Words& words) {
  for (const std::string& word : words) {
    if (word.size() != 3 || word[0] != 'r' || !is_digit(word[1]) || !is_digit(word[2])) continue;
    const int row = word[1] - '1';
    const int place = word[2] - '1';
    if (row >= 0 && row < 3 && place >= 0 && place < 3) return column(Quantity::kMatrix, 3 * row + place);
  }
  return std::nullopt;
}

/// "q1", "j3", "joint_4", "joint5".
std::optional<NamedColumn> joint(const Words& words) {
  for (std::size_t i = 0; i < words.size(); ++i) {
    std::string_view word = words[i];
    if (word == "joint" && i + 1 < words.size()) {
      word = words[i + 1];
    } else if (word.starts_with("joint")) {
      word.remove_prefix(5);
    } else if (word.size() == 2 && (word[0] == 'q' || word[0] == 'j')) {
      word.remove_prefix(1);
    } else {
      continue;
    }
    if (word.size() == 1 && word[0] >= '1' && word[0] <= '6') return column(Quantity::kJoint, word[0] - '1');
  }
  return std::nullopt;
}

std::optional<NamedColumn> quantity_of(const Words& words) {
  if (has_any(words, {"vel", "velocity", "acc", "acceleration", "force", "torque", "effort", "twist", "current", "goal",
                      "cmd", "command", "index", "frame", "seq"})) {
    return std::nullopt;
  }
  if (has_any(words, {"jaw", "gripper", "grip", "opening", "pincer"})) return column(Quantity::kJaw, 0);
  if (auto found = matrix(words)) return found;
  if (auto found = quaternion(words)) return found;
  if (has_any(words, {"roll", "rx"})) return column(Quantity::kEuler, 0);
  if (has_any(words, {"pitch", "ry"})) return column(Quantity::kEuler, 1);
  if (has_any(words, {"yaw", "rz"})) return column(Quantity::kEuler, 2);
  if (auto found = joint(words)) return found;
  if (has_any(words, {"t", "time", "timestamp", "stamp", "clock", "elapsed"})) return column(Quantity::kTime, 0);
  for (int i = 0; i < 3; ++i) {
    const std::string letter(1, static_cast<char>('x' + i));
    if (has_any(words, {"p" + letter, "pos" + letter})) return column(Quantity::kPosition, i);
  }
  const int axis = axis_of(words);
  return axis == 3 ? std::nullopt : column(Quantity::kPosition, axis);
}

}  // namespace

std::vector<std::string> words_of(std::string_view name) {
  Words words;
  std::string word;
  for (std::size_t i = 0; i < name.size(); ++i) {
    const char c = name[i];
    const bool part = is_lower(c) || is_upper(c) || is_digit(c);
    const bool hump = i > 0 && is_upper(c) && is_lower(name[i - 1]);
    if ((!part || hump) && !word.empty()) words.push_back(std::exchange(word, ""));
    if (part) word += is_upper(c) ? static_cast<char>(c | 0x20) : c;
  }
  if (!word.empty()) words.push_back(word);
  return words;
}

std::string unit_in(std::string_view name) {
  return unit_of(words_of(name));
}

std::optional<NamedColumn> understood(std::string_view name) {
  const Words words = words_of(name);
  std::optional<NamedColumn> found = quantity_of(words);
  if (!found) return std::nullopt;
  found->arm = arm_of(words);
  found->unit = unit_of(words);
  return found;
}

}  // namespace trocar::exchange
