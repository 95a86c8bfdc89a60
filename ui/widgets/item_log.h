/// The list of everything on screen in one frame, by label: what tests, scripts, the dump and the palette go by.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace trocar::ui {

/// Pixels from the top left of the window.
struct Rect {
  float x0 = 0.0F;
  float y0 = 0.0F;
  float x1 = 0.0F;
  float y1 = 0.0F;

  float width() const { return x1 - x0; }
  float height() const { return y1 - y0; }
  float centre_x() const { return 0.5F * (x0 + x1); }
  float centre_y() const { return 0.5F * (y0 + y1); }
  bool contains(float x, float y) const { return x >= x0 && y >= y0 && x < x1 && y < y1; }
};

struct Item {
  std::string path;  ///< "Library/Record…": the scopes and the label.
  std::string role;  ///< button, toggle, checkbox, combo, slider, field, row, tab, menu, canvas, progress, text, plot,
                     ///< mark (a place on a canvas).
  std::string label;
  std::string value;  ///< As shown; "" if it has none.
  bool enabled = true;
  std::string reason;  ///< Why it is disabled, or "".
  Rect rect;
  Rect clip;                 ///< What of the window its region shows.
  float room_y = 0.0F;       ///< The tallest that its region shows at once, pixels; 0: as `clip`.
  bool scrolls_x = false;    ///< Its region can be scrolled sideways.
  bool scrolls_y = false;    ///< … up and down.
  std::uint32_t region = 0;  ///< Which region it lies in; equal for neighbours.
  std::uint32_t layer = 0;   ///< The window, form or pop-up that its region belongs to.
  std::string help;
  std::string shortcut;
  bool text_clipped = false;  ///< Its text is wider than its place, or its place is cut off and cannot be scrolled to.

  /// Where it is pressed: in the middle, or in the middle of what its region shows of it where it is wider than that.
  float press_x() const {
    const bool wider = rect.width() > clip.width();
    return wider ? 0.5F * (std::max(rect.x0, clip.x0) + std::min(rect.x1, clip.x1)) : rect.centre_x();
  }
  bool reachable() const { return clip.contains(press_x(), rect.centre_y()); }
};

/// Threads: that of the window.
class ItemLog {
 public:
  void begin_frame();
  void push(std::string_view scope);
  void pop();
  /// What an item with this label would be called here.
  std::string path_of(std::string_view label) const { return prefix_ + std::string(label); }
  /// The path is made of the open scopes and `item.label`.
  void add(Item item);
  /// The last item's text is `width` wide and needs `padding` beside it; notes whether it is cut off.
  void note_text(float width, float padding);

  /// For what is known only after the item was noted.
  void set_last_value(std::string_view value) { items_.back().value = value; }
  /// What belongs to the last item goes on to `x1` pixels; notes whether that is cut off.
  void note_end(float x1);

  const std::vector<Item>& items() const { return items_; }
  /// An item whose path is `path`, or ends with "/" + `path`; the case of letters and a trailing "…" do not matter. An
  /// exact path wins; among equals, the last drawn (pop-ups lie on top). Null if there is none.
  const Item* find(std::string_view path) const;
  /// The paths most like `path`, for a helpful error.
  std::vector<std::string> similar(std::string_view path, std::size_t count) const;
  /// The whole list as a JSON array, one object for each item.
  std::string to_json() const;

 private:
  std::vector<Item> items_;
  std::string prefix_;
  std::vector<std::size_t> lengths_;
};

}  // namespace trocar::ui
