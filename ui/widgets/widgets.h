/// Widgets that draw themselves with ImGui and say what they are to the item list.
#pragma once

#include <imgui.h>

#include <cstdint>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <string_view>

#include "ui/widgets/ui.h"

namespace trocar::ui {

enum class ButtonStyle { kNormal, kPrimary, kQuiet, kDanger };

/// What may be said about any widget. `reason` not empty disables it and is shown as its tooltip.
struct WidgetOptions {
  const char* icon = nullptr;
  bool icon_only = false;  ///< The label is only its name.
  bool says_keys = false;  ///< The shortcut stands behind the label, too.
  std::string_view help = {};
  std::string_view shortcut = {};
  std::string_view reason = {};
  float width = 0.0F;  ///< Pixels; 0: as needed; < 0: what is left.
  ButtonStyle style = ButtonStyle::kNormal;
  float height = 0.0F;  ///< Of a row, pixels; 0: one line.
  bool again = false;   ///< Of a choice: what is chosen can be chosen once more.
};

/// Notes the last ImGui item (or `rect`) in the item list and shows its tooltip.
void note_item(Ui& ui, std::string_view role, std::string_view label, std::string_view value,
               const WidgetOptions& options);
void note_rect(Ui& ui, std::string_view role, std::string_view label, std::string_view value, const Rect& rect,
               const WidgetOptions& options = {});
/// The last ImGui item's rectangle.
Rect item_rect();

bool button(Ui& ui, std::string_view label, const WidgetOptions& options = {});
/// Only the icon is drawn; the label is its name.
bool icon_button(Ui& ui, std::string_view label, const WidgetOptions& options);
/// A button that stays down. Returns true when clicked.
bool toggle(Ui& ui, std::string_view label, bool on, const WidgetOptions& options = {});
/// A toggle whose words differ from its name.
bool toggle_shown_as(Ui& ui, std::string_view label, const std::string& words, bool on, const WidgetOptions& options);
bool checkbox(Ui& ui, std::string_view label, bool& on, const WidgetOptions& options = {});
/// A drop-down list; its items are at "…/label/name". Returns true when another was chosen.
bool combo(Ui& ui, std::string_view label, int& chosen, std::span<const std::string> names,
           const WidgetOptions& options = {});
bool slider_int(Ui& ui, std::string_view label, int& value, int low, int high, const char* format,
                const WidgetOptions& options = {});
bool slider_float(Ui& ui, std::string_view label, float& value, float low, float high, const char* format,
                  const WidgetOptions& options = {});
/// A typed number; the value is taken on Enter or when the field is left, and kept within its bounds.
bool number_field(Ui& ui, std::string_view label, std::int64_t& value, std::int64_t low, std::int64_t high,
                  const WidgetOptions& options = {});
/// Returns true when Enter was pressed or the field was left after an edit.
bool text_field(Ui& ui, std::string_view label, std::string& text, std::string_view hint,
                const WidgetOptions& options = {});
/// A choice among few, side by side, in rows where that is narrow. Returns true when another was chosen.
bool segmented(Ui& ui, std::string_view label, int& chosen, std::span<const std::string> names,
               const WidgetOptions& options = {});
/// A whole row of the current table or list that can be selected.
bool selectable_row(Ui& ui, std::string_view label, bool selected, std::string_view value,
                    const WidgetOptions& options = {});
/// An area that is drawn by hand and takes the mouse; all three buttons.
bool canvas(Ui& ui, std::string_view label, ImVec2 size, std::string_view value, const WidgetOptions& options = {});

void progress_bar(Ui& ui, std::string_view label, double fraction, float width);
/// Names for the rows of one list in one frame: the second "Expert" is "Expert #2", so that each can be told apart.
class UniqueNames {
 public:
  std::string operator()(std::string_view name);

 private:
  std::map<std::string, int, std::less<>> seen_;
};

/// Puts the next widget, `width` pixels wide, beside the last one if there is room, else below.
void flow(float width, float spacing);
/// What a button with these words needs; `icon` may be null. `keys`: of one that says them.
float button_width(const Ui& ui, std::string_view label, const char* icon, std::string_view keys = {});

/// A thin bar for a share, drawn in place, no item of its own.
void share_bar(Ui& ui, double share, Rgba colour, ImVec2 size);
void spinner(Ui& ui, float radius, Rgba colour);
/// The same without taking room.
void spinner_at(Ui& ui, ImVec2 centre, float radius, Rgba colour);

void text(Ui& ui, std::string_view words);
void dim_text(Ui& ui, std::string_view words);
void wrapped_text(Ui& ui, std::string_view words, Rgba colour);
void heading(Ui& ui, std::string_view words);
void small_text(Ui& ui, std::string_view words, Rgba colour);
/// A word on a tinted ground; with its sign it does not depend on colour. Wraps where it does not fit.
void badge(Ui& ui, const char* icon, std::string_view words, Rgba colour, std::string_view help = {});
/// What it takes beside other things.
float badge_width(const Ui& ui, const char* icon, std::string_view words);
/// "Samples" on the left, dim; "2,480" on the right half, or below where it does not fit.
void fact(Ui& ui, std::string_view name, std::string_view value);
/// The name of a form's field, dim, in a left column; the next widget fills the rest. Above it where that is narrow.
void form_label(Ui& ui, std::string_view name);
/// `words` cut with … to `width` pixels in the current font.
std::string fitted(std::string_view words, float width);

struct EmptyStateAction {
  std::string_view label;
  const char* icon = nullptr;
  std::string_view reason = {};
  std::string_view help = {};
};
/// One sentence and up to three buttons in the middle of what is left of the region, or of `height` pixels. Returns the
/// button clicked, or −1.
int empty_state(Ui& ui, const char* icon, std::string_view title, std::string_view sentence,
                std::span<const EmptyStateAction> actions, float height = 0.0F);

/// Between two tiles: `position` follows the mouse while it is dragged. `vertical` separates left from right. Returns
/// true while it moves.
bool splitter(Ui& ui, std::string_view label, bool vertical, const Rect& rect, float& position, bool& equalise);

}  // namespace trocar::ui
