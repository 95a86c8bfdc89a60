#include <fmt/printf.h>
#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "ui/widgets/widgets.h"

namespace trocar::ui {
namespace {

std::string hidden_id(std::string_view label) {
  return "##" + std::string(label);
}

void begin_field(Ui& ui, const WidgetOptions& options) {
  ImGui::SetNextItemWidth(options.width == 0.0F ? -1.0F : options.width);
  ImGui::PushStyleColor(ImGuiCol_Text, to_vec4(options.reason.empty() ? ui.theme().text : ui.theme().text_disabled));
  if (!options.reason.empty()) ImGui::BeginDisabled();
}

void end_field(const WidgetOptions& options) {
  if (!options.reason.empty()) ImGui::EndDisabled();
  ImGui::PopStyleColor();
}

// A function of its own, so that the scope ends before the combo's window does.
bool draw_choices(Ui& ui, std::string_view label, int& chosen, std::span<const std::string> names) {
  const Scope scope(ui, label);
  bool changed = false;
  for (int i = 0; i < static_cast<int>(names.size()); ++i) {
    const std::string& name = names[static_cast<std::size_t>(i)];
    if (ImGui::Selectable(name.c_str(), i == chosen)) {
      changed = chosen != i;
      chosen = i;
    }
    note_item(ui, "option", name, i == chosen ? "on" : "off", {});
  }
  return changed;
}

}  // namespace

bool combo(Ui& ui, std::string_view label, int& chosen, std::span<const std::string> names,
           const WidgetOptions& options) {
  const bool known = chosen >= 0 && chosen < static_cast<int>(names.size());
  const std::string shown = known ? names[static_cast<std::size_t>(chosen)] : std::string();
  const float width = options.width > 0.0F ? options.width : ImGui::GetContentRegionAvail().x;
  const std::string cut = fitted(shown, width - ImGui::GetFrameHeight() - ui.px(9));
  begin_field(ui, options);
  const bool open = ImGui::BeginCombo(hidden_id(label).c_str(), cut.c_str(), ImGuiComboFlags_HeightLarge);
  end_field(options);
  const Rect rect = item_rect();
  bool changed = false;
  if (open) {
    changed = draw_choices(ui, label, chosen, names);
    ImGui::EndCombo();
    note_rect(ui, "combo", label, shown, rect, options);
  } else {
    WidgetOptions whole = options;
    if (cut != shown) whole.help = shown;
    note_item(ui, "combo", label, shown, whole);
  }
  return changed;
}

namespace {

// The number stands beside the slider, where the grab does not cover it. `widest` is the longest that may stand there;
// `draw` draws the slider itself and `words` gives the number after that.
template <typename Draw, typename Words>
bool slider_with_number(Ui& ui, std::string_view label, const std::string& widest, Draw draw, Words words,
                        const WidgetOptions& options) {
  const float room = options.width > 0.0F ? options.width : ImGui::GetContentRegionAvail().x;
  const float number = std::ceil(ImGui::CalcTextSize(widest.c_str()).x) + ui.px(8);
  const float width = std::max(room - number, ui.px(36));
  const bool typing = ImGui::TempInputIsActive(ImGui::GetID(hidden_id(label).c_str()));
  WidgetOptions placed = options;
  placed.width = width;
  begin_field(ui, placed);
  if (!typing) ImGui::PushStyleColor(ImGuiCol_Text, ImVec4(0.0F, 0.0F, 0.0F, 0.0F));
  const bool changed = draw();
  if (!typing) ImGui::PopStyleColor();
  end_field(placed);
  const std::string shown = words();
  note_item(ui, "slider", label, shown, placed);
  ImGui::SameLine(0.0F, ui.px(8));
  const ColourScope colour(ImGuiCol_Text, options.reason.empty() ? ui.theme().text : ui.theme().text_disabled);
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(shown.c_str());
  ui.items().note_end(item_rect().x1);
  return changed;
}

}  // namespace

bool slider_int(Ui& ui, std::string_view label, int& value, int low, int high, const char* format,
                const WidgetOptions& options) {
  const auto words = [format](int number) { return fmt::sprintf(format, number); };
  return slider_with_number(
      ui, label, std::max(words(low), words(high), [](const auto& a, const auto& b) { return a.size() < b.size(); }),
      [&] { return ImGui::SliderInt(hidden_id(label).c_str(), &value, low, high, "%d", ImGuiSliderFlags_AlwaysClamp); },
      [&] { return words(value); }, options);
}

bool slider_float(Ui& ui, std::string_view label, float& value, float low, float high, const char* format,
                  const WidgetOptions& options) {
  const auto words = [format](float number) { return fmt::sprintf(format, number); };
  return slider_with_number(
      ui, label, std::max(words(low), words(high), [](const auto& a, const auto& b) { return a.size() < b.size(); }),
      [&] {
        return ImGui::SliderFloat(hidden_id(label).c_str(), &value, low, high, format, ImGuiSliderFlags_AlwaysClamp);
      },
      [&] { return words(value); }, options);
}

bool number_field(Ui& ui, std::string_view label, std::int64_t& value, std::int64_t low, std::int64_t high,
                  const WidgetOptions& options) {
  begin_field(ui, options);
  if (ui.focus().take_typing(ui.items().path_of(label))) ImGui::SetKeyboardFocusHere();
  const ImGuiID id = ImGui::GetID(hidden_id(label).c_str());
  ImGui::InputScalar(hidden_id(label).c_str(), ImGuiDataType_S64, &value);
  const bool finished = ImGui::IsItemDeactivatedAfterEdit();
  end_field(options);
  if (finished || ImGui::GetActiveID() != id) value = std::clamp(value, low, high);
  note_item(ui, "field", label, std::to_string(value), options);
  return finished;
}

bool text_field(Ui& ui, std::string_view label, std::string& words, std::string_view hint,
                const WidgetOptions& options) {
  begin_field(ui, options);
  if (ui.focus().take_typing(ui.items().path_of(label))) ImGui::SetKeyboardFocusHere();
  ImGui::PushStyleColor(ImGuiCol_TextDisabled, to_vec4(ui.theme().text_dim));
  ImGui::InputTextWithHint(hidden_id(label).c_str(), std::string(hint).c_str(), &words);
  ImGui::PopStyleColor();
  const bool finished = ImGui::IsItemDeactivatedAfterEdit();
  end_field(options);
  note_item(ui, "field", label, words, options);
  return finished;
}

}  // namespace trocar::ui
