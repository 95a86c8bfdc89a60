#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "ui/widgets/widgets.h"

namespace trocar::ui {

namespace {

std::string badge_words(const char* icon, std::string_view words) {
  return icon == nullptr ? std::string(words) : std::string(icon) + " " + std::string(words);
}

}  // namespace

void text(Ui& ui, std::string_view words) {
  ImGui::TextUnformatted(words.data(), words.data() + words.size());
  note_item(ui, "text", words, "", {});
}

void dim_text(Ui& ui, std::string_view words) {
  const ColourScope colour(ImGuiCol_Text, ui.theme().text_dim);
  text(ui, words);
}

void wrapped_text(Ui& ui, std::string_view words, Rgba colour) {
  const ColourScope scope(ImGuiCol_Text, colour);
  ImGui::PushTextWrapPos(0.0F);
  ImGui::TextUnformatted(words.data(), words.data() + words.size());
  ImGui::PopTextWrapPos();
  note_item(ui, "text", words, "", {});
}

void heading(Ui& ui, std::string_view words) {
  const FontScope font(ui.fonts().strong);
  ImGui::AlignTextToFramePadding();
  text(ui, words);
}

void small_text(Ui& ui, std::string_view words, Rgba colour) {
  const FontScope font(ui.fonts().small);
  const ColourScope scope(ImGuiCol_Text, colour);
  text(ui, words);
}

float badge_width(const Ui& ui, const char* icon, std::string_view words) {
  const FontScope font(ui.fonts().small);
  return ImGui::CalcTextSize(badge_words(icon, words).c_str()).x + 2.0F * ui.px(7);
}

void badge(Ui& ui, const char* icon, std::string_view words, Rgba colour, std::string_view help) {
  const FontScope font(ui.fonts().small);
  const std::string shown = badge_words(icon, words);
  const ImVec2 padding{ui.px(7), ui.px(2)};
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float wrap = std::max(ImGui::GetContentRegionAvail().x - 2.0F * padding.x, ui.px(60)) + 1.0F;
  const ImVec2 size = ImGui::CalcTextSize(shown.c_str(), nullptr, false, wrap);
  const ImVec2 end{at.x + size.x + 2 * padding.x, at.y + size.y + 2 * padding.y};
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(at, end, to_u32(mix(ui.theme().panel, colour, kBadgeTint)), ui.px(9));
  list.AddText(ImGui::GetFont(), ImGui::GetFontSize(), {at.x + padding.x, at.y + padding.y}, to_u32(colour),
               shown.c_str(), nullptr, wrap);
  ImGui::Dummy({end.x - at.x, end.y - at.y});
  note_item(ui, "text", words, "", {.help = help});
}

std::string fitted(std::string_view words, float width) {
  std::string shown(words);
  if (ImGui::CalcTextSize(shown.c_str()).x <= width) return shown;
  while (!shown.empty() && ImGui::CalcTextSize((shown + "…").c_str()).x > width) {
    do {
      shown.pop_back();
    } while (!shown.empty() && (static_cast<unsigned char>(shown.back()) & 0xC0U) == 0x80U);
    if (!shown.empty() && (static_cast<unsigned char>(shown.back()) & 0xC0U) == 0xC0U) shown.pop_back();
  }
  return shown + "…";
}

std::string UniqueNames::operator()(std::string_view name) {
  std::string unique(name);
  const int times = ++seen_[unique];
  return times == 1 ? unique : unique + " #" + std::to_string(times);
}

void fact(Ui& ui, std::string_view name, std::string_view value) {
  const float left = ImGui::GetCursorPosX();
  const float width = ImGui::GetContentRegionAvail().x;
  const auto width_of = [](std::string_view words) {
    return ImGui::CalcTextSize(words.data(), words.data() + words.size()).x;
  };
  const float column = std::max(std::min(ui.px(150), 0.45F * width), width_of(name) + ui.px(8));
  {
    const ColourScope colour(ImGuiCol_Text, ui.theme().text_dim);
    ImGui::TextUnformatted(name.data(), name.data() + name.size());
  }
  if (column + width_of(value) <= width) {
    ImGui::SameLine();
    ImGui::SetCursorPosX(left + column);
  } else {
    ImGui::SetCursorPosX(left + ui.px(10));
  }
  ImGui::PushTextWrapPos(0.0F);
  ImGui::TextUnformatted(value.data(), value.data() + value.size());
  ImGui::PopTextWrapPos();
  note_item(ui, "text", name, value, {.help = value});
}

void form_label(Ui& ui, std::string_view name) {
  const float left = ImGui::GetCursorPosX();
  const float room = ImGui::GetContentRegionAvail().x;
  const float column = std::min(ui.px(122), 0.4F * room);
  const float words = ImGui::CalcTextSize(name.data(), name.data() + name.size()).x;
  const bool above = room < ui.px(260) || words + ui.px(6) > column;
  if (!above) ImGui::AlignTextToFramePadding();
  {
    const ColourScope colour(ImGuiCol_Text, ui.theme().text_dim);
    ImGui::TextUnformatted(name.data(), name.data() + name.size());
  }
  if (!above) ImGui::SameLine(left + column);
}

void progress_bar(Ui& ui, std::string_view label, double fraction, float width) {
  const float height = ui.px(5);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float shown = static_cast<float>(std::clamp(fraction, 0.0, 1.0));
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(at, {at.x + width, at.y + height}, to_u32(ui.theme().raised), 0.5F * height);
  if (shown > 0.0F) {
    list.AddRectFilled(at, {at.x + std::max(width * shown, height), at.y + height}, to_u32(ui.theme().accent),
                       0.5F * height);
  }
  ImGui::Dummy({width, height});
  note_item(ui, "progress", label, std::to_string(static_cast<int>(std::lround(100.0 * fraction))) + " %", {});
}

void share_bar(Ui& ui, double share, Rgba colour, ImVec2 size) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float filled = size.x * static_cast<float>(std::clamp(share, 0.0, 1.0));
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(at, {at.x + size.x, at.y + size.y}, to_u32(ui.theme().raised), ui.px(2));
  if (filled >= 1.0F) list.AddRectFilled(at, {at.x + filled, at.y + size.y}, to_u32(colour), ui.px(2));
  ImGui::Dummy(size);
}

