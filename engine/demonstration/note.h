/// A word about an instant or a span of a demonstration, and how it is marked.
#pragma once

#include <cstdint>
#include <string>

namespace trocar::demonstration {

enum class NoteColour : std::uint8_t { kPlain, kRed, kOrange, kYellow, kGreen, kBlue, kPurple };
enum class NoteGlyph : std::uint8_t { kFlag, kStar, kTick, kCross, kQuestion, kWarning };

/// About an instant (`begin_s == end_s`) or a span.
struct Note {
  std::int64_t id = 0;  ///< Of the edit that added it.
  double begin_s = 0.0;
  double end_s = 0.0;
  std::string text;
  std::string tag;
  int rating = 0;  ///< 0: none, else 1 … 5.
  NoteColour colour = NoteColour::kPlain;
  NoteGlyph glyph = NoteGlyph::kFlag;
};

}  // namespace trocar::demonstration
