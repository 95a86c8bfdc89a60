#include "ui/driver/driver.h"

#include <fmt/format.h>

#include <vector>

#include "ui/shortcut.h"

namespace trocar::ui {
namespace {

std::string in_quotes(std::string_view words) {
  return fmt::format("\"{}\"", words);
}

std::vector<std::uint32_t> codepoints(std::string_view text) {
  std::vector<std::uint32_t> list;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if ((byte & 0xC0U) == 0x80U && !list.empty()) {
      list.back() = list.back() << 6U | (byte & 0x3FU);
    } else if (byte < 0x80U) {
      list.push_back(byte);
    } else {
      list.push_back(byte & (byte >= 0xF0U ? 0x07U : byte >= 0xE0U ? 0x0FU : 0x1FU));
    }
  }
  return list;
}

}  // namespace

Result<Item> Driver::item(std::string_view path) const {
  if (const Item* found = session_.items().find(path)) return *found;
  std::string message = fmt::format("nothing on screen is called {}", in_quotes(path));
  const std::vector<std::string> near = session_.items().similar(path, 3);
  for (std::size_t i = 0; i < near.size(); ++i) message += (i == 0 ? "; there is " : ", ") + in_quotes(near[i]);
  return fail(ErrorCode::kNotFound, message);
}

Status Driver::frames(int count) {
  for (int i = 0; i < count; ++i) TROCAR_RETURN_IF_ERROR(step_());
  return {};
}

Status Driver::move(float x, float y) {
  session_.window().input().push(MouseMoved{x, y});
  return step_();
}

Status Driver::button(int which, bool down) {
  session_.window().input().push(MouseButton{which, down});
  return step_();
}

Status Driver::key_event(Key key, bool down) {
  session_.window().input().push(KeyChanged{key, down});
  return step_();
}

Result<Item> Driver::bring_into_sight(std::string_view path) {
  constexpr int kMostTurns = 60;
  for (int turn = 0; turn < kMostTurns; ++turn) {
    TROCAR_ASSIGN_OR_RETURN(const Item found, item(path));
    if (found.reachable()) return found;
    // At the edge: in the middle the wheel may be a map's, which steps through slices and does not scroll.
    TROCAR_RETURN_IF_ERROR(move(found.clip.x0 + 4.0F, found.clip.centre_y()));
    session_.window().input().push(MouseWheel{0.0F, found.rect.centre_y() < found.clip.y0 ? 1.0F : -1.0F});
    TROCAR_RETURN_IF_ERROR(frames(2));
  }
  return fail(ErrorCode::kCheckFailed, in_quotes(path) + " cannot be scrolled into sight");
}

Result<Item> Driver::ready(std::string_view path) {
  TROCAR_ASSIGN_OR_RETURN(Item found, bring_into_sight(path));
  if (!found.enabled) return fail(ErrorCode::kCheckFailed, in_quotes(path) + " is disabled: " + found.reason);
  return found;
}

Status Driver::hover(std::string_view path) {
  TROCAR_ASSIGN_OR_RETURN(const Item found, bring_into_sight(path));
  TROCAR_RETURN_IF_ERROR(move(found.press_x(), found.rect.centre_y()));
  return step_();
}

Result<Item> Driver::under_mouse(std::string_view path) {
  constexpr int kMostTurns = 60;
  for (int turn = 0; turn < kMostTurns; ++turn) {
    TROCAR_ASSIGN_OR_RETURN(const Item found, ready(path));
    TROCAR_RETURN_IF_ERROR(move(found.press_x(), found.rect.centre_y()));
    const Item* now = session_.items().find(path);
    if (now != nullptr && now->press_x() == found.press_x() && now->rect.centre_y() == found.rect.centre_y()) {
      return found;
    }
  }
  return fail(ErrorCode::kCheckFailed, in_quotes(path) + " does not stay where it is");
}

Status Driver::press(std::string_view path, int which, int times) {
  TROCAR_ASSIGN_OR_RETURN(const Item found, under_mouse(path));
  for (int i = 0; i < times; ++i) {
    TROCAR_RETURN_IF_ERROR(button(which, true));
    TROCAR_RETURN_IF_ERROR(button(which, false));
  }
  return step_();
}

Status Driver::drag(std::string_view path, float dx, float dy, int which, int frames_of_drag) {
  TROCAR_RETURN_IF_ERROR(hold(path, dx, dy, which, frames_of_drag));
  TROCAR_RETURN_IF_ERROR(button(which, false));
  return step_();
}