void spinner_at(Ui& ui, ImVec2 centre, float radius, Rgba colour) {
  ui.animate();
  const auto turn = static_cast<float>(std::fmod(ui.now_s() * 1.2, 1.0) * 2.0 * std::numbers::pi);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.PathArcTo(centre, radius - 1.5F, turn, turn + 4.2F, 20);
  list.PathStroke(to_u32(colour), ImDrawFlags_None, std::max(2.0F, radius * 0.22F));
}

void spinner(Ui& ui, float radius, Rgba colour) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  spinner_at(ui, {at.x + radius, at.y + radius}, radius, colour);
  ImGui::Dummy({2 * radius, 2 * radius});
}

namespace {

void centred_line(Ui& ui, ImFont* font, std::string_view words, Rgba colour, float left, float width) {
  const FontScope scope(font);
  const ColourScope text_colour(ImGuiCol_Text, colour);
  const float wrap = std::min(width - ui.px(24), ui.px(420));
  const ImVec2 size = ImGui::CalcTextSize(words.data(), words.data() + words.size(), false, wrap);
  ImGui::SetCursorPosX(left + 0.5F * (width - size.x));
  ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + size.x + 1.0F);
  ImGui::TextUnformatted(words.data(), words.data() + words.size());
  ImGui::PopTextWrapPos();
}

}  // namespace

float button_width(const Ui& ui, std::string_view label, const char* icon, std::string_view keys) {
  std::string words(label);
  if (icon != nullptr) words = std::string(icon) + "  " + words;
  if (!keys.empty()) words += "   " + std::string(keys);
  return std::ceil(ImGui::CalcTextSize(words.c_str()).x + 2.0F * ImGui::GetStyle().FramePadding.x) + ui.px(4);
}

void flow(float width, float spacing) {
  const float right = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
  if (ImGui::GetItemRectMax().x + spacing + width <= right + 0.5F) ImGui::SameLine(0.0F, spacing);
}

int empty_state(Ui& ui, const char* icon, std::string_view title, std::string_view sentence,
                std::span<const EmptyStateAction> actions, float height_given) {
  ImVec2 room = ImGui::GetContentRegionAvail();
  if (height_given > 0.0F) room.y = height_given;
  const float left = ImGui::GetCursorPosX();
  const float spacing = ImGui::GetStyle().ItemSpacing.x;
  float buttons = 0.0F;
  for (const EmptyStateAction& action : actions) buttons += button_width(ui, action.label, action.icon) + spacing;
  const bool stacked = buttons - spacing > room.x - ui.px(16);
  const auto rows = static_cast<float>(actions.empty() ? 0 : stacked ? actions.size() : 1);
  const float height = ui.px(34) + ui.px(24) + ui.px(46) + rows * (ImGui::GetFrameHeight() + ui.px(7));
  ImGui::SetCursorPosY(ImGui::GetCursorPosY() + std::max(ui.px(6), 0.44F * (room.y - height)));
  if (*icon != '\0' && room.y > ui.px(150))
    centred_line(ui, ui.fonts().large, icon, ui.theme().text_disabled, left, room.x);
  if (!title.empty()) {
    centred_line(ui, ui.fonts().strong, title, ui.theme().text, left, room.x);
    note_item(ui, "text", title, "", {});
  }
  centred_line(ui, ui.fonts().body, sentence, ui.theme().text_dim, left, room.x);
  note_item(ui, "text", sentence, "", {});
  ImGui::Dummy({0.0F, ui.px(2)});
  int clicked = -1;
  if (!stacked) ImGui::SetCursorPosX(left + 0.5F * (room.x - (buttons - spacing)));
  for (int i = 0; i < static_cast<int>(actions.size()); ++i) {
    const EmptyStateAction& action = actions[static_cast<std::size_t>(i)];
    const float width = button_width(ui, action.label, action.icon);
    if (stacked) ImGui::SetCursorPosX(left + 0.5F * (room.x - width));
    const WidgetOptions options{.icon = action.icon,
                                .help = action.help,
                                .reason = action.reason,
                                .width = width,
                                .style = i == 0 ? ButtonStyle::kPrimary : ButtonStyle::kNormal};
    if (button(ui, action.label, options)) clicked = i;
    if (!stacked && i + 1 < static_cast<int>(actions.size())) ImGui::SameLine();
  }
  return clicked;
}

}  // namespace trocar::ui
