#include "ui/window/input.h"

#include <utility>

namespace trocar::ui {
namespace {

// Our keys that ImGui has a name for in every version.
struct ImGuiNamedKey {
  ImGuiKey imgui;
  Key key;
};
// Not Tab: `KeyboardFocus` goes from widget to widget, of every kind.
constexpr std::array<ImGuiNamedKey, 21> kNamedKeys{{
    {ImGuiKey_LeftArrow, Key::kLeft},
    {ImGuiKey_RightArrow, Key::kRight},
    {ImGuiKey_UpArrow, Key::kUp},
    {ImGuiKey_DownArrow, Key::kDown},
    {ImGuiKey_PageUp, Key::kPageUp},
    {ImGuiKey_PageDown, Key::kPageDown},
    {ImGuiKey_Home, Key::kHome},
    {ImGuiKey_End, Key::kEnd},
    {ImGuiKey_Insert, Key::kInsert},
    {ImGuiKey_Delete, Key::kDelete},
    {ImGuiKey_Backspace, Key::kBackspace},
    {ImGuiKey_Space, Key::kSpace},
    {ImGuiKey_Enter, Key::kEnter},
    {ImGuiKey_Escape, Key::kEscape},
#if IMGUI_VERSION_NUM >= 18700
    {ImGuiKey_KeypadEnter, Key::kKeypadEnter},
#else
    {ImGuiKey_KeyPadEnter, Key::kKeypadEnter},
#endif
    {ImGuiKey_A, key_of('A')},
    {ImGuiKey_C, key_of('C')},
    {ImGuiKey_V, key_of('V')},
    {ImGuiKey_X, key_of('X')},
    {ImGuiKey_Y, key_of('Y')},
    {ImGuiKey_Z, key_of('Z')},
}};

#if IMGUI_VERSION_NUM >= 18700
ImGuiKey named(Key key) {
  for (const ImGuiNamedKey& entry : kNamedKeys) {
    if (entry.key == key) return entry.imgui;
  }
  return ImGuiKey_None;
}
#endif

}  // namespace

void map_keys([[maybe_unused]] ImGuiIO& io) {
#if IMGUI_VERSION_NUM < 18700
  for (const ImGuiNamedKey& entry : kNamedKeys) io.KeyMap[entry.imgui] = static_cast<int>(entry.key);
#endif
}

bool InputQueue::accept(const InputEvent& event) const {
  if (const auto* button = std::get_if<MouseButton>(&event)) {
    return !button_changed_[static_cast<std::size_t>(button->button)];
  }
  if (const auto* key = std::get_if<KeyChanged>(&event)) {
    // A key and its letter arrive together, but a second change of one key must be seen in a frame of its own.
    return key->key == Key::kNone || !changed_[index(key->key)];
  }
  // A move after a press or release in the same frame would shift where the press happened.
  return !std::holds_alternative<MouseMoved>(event) || !button_touched_;
}

void InputQueue::feed_key(const KeyChanged& event, ImGuiIO& io) {
  if (event.key == Key::kNone || index(event.key) >= kKeyCount) return;
  const std::size_t i = index(event.key);
  changed_[i] = true;
  down_[i] = event.down;
  if (event.down) pressed_[i] = true;
  const Modifiers held = modifiers();
#if IMGUI_VERSION_NUM >= 18700
  io.AddKeyEvent(ImGuiKey_ModCtrl, held.control);
  io.AddKeyEvent(ImGuiKey_ModShift, held.shift);
  io.AddKeyEvent(ImGuiKey_ModAlt, held.alt);
  if (const ImGuiKey key = named(event.key); key != ImGuiKey_None) io.AddKeyEvent(key, event.down);
#else
  io.KeysDown[i] = event.down;
  io.KeyCtrl = held.control;
  io.KeyShift = held.shift;
  io.KeyAlt = held.alt;
#endif
}

void InputQueue::feed(const InputEvent& event, ImGuiIO& io) {
  if (const auto* moved = std::get_if<MouseMoved>(&event)) {
#if IMGUI_VERSION_NUM >= 18700
    io.AddMousePosEvent(moved->x, moved->y);
#else
    io.MousePos = {moved->x, moved->y};
#endif
  } else if (const auto* button = std::get_if<MouseButton>(&event)) {
    button_changed_[static_cast<std::size_t>(button->button)] = true;
    button_touched_ = true;
#if IMGUI_VERSION_NUM >= 18700
    io.AddMouseButtonEvent(button->button, button->down);
#else
    io.MouseDown[button->button] = button->down;
#endif
  } else if (const auto* wheel = std::get_if<MouseWheel>(&event)) {
#if IMGUI_VERSION_NUM >= 18700
    io.AddMouseWheelEvent(wheel->x, wheel->y);
#else
    io.MouseWheelH += wheel->x;
    io.MouseWheel += wheel->y;
#endif
  } else if (const auto* key = std::get_if<KeyChanged>(&event)) {
    feed_key(*key, io);
  } else if (const auto* typed = std::get_if<Typed>(&event)) {
    io.AddInputCharacter(typed->codepoint);
  } else if (const auto* drop = std::get_if<Dropped>(&event)) {
    dropped_.push_back(drop->path);
  }
}

int InputQueue::apply(ImGuiIO& io) {
  changed_.fill(false);
  pressed_.fill(false);
  button_changed_.fill(false);
  button_touched_ = false;
  dropped_.clear();
  int taken = 0;
  while (!events_.empty() && accept(events_.front())) {
    const InputEvent event = events_.front();
    events_.pop_front();
    feed(event, io);
    ++taken;
  }
  return taken;
}

bool InputQueue::pressed(Key key) const {
  return pressed_[index(key)];
}

Key InputQueue::pressed_key() const {
  for (int code = 1; code < static_cast<int>(Key::kLeftShift); ++code) {
    const auto key = static_cast<Key>(code);
    if (pressed(key)) return key;
  }
  return Key::kNone;
}

Modifiers InputQueue::modifiers() const {
  return {down(Key::kLeftControl) || down(Key::kRightControl), down(Key::kLeftShift) || down(Key::kRightShift),
          down(Key::kLeftAlt) || down(Key::kRightAlt)};
}

}  // namespace trocar::ui
