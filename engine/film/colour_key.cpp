#include "engine/film/colour_key.h"

#include <algorithm>
#include <cmath>

#include "engine/canvas/canvas.h"
#include "engine/core/check.h"
#include "engine/film/emblems.h"
#include "engine/film/pixels.h"

namespace trocar::film {
namespace {

using canvas::Canvas;

constexpr double kLetters = 16.0;
constexpr double kPad = 12.0;
constexpr double kSwatch = 16.0;  // And the width of the bar.
constexpr double kSpace = 8.0;
constexpr double kRow = 26.0;
constexpr double kBarHeight = 150.0;

void draw_bar(Canvas& canvas, const ColourKey& key, double unit) {
  const double step = kBarHeight * unit / static_cast<double>(key.colours.size());
  for (std::size_t i = 0; i < key.colours.size(); ++i) {
    const double y = kPad * unit + kBarHeight * unit - static_cast<double>(i + 1) * step;
    // Half a pixel over the one before: no line shows between two.
    canvas.rectangle(kPad * unit, y, kSwatch * unit, step + 0.5, key.colours[i]);
  }
  canvas.outline(kPad * unit, kPad * unit, kSwatch * unit, kBarHeight * unit, kSoft, std::max(1.0, unit));
  const canvas::TextStyle letters{kLetters * unit, canvas::Weight::kRegular, kWhite};
  const double x = (kPad + kSwatch + kSpace) * unit;
  canvas.text({x, (kPad + 0.75 * kLetters) * unit}, key.words.back(), letters);
  canvas.text({x, (kPad + kBarHeight) * unit}, key.words.front(), letters);
}

void draw_classes(Canvas& canvas, const ColourKey& key, double unit) {
  const canvas::TextStyle letters{kLetters * unit, canvas::Weight::kRegular, kWhite};
  for (std::size_t i = 0; i < key.colours.size(); ++i) {
    const double y = (kPad + static_cast<double>(i) * kRow) * unit;
    canvas.rectangle(kPad * unit, y, kSwatch * unit, kSwatch * unit, key.colours[i]);
    canvas.text({(kPad + kSwatch + kSpace) * unit, y + 0.85 * kSwatch * unit}, key.words[i], letters);
  }
}

}  // namespace

void draw_colour_key(Image& frame, const ColourKey& key, double x, double top, double unit, bool from_right) {
  TROCAR_CHECK(key.classes ? key.words.size() == key.colours.size() : key.words.size() == 2 && key.colours.size() >= 2);
  const Canvas ruler{Image(1, 1)};
  double words = 0.0;
  for (const std::string& word : key.words) {
    words = std::max(words, ruler.text_width(word, {kLetters * unit, canvas::Weight::kRegular, kWhite}));
  }
  const double rows = key.classes ? static_cast<double>(key.colours.size()) * kRow - (kRow - kSwatch) : kBarHeight;
  const double wide = words + (2.0 * kPad + kSwatch + kSpace) * unit;
  const double tall = (rows + 2.0 * kPad) * unit;
  const Part whole{static_cast<int>(std::floor(from_right ? x - wide : x)), static_cast<int>(std::floor(top)),
                   static_cast<int>(std::ceil(wide)), static_cast<int>(std::ceil(tall))};
  const Part part = clipped(whole, frame.width, frame.height);
  if (part.width == 0 || part.height == 0) return;
  Canvas canvas(copy_of(frame, part));
  canvas.rectangle(0, 0, wide, tall, kGlass, 6.0 * unit);
  if (key.classes) {
    draw_classes(canvas, key, unit);
  } else {
    draw_bar(canvas, key, unit);
  }
  put(frame, canvas.picture(), part.x, part.y);
}

}  // namespace trocar::film
