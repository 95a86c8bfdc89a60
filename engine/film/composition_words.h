/// The words for what a film can be made of: the same on the command line and in a job's file.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "engine/film/composition.h"

namespace trocar::film {

template <typename Value>
struct Word {
  Value value;
  std::string_view text;
};

inline constexpr std::array<Word<Layout>, 6> kLayouts{{{Layout::kSingle, "single"},
                                                       {Layout::kSideBySide, "side-by-side"},
                                                       {Layout::kTopBottom, "top-bottom"},
                                                       {Layout::kTwoByTwo, "2x2"},
                                                       {Layout::kThreeByThree, "3x3"},
                                                       {Layout::kPictureInPicture, "picture-in-picture"}}};
inline constexpr std::array<Word<Corner>, 4> kCorners{{{Corner::kTopLeft, "top-left"},
                                                       {Corner::kTopRight, "top-right"},
                                                       {Corner::kBottomLeft, "bottom-left"},
                                                       {Corner::kBottomRight, "bottom-right"}}};
inline constexpr std::array<Word<Sync>, 3> kSyncs{
    {{Sync::kClock, "clock"}, {Sync::kSegment, "segment"}, {Sync::kGrasp, "grasp"}}};
inline constexpr std::array<Word<Quality>, 2> kQualities{{{Quality::kFast, "fast"}, {Quality::kFine, "fine"}}};
inline constexpr std::array<Word<Ease>, 4> kEases{
    {{Ease::kLinear, "linear"}, {Ease::kSmooth, "smooth"}, {Ease::kHold, "hold"}, {Ease::kSpline, "spline"}}};
inline constexpr std::array<Word<SourceKind>, 4> kSourceKinds{{{SourceKind::kRecording, "recording"},
                                                               {SourceKind::kField, "field"},
                                                               {SourceKind::kCurve, "curve"},
                                                               {SourceKind::kRollout, "rollout"}}};
inline constexpr std::array<Word<View>, 8> kViews{{{View::kPaper, "paper"},
                                                   {View::kTop, "top"},
                                                   {View::kSide, "side"},
                                                   {View::kFront, "front"},
                                                   {View::kOrbit, "orbit"},
                                                   {View::kTurntable, "turntable"},
                                                   {View::kPoses, "poses"},
                                                   {View::kFollow, "follow"}}};
inline constexpr std::array<Word<Overlay>, kOverlayCount> kOverlays{{{Overlay::kTitle, "title"},
                                                                     {Overlay::kTimer, "timer"},
                                                                     {Overlay::kSegment, "segment"},
                                                                     {Overlay::kAuthority, "authority"},
                                                                     {Overlay::kPedals, "pedals"},
                                                                     {Overlay::kJaws, "jaws"},
                                                                     {Overlay::kMetrics, "metrics"},
                                                                     {Overlay::kTally, "tally"},
                                                                     {Overlay::kColourBar, "colour-bar"},
                                                                     {Overlay::kScaleBar, "scale-bar"},
                                                                     {Overlay::kTrail, "trail"},
                                                                     {Overlay::kGhost, "ghost"},
                                                                     {Overlay::kCaptions, "captions"},
                                                                     {Overlay::kProvenance, "provenance"},
                                                                     {Overlay::kSpeed, "speed"}}};

template <typename Value, std::size_t kCount>
std::string_view word_of(const std::array<Word<Value>, kCount>& words, Value value) {
  for (const Word<Value>& word : words) {
    if (word.value == value) return word.text;
  }
  return "";
}

template <typename Value, std::size_t kCount>
std::optional<Value> value_of(const std::array<Word<Value>, kCount>& words, std::string_view text) {
  for (const Word<Value>& word : words) {
    if (word.text == text) return word.value;
  }
  return std::nullopt;
}

/// "clock, segment, grasp".
template <typename Value, std::size_t kCount>
std::string list_of(const std::array<Word<Value>, kCount>& words) {
  std::string list;
  for (const Word<Value>& word : words) list += (list.empty() ? "" : ", ") + std::string(word.text);
  return list;
}

}  // namespace trocar::film
