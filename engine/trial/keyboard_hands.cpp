#include "engine/trial/keyboard_hands.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "engine/spatial/grid.h"

namespace trocar::trial {
namespace {

using kinematics::ArmSide;

// What each row of `hand_key_rows` does to the tool: the first six move it along an axis of W, the next two turn it.
constexpr std::size_t kMoves = 6;
constexpr std::size_t kJaw = 8;
const std::array<Eigen::Vector3d, kMoves> kWays{Eigen::Vector3d::UnitZ(),  -Eigen::Vector3d::UnitZ(),
                                                -Eigen::Vector3d::UnitY(), Eigen::Vector3d::UnitY(),
                                                Eigen::Vector3d::UnitX(),  -Eigen::Vector3d::UnitX()};

HandKey key_of(ArmSide arm, const HandKeyRow& row) {
  return arm == ArmSide::kLeft ? row.left : row.right;
}

}  // namespace

const std::array<HandKeyRow, 9>& hand_key_rows() {
  static constexpr std::array<HandKeyRow, 9> kRows{{{'W', 'I', "up"},
                                                    {'S', 'K', "down"},
                                                    {'A', 'J', "left"},
                                                    {'D', 'L', "right"},
                                                    {'Q', 'U', "towards you"},
                                                    {'E', 'O', "away"},
                                                    {'Z', 'M', "turn left"},
                                                    {'X', ',', "turn right"},
                                                    {'C', 'N', "open or shut the jaws"}}};
  return kRows;
}

Result<HandKey> hand_key_from(std::string_view name) {
  const auto same = [name](std::string_view word) {
    return std::equal(name.begin(), name.end(), word.begin(), word.end(),
                      [](unsigned char a, unsigned char b) { return std::tolower(a) == std::tolower(b); });
  };
  if (same("Shift")) return kShiftKey;
  if (same("Enter")) return kEnterKey;
  if (name == ",") return ',';
  if (name.size() == 1 && std::isalpha(static_cast<unsigned char>(name[0])) != 0) {
    return static_cast<HandKey>(std::toupper(static_cast<unsigned char>(name[0])));
  }
  return fail(ErrorCode::kInvalidArgument, fmt::format("no key of the operator is named \"{}\"", name));
}

std::string to_text(HandKey key) {
  if (key == kShiftKey) return "Shift";
  if (key == kEnterKey) return "Enter";
  return {key};
}

bool KeyboardHands::means(HandKey key) {
  const auto& rows = hand_key_rows();
  return key == kShiftKey || key == kEnterKey || key == kClutchKey ||
         std::any_of(rows.begin(), rows.end(),
                     [key](const HandKeyRow& row) { return row.left == key || row.right == key; });
}

DriveTool KeyboardHands::drive_of(ArmSide arm) const {
  DriveTool drive;
  drive.arm = arm;
  const double share = held(kShiftKey) ? settings_.fine : 1.0;
  const auto& rows = hand_key_rows();
  // In step mode a place is a cell, but a tool may still be turned as far as is wanted.
  for (std::size_t i = 0; i < kMoves && settings_.mode != HandMode::kStep; ++i) {
    if (held(key_of(arm, rows[i]))) drive.v_WT += kWays[i];
  }
  if (drive.v_WT.squaredNorm() > 0.0) drive.v_WT *= share * settings_.speed_m_s / drive.v_WT.norm();
  // The tool points down: turned to the left as seen from above is about its −z.
  const double left = (held(key_of(arm, rows[kMoves])) ? 1.0 : 0.0) - (held(key_of(arm, rows[kMoves + 1])) ? 1.0 : 0.0);
  drive.w_WT_T.z() = -left * share * settings_.turn_rad_s;
  return drive;
}

std::optional<HandEvent> KeyboardHands::press_of(ArmSide arm, HandKey key) const {
  const auto& rows = hand_key_rows();
  if (key == key_of(arm, rows[kJaw])) return ToggleJaw{arm};
  if (settings_.mode != HandMode::kStep) return std::nullopt;
  for (std::size_t i = 0; i < kMoves; ++i) {
    if (key != key_of(arm, rows[i])) continue;
    if (held(kShiftKey)) return ShiftTool{arm, settings_.fine * spatial::Grid{}.cell_m * kWays[i]};
    return StepTool{arm, kWays[i]};
  }
  return std::nullopt;
}

std::vector<HandEvent> KeyboardHands::key(HandKey key, bool down) {
  if (!means(key) || (!down && !held(key))) return {};
  const bool repeats = down && held(key);
  std::vector<HandEvent> events;
  std::array<DriveTool, 2> before;
  for (const ArmSide arm : kinematics::kArmSides) before[kinematics::index_of(arm)] = drive_of(arm);
  down_[static_cast<unsigned char>(key) & 0x7FU] = down;
  for (const ArmSide arm : kinematics::kArmSides) {
    const DriveTool now = drive_of(arm);
    const DriveTool& was = before[kinematics::index_of(arm)];
    if (now.v_WT != was.v_WT || now.w_WT_T != was.w_WT_T) events.emplace_back(now);
    if (!down) continue;
    const std::optional<HandEvent> press = press_of(arm, key);
    // A step repeats as the key does; jaws that opened and shut as fast would be of no use.
    if (press && !(repeats && std::holds_alternative<ToggleJaw>(*press))) events.push_back(*press);
  }
  if (key == kClutchKey && !repeats) events.emplace_back(HoldClutch{down});
  if (key == kEnterKey && down && !repeats && settings_.mode == HandMode::kWaypoint)
    events.emplace_back(GoToWaypoint{});
  return events;
}

std::vector<HandEvent> KeyboardHands::release_all() {
  std::vector<HandEvent> events;
  for (std::size_t i = 0; i < down_.size(); ++i) {
    if (!down_[i]) continue;
    for (HandEvent& event : key(static_cast<HandKey>(i), false)) events.push_back(std::move(event));
  }
  return events;
}

}  // namespace trocar::trial
