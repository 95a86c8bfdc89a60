#include "ui/keymap.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "ui/command_table.h"
#include "ui/widgets/ui.h"

namespace trocar::ui {
namespace {

using Json = nlohmann::json;

std::vector<Chord> chords_of(std::span<const std::string_view> texts) {
  std::vector<Chord> chords;
  for (const std::string_view text : texts) {
    if (const Result<Chord> chord = chord_from(text)) chords.push_back(*chord);
  }
  return chords;
}

const CommandRow* row_of(std::string_view id) {
  const auto& table = command_table();
  const auto found = std::find_if(table.begin(), table.end(), [id](const CommandRow& row) { return row.id == id; });
  return found == table.end() ? nullptr : &*found;
}

const PresetRow* preset_row(KeyPreset preset, std::string_view id) {
  const auto rows = rows_of(preset);
  const auto found = std::find_if(rows.begin(), rows.end(), [id](const PresetRow& row) { return row.id == id; });
  return found == rows.end() ? nullptr : &*found;
}

/// What the preset and the table say, whatever else may claim it.
std::vector<Chord> given_chords(KeyPreset preset, const CommandRow& row) {
  const PresetRow* of_preset = preset_row(preset, row.id);
  if (of_preset == nullptr) return chords_of(row.keys);
  std::vector<std::string_view> texts;
  std::copy_if(of_preset->keys.begin(), of_preset->keys.end(), std::back_inserter(texts),
               [](std::string_view text) { return !text.empty(); });
  return chords_of(texts);
}

bool contains(std::span<const Chord> chords, const Chord& chord) {
  return std::find(chords.begin(), chords.end(), chord) != chords.end();
}

std::string no_command(std::string_view id) {
  return fmt::format("the settings give keys to \"{}\", which is no command; they were left out", id);
}

}  // namespace

Keymap::Keymap(const KeyChoices& choices) {
  struct Taken {
    std::string_view context;
    Chord chord;
    const CommandRow* by;
  };
  std::vector<Taken> taken;
  const auto claim = [&](const CommandRow& row, const std::vector<Chord>& chords, bool changed) {
    Entry& entry = entries_[row.id];
    entry.changed = changed;
    for (const Chord& chord : chords) {
      const auto other = std::find_if(taken.begin(), taken.end(), [&](const Taken& one) {
        return one.context == row.context && one.chord == chord;
      });
      if (other == taken.end()) {
        taken.push_back({row.context, chord, &row});
        entry.chords.push_back(chord);
      } else if (changed && other->by != &row) {
        refused_.push_back(fmt::format("{} is to be \"{}\" and \"{}\" at once; it stays \"{}\"", to_text(chord),
                                       other->by->title, row.title, other->by->title));
      }
    }
    if (!entry.chords.empty()) entry.shown = to_text(entry.chords.front());
  };
  enum class Layer { kChanged, kPreset, kTable };
  for (const Layer layer : {Layer::kChanged, Layer::kPreset, Layer::kTable}) {
    for (const CommandRow& row : command_table()) {
      const auto change = choices.changed.find(row.id);
      const bool changed = change != choices.changed.end();
      const bool preset = !changed && preset_row(choices.preset, row.id) != nullptr;
      const Layer own = changed ? Layer::kChanged : preset ? Layer::kPreset : Layer::kTable;
      if (own == layer) claim(row, changed ? change->second : given_chords(choices.preset, row), changed);
    }
  }
}

const Keymap::Entry* Keymap::find(std::string_view id) const {
  const auto found = entries_.find(id);
  return found == entries_.end() ? nullptr : &found->second;
}

std::span<const Chord> Keymap::chords(std::string_view id) const {
  const Entry* entry = find(id);
  return entry == nullptr ? std::span<const Chord>() : std::span<const Chord>(entry->chords);
}

std::string_view Keymap::shown(std::string_view id) const {
  const Entry* entry = find(id);
  return entry == nullptr ? std::string_view() : std::string_view(entry->shown);
}

std::string Keymap::all(std::string_view id) const {
  std::string words;
  for (const Chord& chord : chords(id)) words += (words.empty() ? "" : ", ") + to_text(chord);
  return words;
}

bool Keymap::changed(std::string_view id) const {
  const Entry* entry = find(id);
  return entry != nullptr && entry->changed;
}

std::vector<KeyClash> Keymap::clashes(std::string_view id, const Chord& chord) const {
  std::vector<KeyClash> found;
  const CommandRow* own = row_of(id);
  if (own == nullptr) return found;
  for (const CommandRow& row : command_table()) {
    if (row.id == id || !contains(chords(row.id), chord)) continue;
    const bool same = row.context == own->context;
    if (same || row.context.empty() || own->context.empty()) found.push_back({row.id, row.context, !same});
  }
  return found;
}

std::string cannot_bind(const Chord& chord) {
  if (chord.key == Key::kTab) return "Tab goes from one control to the next";
  if (chord.key == Key::kEscape && chord.modifiers == Modifiers{}) return "Escape leaves what was begun";
  const Result<Chord> read = chord_from(to_text(chord));
  return read && *read == chord ? "" : "This key has no name that could be kept";
}

KeyChoices with_chords(KeyChoices choices, std::string_view id, std::vector<Chord> chords) {
  const CommandRow* row = row_of(id);
  if (row == nullptr) return choices;
  if (chords == given_chords(choices.preset, *row)) return with_reset(std::move(choices), id);
  choices.changed.insert_or_assign(std::string(id), std::move(chords));
  return choices;
}

KeyChoices with_reset(KeyChoices choices, std::string_view id) {
  const auto found = choices.changed.find(id);
  if (found != choices.changed.end()) choices.changed.erase(found);
  return choices;
}

std::string to_json(const KeyChoices& choices) {
  Json changed = Json::object();
  for (const auto& [id, chords] : choices.changed) {
    Json texts = Json::array();
    for (const Chord& chord : chords) texts.push_back(to_text(chord));
    changed[id] = std::move(texts);
  }
  return Json{{"preset", std::string(name_of(choices.preset))}, {"changed", std::move(changed)}}.dump();
}

namespace {

std::vector<Chord> read_chords(const std::string& id, const Json& texts, Diagnostics& diagnostics) {
  std::vector<Chord> chords;
  for (const Json& text : texts) {
    const Result<Chord> chord = text.is_string()
                                    ? chord_from(text.get<std::string>())
                                    : Result<Chord>(fail(ErrorCode::kInvalidArgument, "a chord is written as text"));
    const std::string why = chord ? cannot_bind(*chord) : chord.error().text();
    if (why.empty()) {
      if (!contains(chords, *chord)) chords.push_back(*chord);
    } else {
      diagnostics.warn(fmt::format("the settings give \"{}\" a key that was left out: {}", id, why));
    }
  }
  return chords;
}

void drop_refused(KeyChoices& choices, Diagnostics& diagnostics) {
  const Keymap keymap(choices);
  for (const std::string& sentence : keymap.refused()) diagnostics.warn("in the settings " + sentence);
  // A command that keeps none of what it was to have keeps its own.
  for (auto change = choices.changed.begin(); change != choices.changed.end();) {
    const auto kept = keymap.chords(change->first);
    const bool lost = kept.empty() && !change->second.empty();
    if (!lost) change->second.assign(kept.begin(), kept.end());
    change = lost ? choices.changed.erase(change) : std::next(change);
  }
}

}  // namespace

KeyChoices key_choices_from_json(std::string_view text, Diagnostics& diagnostics) {
  KeyChoices choices;
  const Json json = Json::parse(text, nullptr, false);
  if (!json.is_object()) {
    diagnostics.warn("the keys in the settings cannot be read; those of the program hold");
    return choices;
  }
  if (json.contains("preset")) {
    const std::string name = json["preset"].is_string() ? json["preset"].get<std::string>() : json["preset"].dump();
    const std::optional<KeyPreset> preset = key_preset_from(name);
    if (!preset) diagnostics.warn(fmt::format("the settings name the keys \"{}\", which do not exist", name));
    choices.preset = preset.value_or(KeyPreset::kDefault);
  }
  if (!json.contains("changed") || !json["changed"].is_object()) return choices;
  for (const auto& [id, texts] : json["changed"].items()) {
    if (row_of(id) == nullptr) {
      diagnostics.warn(no_command(id));
    } else if (!texts.is_array()) {
      diagnostics.warn(fmt::format("the settings give \"{}\" no list of keys; it keeps its own", id));
    } else {
      // Had it keys and none of them can be read, its own are better than none.
      std::vector<Chord> chords = read_chords(id, texts, diagnostics);
      if (!chords.empty() || texts.empty()) choices.changed.insert_or_assign(id, std::move(chords));
    }
  }
  drop_refused(choices, diagnostics);
  return choices;
}

std::string_view shown_keys(const Ui& ui, std::string_view id) {
  return ui.keymap().shown(id);
}

}  // namespace trocar::ui
