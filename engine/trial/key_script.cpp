#include "engine/trial/key_script.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <string>

namespace trocar::trial {
namespace {

constexpr double kLongest_s = 3600.0;

Error at_line(int line, const std::string& why) {
  return Error(ErrorCode::kInvalidArgument, fmt::format("line {}: {}", line, why));
}

std::vector<std::string_view> words_of(std::string_view line) {
  line = line.substr(0, line.find('#'));
  std::vector<std::string_view> words;
  std::size_t begin = 0;
  while ((begin = line.find_first_not_of(" \t\r", begin)) != std::string_view::npos) {
    const std::size_t end = std::min(line.find_first_of(" \t\r", begin), line.size());
    words.push_back(line.substr(begin, end - begin));
    begin = end;
  }
  return words;
}

Result<Tick> tick_from(std::string_view word) {
  double seconds = 0.0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), seconds);
  if (error != std::errc() || end != word.data() + word.size() || !(seconds >= 0.0) || seconds > kLongest_s) {
    return fail(ErrorCode::kInvalidArgument, fmt::format("\"{}\" is no time from 0 to 3600 s", word));
  }
  return tick_at(seconds);
}

/// "Shift+D": the key, and whether Shift is held with it.
struct Chord {
  HandKey key = 0;
  bool shift = false;
};

Result<Chord> chord_from(std::string_view word) {
  Chord chord;
  if (const std::size_t plus = word.find('+'); plus != std::string_view::npos) {
    TROCAR_ASSIGN_OR_RETURN(const HandKey modifier, hand_key_from(word.substr(0, plus)));
    if (modifier != kShiftKey) return fail(ErrorCode::kInvalidArgument, "only Shift is held with another key");
    chord.shift = true;
    word.remove_prefix(plus + 1);
  }
  TROCAR_ASSIGN_OR_RETURN(chord.key, hand_key_from(word));
  return chord;
}

void add_keys(std::vector<KeyStroke>& strokes, const Chord& chord, Tick from, std::optional<Tick> until) {
  if (chord.shift) strokes.push_back({from, KeyAct::kDown, kShiftKey, {}});
  strokes.push_back({from, KeyAct::kDown, chord.key, {}});
  if (!until) return;
  strokes.push_back({*until, KeyAct::kUp, chord.key, {}});
  if (chord.shift) strokes.push_back({*until, KeyAct::kUp, kShiftKey, {}});
}

/// The line's acts, `words` being time, verb and the rest.
Status add_line(std::vector<KeyStroke>& strokes, const std::vector<std::string_view>& words, Tick at) {
  const std::string_view verb = words[1];
  const std::size_t wanted = verb == "end" ? 2 : verb == "hold" ? 4 : 3;
  if (verb != "end" && verb != "hold" && verb != "down" && verb != "up" && verb != "tap" && verb != "pause") {
    return fail(ErrorCode::kInvalidArgument, fmt::format("\"{}\" is none of down, up, tap, hold, pause and end", verb));
  }
  if (words.size() != wanted) {
    return fail(ErrorCode::kInvalidArgument, fmt::format("\"{}\" takes {} after it", verb,
                                                         wanted == 2   ? "nothing"
                                                         : wanted == 3 ? "one word"
                                                                       : "two words"));
  }
  if (verb == "end") {
    strokes.push_back({at, KeyAct::kEnd, 0, {}});
    return {};
  }
  if (verb == "pause") {
    TROCAR_ASSIGN_OR_RETURN(const Tick duration, tick_from(words[2]));
    strokes.push_back({at, KeyAct::kPause, 0, duration});
    return {};
  }
  TROCAR_ASSIGN_OR_RETURN(const Chord chord, chord_from(words[2]));
  if (verb == "hold") {
    TROCAR_ASSIGN_OR_RETURN(const Tick duration, tick_from(words[3]));
    add_keys(strokes, chord, at, Tick{at.count + duration.count});
  } else if (verb == "tap") {
    add_keys(strokes, chord, at, at);
  } else {
    if (chord.shift) return fail(ErrorCode::kInvalidArgument, "Shift goes down and up in lines of its own here");
    strokes.push_back({at, verb == "down" ? KeyAct::kDown : KeyAct::kUp, chord.key, {}});
  }
  return {};
}

}  // namespace

Result<std::vector<KeyStroke>> parse_key_script(std::string_view text) {
  std::vector<KeyStroke> strokes;
  Tick last;
  bool ended = false;
  int line = 0;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::vector<std::string_view> words = words_of(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    ++line;
    if (words.empty()) continue;
    if (ended) return tl::unexpected(at_line(line, "nothing follows the end"));
    if (words.size() < 2) return tl::unexpected(at_line(line, "a line is a time, an act and its key"));
    const Result<Tick> at = tick_from(words[0]);
    if (!at) return tl::unexpected(at_line(line, at.error().text()));
    if (*at < last) return tl::unexpected(at_line(line, "it is earlier than the line above"));
    last = *at;
    if (const Status added = add_line(strokes, words, *at); !added) {
      return tl::unexpected(at_line(line, added.error().text()));
    }
    ended = strokes.back().act == KeyAct::kEnd;
  }
  if (strokes.empty()) return fail(ErrorCode::kInvalidArgument, "the script presses no key and does not end");
  std::stable_sort(strokes.begin(), strokes.end(), [](const KeyStroke& a, const KeyStroke& b) { return a.at < b.at; });
  if (!ended) {
    strokes.push_back({Tick{strokes.back().at.count + Tick::kPerSecond}, KeyAct::kEnd, 0, {}});
  }
  // What is still held then does not matter.
  const auto end =
      std::find_if(strokes.begin(), strokes.end(), [](const KeyStroke& s) { return s.act == KeyAct::kEnd; });
  strokes.erase(end + 1, strokes.end());
  return strokes;
}

}  // namespace trocar::trial
