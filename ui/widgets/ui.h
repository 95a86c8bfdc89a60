/// What every panel draws with: theme, fonts, pictures, the list of items, and the scale.
#pragma once

#include <imgui.h>

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "engine/trial/stick_hands.h"
#include "ui/fonts.h"
#include "ui/textures.h"
#include "ui/theme.h"
#include "ui/widgets/item_log.h"
#include "ui/widgets/keyboard_focus.h"
#include "ui/window/input.h"

namespace trocar::ui {

class Keymap;

/// Lives for the whole session; valid during a frame. Threads: that of the window.
class Ui {
 public:
  Ui(TextureStore& textures, InputQueue& input);

  const Theme& theme() const { return theme_; }
  const Fonts& fonts() const { return fonts_; }
  TextureStore& textures() const { return *textures_; }
  const InputQueue& input() const { return *input_; }
  /// Which keys mean which command; see `shown_keys`.
  const Keymap& keymap() const { return *keymap_; }
  void set_keymap(std::shared_ptr<const Keymap> keymap) { keymap_ = std::move(keymap); }
  ItemLog& items() { return items_; }
  const ItemLog& items() const { return items_; }
  /// Which widget the keyboard is on.
  KeyboardFocus& focus() { return focus_; }
  const KeyboardFocus& focus() const { return focus_; }
  /// At the end of each frame; see `KeyboardFocus::take_keys`.
  void take_focus_keys() { focus_.take_keys(items_, *input_, ImGui::GetIO().WantTextInput); }
  float scale() const { return fonts_.scale; }
  /// From pixels at 100 % to pixels now, whole.
  float px(float at_100) const;
  double now_s() const { return now_s_; }
  /// True if something asked for one more frame (a spinner, a hold).
  bool animating() const { return animating_; }
  void animate() { animating_ = true; }

  /// True if a canvas was under the pointer in the last frame: the wheel is for it.
  bool wheel_taken() const { return wheel_was_taken_; }
  void take_wheel() { wheel_taken_ = true; }

  /// A sentence for the status line, set by what was under the pointer in the last frame.
  const std::string& hint() const { return shown_hint_; }
  void set_hint(std::string_view text) { hint_ = text; }

  /// The path of the item whose tooltip is on screen; empty: none is.
  const std::string& tooltip() const { return tooltip_; }
  void set_tooltip(std::string_view path) { tooltip_ = path; }

  /// True once the pointer has rested on the item at `path` for a moment; call each frame that it is hovered. Not after
  /// a click, until the pointer has been elsewhere: who has pressed the button knows it.
  bool rested_on(std::string_view path);

  void begin_frame(double now_s);
  void set_theme(const Theme& theme) { theme_ = theme; }
  void set_fonts(const Fonts& fonts) { fonts_ = fonts; }
  /// The gamepad as it is held in this frame; nothing if none is connected.
  const std::optional<trial::GamepadLook>& gamepad() const { return gamepad_; }
  void set_gamepad(const std::optional<trial::GamepadLook>& look) { gamepad_ = look; }

 private:
  Theme theme_ = make_theme(ThemeKind::kDark);
  Fonts fonts_;
  TextureStore* textures_;
  InputQueue* input_;
  std::shared_ptr<const Keymap> keymap_;
  std::optional<trial::GamepadLook> gamepad_;
  ItemLog items_;
  std::string hint_;
  std::string shown_hint_;
  double now_s_ = 0.0;
  bool animating_ = false;
  bool wheel_taken_ = false;
  bool wheel_was_taken_ = false;
  KeyboardFocus focus_;
  std::string hovered_path_;
  std::string clicked_path_;
  std::string tooltip_;
  bool moved_since_click_ = true;
  double hovered_since_s_ = 0.0;
  bool hovered_now_ = false;
};

/// Opens a level of the item path and of ImGui's ids until the end of the block.
class Scope {
 public:
  Scope(Ui& ui, std::string_view name);
  ~Scope();
  Scope(const Scope&) = delete;
  Scope& operator=(const Scope&) = delete;

 private:
  Ui& ui_;
};

/// Uses a font until the end of the block.
class FontScope {
 public:
  explicit FontScope(ImFont* font) { ImGui::PushFont(font); }
  ~FontScope() { ImGui::PopFont(); }
  FontScope(const FontScope&) = delete;
  FontScope& operator=(const FontScope&) = delete;
};

/// Uses one colour of ImGui's style until the end of the block.
class ColourScope {
 public:
  ColourScope(ImGuiCol slot, Rgba colour) { ImGui::PushStyleColor(slot, to_vec4(colour)); }
  ~ColourScope() { ImGui::PopStyleColor(); }
  ColourScope(const ColourScope&) = delete;
  ColourScope& operator=(const ColourScope&) = delete;
};

}  // namespace trocar::ui
