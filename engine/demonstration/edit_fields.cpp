#include "engine/demonstration/edit_fields.h"

#include <array>

namespace trocar::demonstration {

using Word = std::string_view;

template <>
std::span<const Word> words_of<Segment>() {
  static constexpr std::array<Word, kSegmentCount> kWords{"A", "B", "C", "D", "E"};
  return kWords;
}

template <>
std::span<const Word> words_of<Arms>() {
  static constexpr std::array<Word, 3> kWords{"left", "right", "both"};
  return kWords;
}

template <>
std::span<const Word> words_of<Align>() {
  static constexpr std::array<Word, 3> kWords{"as-recorded", "meet", "peg"};
  return kWords;
}

template <>
std::span<const Word> words_of<BridgeShape>() {
  static constexpr std::array<Word, 4> kWords{"straight", "minimum-jerk", "policy", "over"};
  return kWords;
}

template <>
std::span<const Word> words_of<Falloff>() {
  static constexpr std::array<Word, 4> kWords{"smooth", "sphere", "linear", "sharp"};
  return kWords;
}

template <>
std::span<const Word> words_of<TurnFrame>() {
  static constexpr std::array<Word, 2> kWords{"tool", "board"};
  return kWords;
}

template <>
std::span<const Word> words_of<Filter>() {
  static constexpr std::array<Word, 3> kWords{"savitzky-golay", "gaussian", "low-pass"};
  return kWords;
}

template <>
std::span<const Word> words_of<RetimeTo>() {
  static constexpr std::array<Word, 5> kWords{"scale", "duration", "speed-cap", "constant-speed", "warp"};
  return kWords;
}

template <>
std::span<const Word> words_of<ResampleBy>() {
  static constexpr std::array<Word, 3> kWords{"linear", "cubic", "nearest"};
  return kWords;
}

template <>
std::span<const Word> words_of<RevertWhat>() {
  static constexpr std::array<Word, 4> kWords{"samples", "pose", "jaw", "labels"};
  return kWords;
}

template <>
std::span<const Word> words_of<NoteColour>() {
  static constexpr std::array<Word, 7> kWords{"plain", "red", "orange", "yellow", "green", "blue", "purple"};
  return kWords;
}

template <>
std::span<const Word> words_of<NoteGlyph>() {
  static constexpr std::array<Word, 6> kWords{"flag", "star", "tick", "cross", "question", "warning"};
  return kWords;
}

}  // namespace trocar::demonstration
