#include "ui/widgets/keyboard_focus.h"

#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <utility>

namespace trocar::ui {
namespace {

constexpr std::array<std::string_view, 12> kStops{"button", "toggle", "checkbox", "combo",  "slider",    "field",
                                                  "row",    "tab",    "menu",     "option", "menu item", "plot"};

bool is_stop(const Item& item) {
  const bool role = std::find(kStops.begin(), kStops.end(), item.role) != kStops.end();
  return role && item.enabled && item.rect.width() > 0.0F && item.rect.height() > 0.0F;
}

bool in_list(const Item& item) {
  return item.role == "row" || item.role == "option" || item.role == "menu item";
}

/// The layer that takes keys: the topmost pop-up, else the form or window that was used last.
std::uint32_t front_layer(const ItemLog& items) {
  const ImGuiContext& context = *ImGui::GetCurrentContext();
  for (int i = context.OpenPopupStack.Size - 1; i >= 0; --i) {
    const ImGuiWindow* popup = context.OpenPopupStack[i].Window;
    if (popup != nullptr && popup->Active) return popup->ID;
  }
  if (context.NavWindow != nullptr) return context.NavWindow->RootWindow->ID;
  return items.items().empty() ? 0 : items.items().front().layer;
}

std::vector<const Item*> stops_of(const ItemLog& items, std::uint32_t layer) {
  std::vector<const Item*> stops;
  for (const Item& item : items.items()) {
    if (item.layer != layer || !is_stop(item)) continue;
    const bool again =
        std::any_of(stops.begin(), stops.end(), [&](const Item* other) { return other->path == item.path; });
    if (!again) stops.push_back(&item);
  }
  return stops;
}

}  // namespace

bool KeyboardFocus::take_scroll() {
  return std::exchange(scroll_, false);
}

bool KeyboardFocus::take_typing(const std::string& path) {
  return type_ && path == path_ && std::exchange(type_, false);
}

const Item* KeyboardFocus::current(const std::vector<const Item*>& stops) const {
  const auto found = std::find_if(stops.begin(), stops.end(), [this](const Item* item) { return item->path == path_; });
  return found == stops.end() ? nullptr : *found;
}

void KeyboardFocus::move(const std::vector<const Item*>& stops, int step) {
  if (stops.empty()) return;
  const auto count = static_cast<int>(stops.size());
  const auto found = std::find_if(stops.begin(), stops.end(), [this](const Item* item) { return item->path == path_; });
  int next = step > 0 ? 0 : count - 1;
  if (found != stops.end()) next = (static_cast<int>(found - stops.begin()) + step + count) % count;
  const Item& item = *stops[static_cast<std::size_t>(next)];
  path_ = item.path;
  last_[layer_] = path_;
  shown_ = scroll_ = true;
  type_ = item.role == "field";
}

void KeyboardFocus::press(const Item& item, InputQueue& input) {
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  // A slider takes a typed number on a click with Ctrl.
  const bool slider = item.role == "slider";
  if (slider) input.push(KeyChanged{Key::kLeftControl, true});
  input.push(MouseMoved{item.press_x(), item.rect.centre_y()});
  input.push(MouseButton{0, true});
  input.push(MouseButton{0, false});
  if (slider) input.push(KeyChanged{Key::kLeftControl, false});
  input.push(MouseMoved{mouse.x, mouse.y});
  own_click_ = true;
}

void KeyboardFocus::take_keys(const ItemLog& items, InputQueue& input, bool typing) {
  if (ImGui::IsMouseClicked(0) || ImGui::IsMouseClicked(1)) shown_ = std::exchange(own_click_, false) && shown_;
  const Modifiers held = input.modifiers();
  if (held.control || held.alt) return;
  const bool tab = input.pressed(Key::kTab);
  const bool enter = input.pressed(Key::kEnter) || input.pressed(Key::kKeypadEnter);
  const bool push = !typing && shown_ && (enter || input.pressed(Key::kSpace));
  const int arrow = typing || !shown_ ? 0 : (input.pressed(Key::kDown) ? 1 : 0) - (input.pressed(Key::kUp) ? 1 : 0);
  if (input.pressed(Key::kEscape)) shown_ = false;
  const std::uint32_t front = front_layer(items);
  if (front != layer_) {
    layer_ = front;
    const auto before = last_.find(front);
    path_ = before == last_.end() ? std::string() : before->second;
  }
  if (!tab && !push && arrow == 0) return;
  std::vector<const Item*> stops = stops_of(items, front);
  const Item* here = current(stops);
  if (tab) return move(stops, held.shift ? -1 : 1);
  if (here == nullptr) return;
  // A click on a plot is a click on a time; the keyboard has its own way there.
  if (push && here->role != "plot" && here->reachable()) press(*here, input);
  if (arrow == 0 || !in_list(*here)) return;
  std::erase_if(stops, [here](const Item* item) { return item->role != here->role || item->region != here->region; });
  move(stops, arrow);
}

}  // namespace trocar::ui
