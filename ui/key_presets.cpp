#include "ui/key_presets.h"

#include <algorithm>

namespace trocar::ui {
namespace {

constexpr std::array<std::string_view, 4> kPresetNames{"default", "blender", "nle", "surrol"};
constexpr std::array<std::string_view, 4> kPresetTitles{"Default", "Blender-like", "NLE-like", "SurRoL-like"};

// Blender 3's default keys: R turns, F3 searches, numbers of the keypad look, Up and Down go to keyframes.
constexpr std::array<PresetRow, 19> kBlender{{{"tool.turn", {"R", "T"}},
                                              {"demo.record", {"Ctrl+Shift+F12"}},
                                              {"help.palette", {"F3", "Ctrl+P"}},
                                              {"file.export_video", {"Ctrl+F12"}},
                                              {"edit.copy_demonstration", {"Shift+D"}},
                                              {"edit.lift", {"X", "Delete"}},
                                              {"edit.clear_gates", {"Alt+P"}},
                                              {"select.all", {"A", "Ctrl+A"}},
                                              {"select.none", {"Alt+A"}},
                                              {"transport.frame_forward", {"Right"}},
                                              {"transport.frame_back", {"Left"}},
                                              {"transport.forward", {"."}},
                                              {"transport.back", {","}},
                                              {"transport.begin", {"Shift+Left", "Home"}},
                                              {"transport.end", {"Shift+Right", "End"}},
                                              {"view.camera_front", {"Keypad1", "Alt+4"}},
                                              {"view.camera_side", {"Keypad3", "Alt+3"}},
                                              {"view.camera_top", {"Keypad7", "Alt+2"}},
                                              {"view.camera_paper", {"Keypad0", "Alt+1"}}}};

// What editors of films agree on beside J, K, L, I and O: Up and Down go to cuts, Ctrl+K cuts, Ctrl+M exports.
constexpr std::array<PresetRow, 11> kNle{{{"transport.next_event", {"Down"}},
                                          {"transport.last_event", {"Up"}},
                                          {"transport.frame_forward", {"Right"}},
                                          {"transport.frame_back", {"Left"}},
                                          {"transport.forward", {"."}},
                                          {"transport.back", {","}},
                                          {"edit.split", {"Ctrl+K", "B"}},
                                          {"help.palette", {"Ctrl+P"}},
                                          {"file.export_video", {"Ctrl+M"}},
                                          {"select.segment", {"X"}},
                                          {"edit.clear_gates", {"Alt+X"}}}};

// The tool in hand goes by letters, as one drives an instrument in SurRoL: W, S, A, D in the plane, E and Q up and
// down.
constexpr std::array<PresetRow, 13> kSurrol{{{"tool.nudge_y", {"W", "Ctrl+Up"}},
                                             {"tool.nudge_minus_y", {"S", "Ctrl+Down"}},
                                             {"tool.nudge_minus_x", {"A", "Ctrl+Left"}},
                                             {"tool.nudge_x", {"D", "Ctrl+Right"}},
                                             {"tool.nudge_z", {"E", "Ctrl+PageUp"}},
                                             {"tool.nudge_minus_z", {"Q", "Ctrl+PageDown"}},
                                             {"tool.fine_y", {"Shift+W", "Ctrl+Shift+Up"}},
                                             {"tool.fine_minus_y", {"Shift+S", "Ctrl+Shift+Down"}},
                                             {"tool.fine_minus_x", {"Shift+A", "Ctrl+Shift+Left"}},
                                             {"tool.fine_x", {"Shift+D", "Ctrl+Shift+Right"}},
                                             {"tool.fine_z", {"Shift+E", "Ctrl+Shift+PageUp"}},
                                             {"tool.fine_minus_z", {"Shift+Q", "Ctrl+Shift+PageDown"}},
                                             {"tool.arm", {"1"}}}};

}  // namespace

std::string_view name_of(KeyPreset preset) {
  return kPresetNames[static_cast<std::size_t>(preset)];
}

std::string_view title_of(KeyPreset preset) {
  return kPresetTitles[static_cast<std::size_t>(preset)];
}

std::optional<KeyPreset> key_preset_from(std::string_view name) {
  const auto* found = std::find(kPresetNames.begin(), kPresetNames.end(), name);
  if (found == kPresetNames.end()) return std::nullopt;
  return static_cast<KeyPreset>(found - kPresetNames.begin());
}

std::span<const PresetRow> rows_of(KeyPreset preset) {
  switch (preset) {
    case KeyPreset::kDefault:
      return {};
    case KeyPreset::kBlender:
      return kBlender;
    case KeyPreset::kNle:
      return kNle;
    case KeyPreset::kSurrol:
      return kSurrol;
  }
  return {};
}

}  // namespace trocar::ui