Status Driver::hold(std::string_view path, float dx, float dy, int which, int frames_of_drag) {
  TROCAR_ASSIGN_OR_RETURN(const Item found, under_mouse(path));
  const float x = found.press_x();
  const float y = found.rect.centre_y();
  TROCAR_RETURN_IF_ERROR(button(which, true));
  for (int i = 1; i <= frames_of_drag; ++i) {
    const float share = static_cast<float>(i) / static_cast<float>(frames_of_drag);
    TROCAR_RETURN_IF_ERROR(move(x + dx * share, y + dy * share));
  }
  return {};
}

Status Driver::wheel(std::string_view path, float steps) {
  TROCAR_RETURN_IF_ERROR(hover(path));
  session_.window().input().push(MouseWheel{0.0F, steps});
  return frames(2);
}

Status Driver::type(std::string_view path, std::string_view text) {
  TROCAR_ASSIGN_OR_RETURN(const Item found, item(path));
  const bool slider = found.role == "slider";
  if (found.role != "field" && !slider) {
    return fail(ErrorCode::kInvalidArgument, fmt::format("{} is a {} and takes no text; type goes to a field or slider",
                                                         in_quotes(found.path), found.role));
  }
  // A slider takes a number when it is clicked with Ctrl.
  if (slider) TROCAR_RETURN_IF_ERROR(held("Ctrl", true));
  TROCAR_RETURN_IF_ERROR(click(path));
  if (slider) TROCAR_RETURN_IF_ERROR(held("Ctrl", false));
  TROCAR_RETURN_IF_ERROR(key("Ctrl+A"));
  if (text.empty()) TROCAR_RETURN_IF_ERROR(key("Delete"));
  for (const std::uint32_t codepoint : codepoints(text)) session_.window().input().push(Typed{codepoint});
  TROCAR_RETURN_IF_ERROR(step_());
  return key("Enter");
}

Status Driver::held(std::string_view name, bool down) {
  if (name == "Ctrl") return key_event(Key::kLeftControl, down);
  if (name == "Shift") return key_event(Key::kLeftShift, down);
  if (name == "Alt") return key_event(Key::kLeftAlt, down);
  TROCAR_ASSIGN_OR_RETURN(const Chord chord, chord_from(name));
  if (chord.modifiers.control || chord.modifiers.shift || chord.modifiers.alt) {
    return fail(ErrorCode::kInvalidArgument, fmt::format("{} is more than one key", in_quotes(name)));
  }
  return key_event(chord.key, down);
}

Status Driver::drop(std::string_view path) {
  session_.window().input().push(Dropped{std::string(path)});
  return frames(2);
}

Status Driver::key(std::string_view words) {
  TROCAR_ASSIGN_OR_RETURN(const Chord chord, chord_from(words));
  std::vector<Key> held;
  if (chord.modifiers.control) held.push_back(Key::kLeftControl);
  if (chord.modifiers.shift) held.push_back(Key::kLeftShift);
  if (chord.modifiers.alt) held.push_back(Key::kLeftAlt);
  for (const Key key : held) TROCAR_RETURN_IF_ERROR(key_event(key, true));
  TROCAR_RETURN_IF_ERROR(key_event(chord.key, true));
  TROCAR_RETURN_IF_ERROR(key_event(chord.key, false));
  for (const Key key : held) TROCAR_RETURN_IF_ERROR(key_event(key, false));
  return step_();
}

Status Driver::expect_value(std::string_view path, std::string_view value) const {
  TROCAR_ASSIGN_OR_RETURN(const Item found, item(path));
  if (found.value == value) return {};
  return fail(ErrorCode::kCheckFailed, in_quotes(path) + " is " + in_quotes(found.value) + ", not " + in_quotes(value));
}

Status Driver::expect_contains(std::string_view path, std::string_view part) const {
  TROCAR_ASSIGN_OR_RETURN(const Item found, item(path));
  if (found.value.find(part) != std::string::npos) return {};
  return fail(ErrorCode::kCheckFailed,
              in_quotes(path) + " is " + in_quotes(found.value) + " and has no " + in_quotes(part));
}

Status Driver::expect_enabled(std::string_view path, bool enabled) const {
  TROCAR_ASSIGN_OR_RETURN(const Item found, item(path));
  if (found.enabled == enabled) return {};
  if (enabled) return fail(ErrorCode::kCheckFailed, in_quotes(path) + " is disabled: " + found.reason);
  return fail(ErrorCode::kCheckFailed, in_quotes(path) + " is enabled");
}

Status Driver::expect_present(std::string_view path, bool present) const {
  if (present) {
    TROCAR_ASSIGN_OR_RETURN([[maybe_unused]] const Item found, item(path));
    return {};
  }
  if (session_.items().find(path) == nullptr) return {};
  return fail(ErrorCode::kCheckFailed, in_quotes(path) + " is on screen");
}

}  // namespace trocar::ui
