#include "engine/canvas/fonts.h"

#include <cairo-ft.h>
#include <fontconfig/fontconfig.h>

#include <array>
#include <cstdint>
#include <memory>

namespace trocar::canvas {
namespace {

struct Face {
  cairo_font_face_t* cairo = nullptr;
  FcCharSet* characters = nullptr;  ///< Null: not known, takes everything.

  bool has(std::uint32_t code) const {
    return characters == nullptr || FcCharSetHasChar(characters, code) != 0 || code < 0x20;
  }
};

/// The best match that fontconfig has; some face always results, as Cairo substitutes its own.
Face load_face(const char* family, int weight) {
  const std::unique_ptr<FcPattern, decltype(&FcPatternDestroy)> wanted(
      FcPatternBuild(nullptr, FC_FAMILY, FcTypeString, family, FC_WEIGHT, FcTypeInteger, weight, FC_SLANT,
                     FcTypeInteger, FC_SLANT_ROMAN, FC_WIDTH, FcTypeInteger, FC_WIDTH_NORMAL, nullptr),
      &FcPatternDestroy);
  FcConfigSubstitute(nullptr, wanted.get(), FcMatchPattern);
  FcDefaultSubstitute(wanted.get());
  FcResult result = FcResultMatch;
  const std::unique_ptr<FcPattern, decltype(&FcPatternDestroy)> match(FcFontMatch(nullptr, wanted.get(), &result),
                                                                      &FcPatternDestroy);
  Face face;
  if (!match) {
    face.cairo = cairo_toy_font_face_create("sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
    return face;
  }
  FcCharSet* characters = nullptr;
  if (FcPatternGetCharSet(match.get(), FC_CHARSET, 0, &characters) == FcResultMatch) {
    face.characters = FcCharSetCopy(characters);
  }
  face.cairo = cairo_ft_font_face_create_for_pattern(match.get());
  return face;
}

struct Faces {
  std::array<std::array<Face, 2>, 3> by_weight;  ///< Inter, DejaVu Sans.

  Faces() {
    constexpr std::array kWeights{FC_WEIGHT_REGULAR, FC_WEIGHT_DEMIBOLD, FC_WEIGHT_BOLD};
    for (std::size_t i = 0; i < by_weight.size(); ++i) {
      by_weight[i] = {load_face("Inter", kWeights[i]), load_face("DejaVu Sans", i == 0 ? kWeights[0] : kWeights[2])};
    }
  }
};

/// Never freed: other threads may still draw while statics are destroyed.
const Faces& faces() {
  static const Faces* const loaded = new Faces();
  return *loaded;
}

/// Takes one character from the front; a broken byte is taken alone and gives U+FFFD.
std::uint32_t take_character(std::string_view& utf8) {
  const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(utf8[i]); };
  const std::uint8_t lead = byte(0);
  const std::size_t length = lead < 0x80 ? 1 : lead >> 5U == 6 ? 2 : lead >> 4U == 14 ? 3 : lead >> 3U == 30 ? 4 : 0;
  bool whole = length > 0 && length <= utf8.size();
  std::uint32_t code = length <= 1 ? lead : lead & (0x7FU >> length);
  for (std::size_t i = 1; whole && i < length; ++i) {
    whole = (byte(i) & 0xC0U) == 0x80;
    code = code << 6U | (byte(i) & 0x3FU);
  }
  constexpr std::array<std::uint32_t, 5> kSmallest{0, 0, 0x80, 0x800, 0x10000};
  if (!whole || code < kSmallest[length] || code > 0x10FFFF || (code >= 0xD800 && code < 0xE000)) {
    utf8.remove_prefix(1);
    return 0xFFFD;
  }
  utf8.remove_prefix(length);
  return code;
}

}  // namespace

std::vector<FontRun> font_runs(std::string_view utf8, Weight weight) {
  const auto& choices = faces().by_weight[static_cast<std::size_t>(weight)];
  std::vector<FontRun> runs;
  while (!utf8.empty()) {
    const std::string_view before = utf8;
    const std::uint32_t code = take_character(utf8);
    const Face& face = choices[0].has(code) || !choices[1].has(code) ? choices[0] : choices[1];
    if (runs.empty() || runs.back().face != face.cairo) runs.push_back({face.cairo, {}});
    if (code == 0xFFFD) {
      runs.back().utf8 += "\uFFFD";
    } else {
      runs.back().utf8 += code < 0x20 ? std::string_view(" ") : before.substr(0, before.size() - utf8.size());
    }
  }
  return runs;
}

}  // namespace trocar::canvas
