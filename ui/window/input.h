/// What the mouse and keyboard did, as events in order; fed to ImGui so that no press is lost, whatever its version.
#pragma once

#include <imgui.h>

#include <array>
#include <cstdint>
#include <deque>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace trocar::ui {

/// Keys by GLFW's numbers, which the window library, scripts and shortcuts share.
enum class Key : std::int16_t {
  kNone = 0,
  kSpace = 32,
  kApostrophe = 39,
  kComma = 44,
  kMinus = 45,
  kPeriod = 46,
  kSlash = 47,
  k0 = 48,
  k9 = 57,
  kSemicolon = 59,
  kEqual = 61,
  kA = 65,
  kZ = 90,
  kLeftBracket = 91,
  kBackslash = 92,
  kRightBracket = 93,
  kGrave = 96,
  kEscape = 256,
  kEnter = 257,
  kTab = 258,
  kBackspace = 259,
  kInsert = 260,
  kDelete = 261,
  kRight = 262,
  kLeft = 263,
  kDown = 264,
  kUp = 265,
  kPageUp = 266,
  kPageDown = 267,
  kHome = 268,
  kEnd = 269,
  kF1 = 290,
  kF12 = 301,
  kKeypad0 = 320,
  kKeypadPoint = 330,
  kKeypadDivide = 331,
  kKeypadMinus = 333,
  kKeypadPlus = 334,
  kKeypadEnter = 335,
  kLeftShift = 340,
  kLeftControl = 341,
  kLeftAlt = 342,
  kRightShift = 344,
  kRightControl = 345,
  kRightAlt = 346,
};
constexpr int kKeyCount = 349;
constexpr Key key_of(char upper) {
  return static_cast<Key>(upper);
}

/// Ctrl, Shift and Alt as they are held.
struct Modifiers {
  bool control = false;
  bool shift = false;
  bool alt = false;
  bool operator==(const Modifiers&) const = default;
};

struct MouseMoved {
  float x = 0.0F;  ///< Pixels from the top left.
  float y = 0.0F;
};
struct MouseButton {
  int button = 0;  ///< 0 left, 1 right, 2 middle.
  bool down = false;
};
struct MouseWheel {
  float x = 0.0F;
  float y = 0.0F;  ///< Up is positive.
};
struct KeyChanged {
  Key key = Key::kNone;
  bool down = false;
};
struct Typed {
  std::uint32_t codepoint = 0;
};
/// A file was dropped on the window.
struct Dropped {
  std::string path;
};
using InputEvent = std::variant<MouseMoved, MouseButton, MouseWheel, KeyChanged, Typed, Dropped>;

/// Threads: that of the window.
class InputQueue {
 public:
  void push(InputEvent event) { events_.push_back(std::move(event)); }
  /// True while events wait for a later frame.
  bool pending() const { return !events_.empty(); }

  /// Moves events into `io` until the next would undo a button or key that changed in this frame; the rest waits. Call
  /// once before each `ImGui::NewFrame`. Returns how many events were taken.
  int apply(ImGuiIO& io);

  /// Pressed in this frame (auto-repeat of the window system included).
  bool pressed(Key key) const;
  /// The first that was pressed in this frame and is no modifier; `kNone` if none was.
  Key pressed_key() const;
  bool down(Key key) const { return down_[index(key)]; }
  Modifiers modifiers() const;
  /// Dropped on the window in this frame, in order.
  const std::vector<std::string>& dropped() const { return dropped_; }

 private:
  static std::size_t index(Key key) { return static_cast<std::size_t>(key); }
  bool accept(const InputEvent& event) const;
  void feed(const InputEvent& event, ImGuiIO& io);
  void feed_key(const KeyChanged& event, ImGuiIO& io);

  std::deque<InputEvent> events_;
  std::array<bool, kKeyCount> down_{};
  std::array<bool, kKeyCount> changed_{};
  std::array<bool, kKeyCount> pressed_{};
  std::array<bool, 5> button_changed_{};
  bool button_touched_ = false;
  std::vector<std::string> dropped_;
};

/// Tells ImGui which of our keys are its named ones (1.86 only; newer versions get named keys from `apply`).
void map_keys(ImGuiIO& io);

}  // namespace trocar::ui
