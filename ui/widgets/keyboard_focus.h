/// Tab and Shift+Tab from widget to widget, Enter or Space to press it, the arrows within a list: all that the mouse
/// presses can be reached without one. ImGui's own navigation would take the arrow keys from the timeline.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "ui/widgets/item_log.h"
#include "ui/window/input.h"

namespace trocar::ui {

/// Threads: that of the window.
class KeyboardFocus {
 public:
  /// The ring is on this item.
  bool is_on(const Item& item) const { return shown_ && item.layer == layer_ && item.path == path_; }
  /// True once after the ring has moved: the item shall be scrolled into sight.
  bool take_scroll();
  /// The ring is to be seen: Enter, Space and the up and down arrows are the focus's, and no shortcuts.
  bool shown() const { return shown_; }
  /// Of the item with the ring, or where it was last.
  const std::string& path() const { return path_; }
  /// The text field at `path` shall take the keyboard now; true once.
  bool take_typing(const std::string& path);

  /// Moves the ring or presses what it is on, as the keys of this frame say; presses become clicks in `input`. Call at
  /// the end of each frame, with all its items. `typing`: a text field has the keyboard; Tab leaves it.
  void take_keys(const ItemLog& items, InputQueue& input, bool typing);

 private:
  void move(const std::vector<const Item*>& stops, int step);
  void press(const Item& item, InputQueue& input);
  const Item* current(const std::vector<const Item*>& stops) const;

  std::uint32_t layer_ = 0;
  std::string path_;
  std::map<std::uint32_t, std::string> last_;  ///< Where it was, by layer: a closed pop-up gives the ring back.
  bool shown_ = false;
  bool scroll_ = false;
  bool type_ = false;       ///< The field has just been reached.
  bool own_click_ = false;  ///< A press is on its way, which does not take the ring away.
};

}  // namespace trocar::ui
