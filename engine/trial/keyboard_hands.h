/// Two arms on one keyboard: from keys that go down and up to what the operator does to the tools.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/result.h"
#include "engine/trial/hand_event.h"

namespace trocar::trial {

/// A key by what is printed on it: 'A' … 'Z', ',' or one of these.
using HandKey = char;
constexpr HandKey kShiftKey = '\x0E';
constexpr HandKey kEnterKey = '\r';

/// "W", ",", "Shift", "Enter"; letters in either case. Errors: kInvalidArgument naming what is no such key.
Result<HandKey> hand_key_from(std::string_view name);
std::string to_text(HandKey key);

/// What a key does, for help and forms.
struct HandKeyRow {
  HandKey left = 0;
  HandKey right = 0;
  std::string_view meaning;
};
/// SurRoL's keys, and ours for turning: WASD, QE, C, ZX for the left arm; IJKL, UO, N, M and "," for the right.
const std::array<HandKeyRow, 9>& hand_key_rows();
/// Holds the tools while the hand would move: the clutch.
constexpr HandKey kClutchKey = 'V';

struct KeyboardSettings {
  HandMode mode = HandMode::kContinuous;
  double speed_m_s = 0.040;
  double turn_rad_s = 0.8;
  double fine = 0.2;  ///< With Shift speeds are this share, and a step is this share of a cell.
};

/// Threads: one at a time.
class KeyboardHands {
 public:
  explicit KeyboardHands(const KeyboardSettings& settings = {}) : settings_(settings) {}

  /// What a key means that went down (again, if it repeats) or up; nothing if it is none of the operator's.
  std::vector<HandEvent> key(HandKey key, bool down);
  /// All keys up: the window lost the keyboard.
  std::vector<HandEvent> release_all();
  /// True for the keys that a take has for itself.
  static bool means(HandKey key);

 private:
  bool held(HandKey key) const { return down_[static_cast<unsigned char>(key) & 0x7FU]; }
  DriveTool drive_of(kinematics::ArmSide arm) const;
  std::optional<HandEvent> press_of(kinematics::ArmSide arm, HandKey key) const;

  KeyboardSettings settings_;
  std::array<bool, 128> down_{};
};

}  // namespace trocar::trial
