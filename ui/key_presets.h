/// Keys as users of other programs have them in their fingers; what a preset does not name keeps the table's keys.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace trocar::ui {

enum class KeyPreset : std::uint8_t { kDefault, kBlender, kNle, kSurrol };
inline constexpr std::array<KeyPreset, 4> kKeyPresets{KeyPreset::kDefault, KeyPreset::kBlender, KeyPreset::kNle,
                                                      KeyPreset::kSurrol};

/// "blender", as in settings; "Blender-like", as on screen.
std::string_view name_of(KeyPreset preset);
std::string_view title_of(KeyPreset preset);
std::optional<KeyPreset> key_preset_from(std::string_view name);

/// All the chords of one command, as text; empty ones do not count.
struct PresetRow {
  std::string_view id;
  std::array<std::string_view, 2> keys;
};
std::span<const PresetRow> rows_of(KeyPreset preset);

}  // namespace trocar::ui
