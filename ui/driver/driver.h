/// Uses the window as a person would, by the labels on it: for scripts and tests.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "engine/core/result.h"
#include "ui/session.h"

namespace trocar::ui {

/// Each act takes as many frames as a hand would need: presses are held for a frame. Paths are those of
/// `ItemLog::find`. Errors: kNotFound with the paths most like the one asked for; kCheckFailed for an item that is
/// disabled (with its reason), out of sight, or not as expected.
class Driver {
 public:
  /// `step` draws one frame of the session.
  Driver(Session& session, std::function<Status()> step) : session_(session), step_(std::move(step)) {}

  Status click(std::string_view path) { return press(path, 0, 1); }
  Status right_click(std::string_view path) { return press(path, 1, 1); }
  Status double_click(std::string_view path) { return press(path, 0, 2); }
  Status hover(std::string_view path);
  /// From the item's middle by `dx`, `dy` pixels, in `frames` moves.
  Status drag(std::string_view path, float dx, float dy, int button = 0, int frames = 8);
  /// The same without letting go.
  Status hold(std::string_view path, float dx, float dy, int button = 0, int frames = 8);
  Status wheel(std::string_view path, float steps);
  /// Puts the keyboard into a field, replaces what is there and presses Enter.
  Status type(std::string_view path, std::string_view text);
  /// Drops a file on the window.
  Status drop(std::string_view path);
  /// "Ctrl+Shift+T". Errors: kInvalidArgument.
  Status key(std::string_view chord);

  /// Ctrl, Shift, Alt or a key ("W"), held for what is done until it is let go. Errors: kInvalidArgument.
  Status held(std::string_view name, bool down);

  Result<Item> item(std::string_view path) const;
  Status expect_value(std::string_view path, std::string_view value) const;
  Status expect_contains(std::string_view path, std::string_view part) const;
  Status expect_enabled(std::string_view path, bool enabled) const;
  Status expect_present(std::string_view path, bool present) const;

  Status frames(int count);

 private:
  Status press(std::string_view path, int button, int times);
  Status button(int button, bool down);
  Status move(float x, float y);
  Status key_event(Key key, bool down);
  Result<Item> bring_into_sight(std::string_view path);
  Result<Item> ready(std::string_view path);
  /// With the mouse on it, when it no longer moves for what the panel learns meanwhile.
  Result<Item> under_mouse(std::string_view path);

  Session& session_;
  std::function<Status()> step_;
};

}  // namespace trocar::ui
