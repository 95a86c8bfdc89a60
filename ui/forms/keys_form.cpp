#include "ui/forms/keys_form.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "ui/command_table.h"
#include "ui/format.h"
#include "ui/icons.h"

namespace trocar::ui {
namespace {

/// "“Redo”, while a tool is in hand “Nudge +x”": what else a chord means.
std::string meanings(const std::vector<KeyClash>& clashes) {
  std::string words;
  for (const KeyClash& clash : clashes) {
    if (!words.empty()) words += ", ";
    if (!clash.context.empty()) words += fmt::format("with a {} ", clash.context);
    words += fmt::format("“{}”", command(clash.command).title);
  }
  return words;
}

std::vector<Chord> list_of(const Ui& ui, std::string_view id) {
  const auto chords = ui.keymap().chords(id);
  return {chords.begin(), chords.end()};
}

}  // namespace

void KeysForm::prepare(const WorkbenchState&) {
  find_.clear();
  capture_.clear();
  refusal_.clear();
  clash_.reset();
}

bool KeysForm::matches(Ui& ui, const CommandRow& row) const {
  const std::string all = lower_case(fmt::format("{} {} {} {}", row.title, row.menu, row.id, ui.keymap().all(row.id)));
  return all.find(lower_case(find_)) != std::string::npos;
}

void KeysForm::give(Ui& ui, const std::string& id, const Chord& chord, bool take_from_others, Requests& requests) {
  KeyChoices keys = settings_.keys;
  if (take_from_others) {
    for (const KeyClash& clash : ui.keymap().clashes(id, chord)) {
      std::vector<Chord> theirs = list_of(ui, clash.command);
      std::erase(theirs, chord);
      keys = with_chords(std::move(keys), clash.command, std::move(theirs));
    }
  }
  std::vector<Chord> own = list_of(ui, id);
  own.push_back(chord);
  requests.emplace_back(ChooseKeys{with_chords(std::move(keys), id, std::move(own))});
}

void KeysForm::take(Ui& ui, Requests& requests) {
  const Key key = ui.input().pressed_key();
  if (key == Key::kNone) return;
  const Chord chord{key, ui.input().modifiers()};
  const std::string id = std::exchange(capture_, {});
  if (chord == Chord{Key::kEscape, {}}) return;
  refusal_ = cannot_bind(chord);
  if (!refusal_.empty()) return;
  const std::vector<Chord> own = list_of(ui, id);
  if (std::find(own.begin(), own.end(), chord) != own.end()) return;
  if (ui.keymap().clashes(id, chord).empty()) return give(ui, id, chord, false, requests);
  clash_ = Clash{id, chord};
}

void KeysForm::draw_clash(Ui& ui, Requests& requests) {
  const Scope scope(ui, "Conflict");
  const Clash clash = *clash_;
  const std::vector<KeyClash> others = ui.keymap().clashes(clash.id, clash.chord);
  const bool both = std::all_of(others.begin(), others.end(), [](const KeyClash& other) { return other.both; });
  wrapped_text(ui, fmt::format("{} means {} already", to_text(clash.chord), meanings(others)), ui.theme().warning);
  const WidgetOptions take{.help = "The other command loses these keys", .style = ButtonStyle::kPrimary};
  bool done = others.empty();
  if (button(ui, "Take it from there", take)) {
    give(ui, clash.id, clash.chord, true, requests);
    done = true;
  }
  if (both) {
    flow(button_width(ui, "Use it for both", nullptr), ui.px(6));
    if (button(ui, "Use it for both", {.help = "With a tool in hand it means that of the tool, else the other"})) {
      give(ui, clash.id, clash.chord, false, requests);
      done = true;
    }
  }
  flow(button_width(ui, "Leave it there", nullptr), ui.px(6));
  const bool left = button(ui, "Leave it there", {.help = "Change nothing", .shortcut = "Esc"});
  if (done || left || ui.input().pressed(Key::kEscape)) clash_.reset();
}

void KeysForm::draw_banner(Ui& ui, Requests& requests) {
  if (clash_) return draw_clash(ui, requests);
  if (!capture_.empty()) {
    const std::string words = fmt::format("Press the keys for “{}”; Esc leaves it as it is", command(capture_).title);
    wrapped_text(ui, words, ui.theme().text);
    return take(ui, requests);
  }
  if (!refusal_.empty()) return wrapped_text(ui, refusal_, ui.theme().warning);
  wrapped_text(ui, "Click keys to take them away; + waits for others to be pressed", ui.theme().text_dim);
}

void KeysForm::draw_head(Ui& ui, Requests& requests) {
  std::vector<std::string> names;
  for (const KeyPreset preset : kKeyPresets) names.emplace_back(title_of(preset));
  int chosen = static_cast<int>(settings_.keys.preset);
  form_label(ui, "Preset");
  if (segmented(ui, "Preset", chosen, names, {.help = "Keys as in another program; what was changed stays changed"})) {
    KeyChoices keys = settings_.keys;
    keys.preset = static_cast<KeyPreset>(chosen);
    requests.emplace_back(ChooseKeys{std::move(keys)});
  }
  form_label(ui, "Find");
  text_field(ui, "Find", find_, "A command or its keys");
  const std::string reason = settings_.keys.changed.empty() ? "Nothing was changed" : "";
  if (button(ui, "Reset all", {.icon = icon::kUndo, .help = "All keys as the preset has them", .reason = reason})) {
    requests.emplace_back(ChooseKeys{{settings_.keys.preset, {}}});
  }
}

void KeysForm::draw_row(Ui& ui, const CommandRow& row, Requests& requests) {
  const Scope scope(ui, row.id);
  const Keymap& keymap = ui.keymap();
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::AlignTextToFramePadding();
  ImGui::PushTextWrapPos(0.0F);
  ImGui::TextUnformatted(row.title.data(), row.title.data() + row.title.size());
  ImGui::PopTextWrapPos();
  note_item(ui, "text", row.title, keymap.all(row.id), {.help = row.help});
  ImGui::TableNextColumn();
  bool first = true;
  const auto beside = [&](float width) {
    if (!std::exchange(first, false)) flow(width, ui.px(4));
  };
  for (const Chord& chord : list_of(ui, row.id)) {
    const std::string words = to_text(chord);
    const std::vector<KeyClash> also = keymap.clashes(row.id, chord);
    const std::string help = also.empty() ? "Take it away" : "Take it away; it also means " + meanings(also);
    const float width = std::max(button_width(ui, words, nullptr), ui.px(28));
    beside(width);
    if (!button(ui, words, {.help = help, .width = width})) continue;
    std::vector<Chord> left = list_of(ui, row.id);
    std::erase(left, chord);
    requests.emplace_back(ChooseKeys{with_chords(settings_.keys, row.id, std::move(left))});
  }
  beside(ImGui::GetFrameHeight() + ui.px(4));
  if (icon_button(ui, "Add keys", {.icon = icon::kPlus, .help = "Then press them", .style = ButtonStyle::kQuiet})) {
    capture_ = row.id;
    refusal_.clear();
    clash_.reset();
  }
  if (!keymap.changed(row.id)) return;
  beside(ImGui::GetFrameHeight() + ui.px(4));
  if (icon_button(ui, "Reset", {.icon = icon::kUndo, .help = "As the preset has it", .style = ButtonStyle::kQuiet})) {
    requests.emplace_back(ChooseKeys{with_reset(settings_.keys, row.id)});
  }
}

void KeysForm::draw_menu(Ui& ui, std::string_view menu, Requests& requests) {
  const auto& table = command_table();
  const auto shown = [&](const CommandRow& row) { return row.menu == menu && matches(ui, row); };
  if (std::none_of(table.begin(), table.end(), shown)) return;
  heading(ui, menu);
  constexpr ImGuiTableFlags kFlags = ImGuiTableFlags_SizingStretchProp | ImGuiTableFlags_NoPadOuterX;
  if (!ImGui::BeginTable(std::string(menu).c_str(), 2, kFlags)) return;
  ImGui::TableSetupColumn("Command", ImGuiTableColumnFlags_WidthStretch, 1.0F);
  ImGui::TableSetupColumn("Keys", ImGuiTableColumnFlags_WidthStretch, 1.2F);
  for (const CommandRow& row : table) {
    if (shown(row)) draw_row(ui, row, requests);
  }
  ImGui::EndTable();
  ImGui::Dummy({0.0F, ui.px(4)});
}

Requests KeysForm::draw_content(Ui& ui, const WorkbenchState&) {
  Requests requests;
  draw_head(ui, requests);
  draw_banner(ui, requests);
  // In a low window all of it scrolls together.
  const bool apart = ImGui::GetContentRegionAvail().y >= ui.px(200);
  if (apart) ImGui::BeginChild("commands");
  for (const std::string_view menu : command_menus()) draw_menu(ui, menu, requests);
  if (apart) ImGui::EndChild();
  return requests;
}

}  // namespace trocar::ui
