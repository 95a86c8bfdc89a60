#include "ui/shortcut.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

namespace trocar::ui {
namespace {

struct NamedKey {
  std::string_view name;
  Key key;
};
constexpr std::array<NamedKey, 31> kNames{{
    {"Space", Key::kSpace},
    {"Escape", Key::kEscape},
    {"Enter", Key::kEnter},
    {"Tab", Key::kTab},
    {"Backspace", Key::kBackspace},
    {"Insert", Key::kInsert},
    {"Delete", Key::kDelete},
    {"Right", Key::kRight},
    {"Left", Key::kLeft},
    {"Down", Key::kDown},
    {"Up", Key::kUp},
    {"PageUp", Key::kPageUp},
    {"PageDown", Key::kPageDown},
    {"Home", Key::kHome},
    {"End", Key::kEnd},
    {"'", Key::kApostrophe},
    {",", Key::kComma},
    {"-", Key::kMinus},
    {".", Key::kPeriod},
    {"/", Key::kSlash},
    {";", Key::kSemicolon},
    {"=", Key::kEqual},
    {"[", Key::kLeftBracket},
    {"]", Key::kRightBracket},
    {"\\", Key::kBackslash},
    {"`", Key::kGrave},
    {"KeypadPoint", Key::kKeypadPoint},
    {"KeypadDivide", Key::kKeypadDivide},
    {"KeypadMinus", Key::kKeypadMinus},
    {"KeypadPlus", Key::kKeypadPlus},
    {"KeypadEnter", Key::kKeypadEnter},
}};

bool same(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

/// What a person calls by the character that it writes with Shift, on the layout that keys are named after.
constexpr std::array<std::pair<std::string_view, Key>, 10> kShifted{{{"?", Key::kSlash},
                                                                     {":", Key::kSemicolon},
                                                                     {"\"", Key::kApostrophe},
                                                                     {"<", Key::kComma},
                                                                     {">", Key::kPeriod},
                                                                     {"_", Key::kMinus},
                                                                     {"{", Key::kLeftBracket},
                                                                     {"}", Key::kRightBracket},
                                                                     {"|", Key::kBackslash},
                                                                     {"~", Key::kGrave}}};

}  // namespace

std::optional<Key> key_from(std::string_view name) {
  for (const NamedKey& entry : kNames) {
    if (same(entry.name, name)) return entry.key;
  }
  if (name.size() == 1 && std::isalnum(static_cast<unsigned char>(name[0])) != 0) {
    return static_cast<Key>(std::toupper(static_cast<unsigned char>(name[0])));
  }
  constexpr std::string_view kKeypad = "Keypad";
  if (name.size() == kKeypad.size() + 1 && same(name.substr(0, kKeypad.size()), kKeypad) && name.back() >= '0' &&
      name.back() <= '9') {
    return static_cast<Key>(static_cast<int>(Key::kKeypad0) + name.back() - '0');
  }
  if (name.size() >= 2 && name.size() <= 3 && (name[0] == 'F' || name[0] == 'f')) {
    int number = 0;
    for (const char c : name.substr(1)) {
      if (c < '0' || c > '9') return std::nullopt;
      number = number * 10 + (c - '0');
    }
    if (number >= 1 && number <= 12) return static_cast<Key>(static_cast<int>(Key::kF1) + number - 1);
  }
  return std::nullopt;
}

Result<Chord> chord_from(std::string_view text) {
  Chord chord;
  std::string_view rest = text;
  while (true) {
    const std::size_t plus = rest.find('+');
    const std::string_view part = rest.substr(0, plus);
    if (plus == std::string_view::npos) {
      for (const auto& [character, shifted] : kShifted) {
        if (part != character) continue;
        chord.key = shifted;
        chord.modifiers.shift = true;
        return chord;
      }
      const std::optional<Key> key = key_from(part);
      if (!key) return fail(ErrorCode::kInvalidArgument, fmt::format("no key is named \"{}\"", part));
      chord.key = *key;
      return chord;
    }
    if (same(part, "Ctrl")) {
      chord.modifiers.control = true;
    } else if (same(part, "Shift")) {
      chord.modifiers.shift = true;
    } else if (same(part, "Alt")) {
      chord.modifiers.alt = true;
    } else {
      return fail(ErrorCode::kInvalidArgument, fmt::format("\"{}\" is neither Ctrl, Shift nor Alt", part));
    }
    rest.remove_prefix(plus + 1);
  }
}

std::string to_text(const Chord& chord) {
  std::string text;
  if (chord.modifiers.control) text += "Ctrl+";
  if (chord.modifiers.shift) text += "Shift+";
  if (chord.modifiers.alt) text += "Alt+";
  for (const NamedKey& entry : kNames) {
    if (entry.key == chord.key) return text + std::string(entry.name);
  }
  const int code = static_cast<int>(chord.key);
  const int f1 = static_cast<int>(Key::kF1);
  if (code >= f1 && code <= static_cast<int>(Key::kF12)) return text + "F" + std::to_string(code - f1 + 1);
  const int digit = code - static_cast<int>(Key::kKeypad0);
  if (digit >= 0 && digit <= 9) return text + "Keypad" + std::to_string(digit);
  return text + static_cast<char>(code);
}

bool pressed(const InputQueue& input, const Chord& chord) {
  return chord.key != Key::kNone && input.pressed(chord.key) && input.modifiers() == chord.modifiers;
}

}  // namespace trocar::ui
