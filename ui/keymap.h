/// Which chords mean which command now: those of the command table, of a preset, and what the user changed of them.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/diagnostics.h"
#include "ui/key_presets.h"
#include "ui/shortcut.h"

namespace trocar::ui {

class Ui;

/// What is kept between runs.
struct KeyChoices {
  KeyPreset preset = KeyPreset::kDefault;
  /// By the command's id: all of its chords from now on; none is a choice as well.
  std::map<std::string, std::vector<Chord>, std::less<>> changed;
  bool operator==(const KeyChoices&) const = default;
};

/// What a chord means beside the command that it was meant for.
struct KeyClash {
  std::string_view command;  ///< The id of the other command.
  std::string_view context;  ///< Where the other means it; "": everywhere.
  bool both = false;         ///< The two can share it, because one of them holds only in a context, and there wins.
};

/// A chord means at most one command in each context. Where two claim it, a change of the user's wins over the preset,
/// the preset over the table, and of equals the one that comes first in the table.
class Keymap {
 public:
  Keymap() : Keymap(KeyChoices{}) {}
  /// Changes to commands that do not exist do not count.
  explicit Keymap(const KeyChoices& choices);

  /// Empty for a command that does not exist.
  std::span<const Chord> chords(std::string_view id) const;
  /// The first chord, as in menus and tooltips: "Ctrl+P"; "" for none.
  std::string_view shown(std::string_view id) const;
  /// "Ctrl+P, Ctrl+K"
  std::string all(std::string_view id) const;
  /// Has other chords than the preset gives it.
  bool changed(std::string_view id) const;
  /// What else `chord` would mean if `id` had it: in the same context, or in one that holds at the same time.
  std::vector<KeyClash> clashes(std::string_view id, const Chord& chord) const;
  /// Of the changes, those chords that another change has as well, as sentences.
  const std::vector<std::string>& refused() const { return refused_; }

 private:
  struct Entry {
    std::vector<Chord> chords;
    std::string shown;
    bool changed = false;
  };
  const Entry* find(std::string_view id) const;

  std::map<std::string_view, Entry> entries_;
  std::vector<std::string> refused_;
};

/// Why a chord cannot be given to any command; "" if it can.
std::string cannot_bind(const Chord& chord);
/// `choices` with `id` having exactly these chords; those that it has anyway are no change.
KeyChoices with_chords(KeyChoices choices, std::string_view id, std::vector<Chord> chords);
KeyChoices with_reset(KeyChoices choices, std::string_view id);

std::string to_json(const KeyChoices& choices);
/// What is odd is left out, each with a warning: a preset or command that does not exist, what is no chord, a chord of
/// two changes. Never fails: `text` is JSON or all of it is odd.
KeyChoices key_choices_from_json(std::string_view text, Diagnostics& diagnostics);

/// The first chord that means the command now: what every menu, tooltip and hint shows.
std::string_view shown_keys(const Ui& ui, std::string_view id);

}  // namespace trocar::ui
