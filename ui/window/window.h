/// What the workbench needs of a window: a size, input, time, and a way to show a frame. Three kinds implement it.
#pragma once

#include <imgui.h>

#include <optional>
#include <string>

#include "engine/core/image.h"
#include "engine/core/result.h"
#include "engine/trial/stick_hands.h"
#include "ui/textures.h"
#include "ui/window/input.h"

namespace trocar::ui {

struct WindowSize {
  int width = 1600;  ///< Pixels.
  int height = 900;
  bool operator==(const WindowSize&) const = default;
};

/// Threads: one, which is the only one with a GL context of the window's kind.
class Window {
 public:
  virtual ~Window() = default;
  virtual WindowSize size() const = 0;
  /// What the screen asks for: 1 is 96 dots an inch.
  virtual float content_scale() const { return 1.0F; }
  /// Seconds since an arbitrary moment. Windows without a screen count frames, so that scripts are repeatable.
  virtual double now_s() const = 0;
  /// Takes in what happened; waits for input at most `timeout_s`.
  virtual void poll(double timeout_s) = 0;
  /// Input waits, or the window was uncovered or changed its size: a frame is due. Windows without a screen say so
  /// always, so that every step of a script draws.
  virtual bool wants_frame() const { return true; }
  /// The keyboard is on it; where that is not so, fewer frames do.
  virtual bool focused() const { return true; }
  /// True once after the user asked for the window to be closed.
  virtual bool take_close_request() { return false; }
  virtual void set_title(const std::string& title) = 0;
  virtual void set_cursor(ImGuiMouseCursor cursor) = 0;
  virtual std::string clipboard() const = 0;
  virtual void set_clipboard(const std::string& text) = 0;

  /// The first gamepad that is connected, as it is held now; nothing if there is none.
  virtual std::optional<trial::GamepadLook> gamepad() { return std::nullopt; }

  /// Called after the atlas was built anew.
  virtual Status upload_fonts(ImFontAtlas& atlas) = 0;
  /// Draws and shows. A frame equal to the last one is not drawn again.
  virtual Status present(const ImDrawData& data, Rgba ground) = 0;
  /// What was presented last; nothing if this window draws nothing. Errors: kIo.
  virtual Result<Image> capture() = 0;

  virtual TextureStore& textures() = 0;
  InputQueue& input() { return input_; }
  const InputQueue& input() const { return input_; }

 private:
  InputQueue input_;
};

}  // namespace trocar::ui
