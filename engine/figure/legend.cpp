#include "engine/figure/legend.h"

#include <algorithm>
#include <cmath>

#include "engine/figure/key.h"

namespace trocar::figure {
namespace {

constexpr Rgba kCard{14, 17, 22, 214};
constexpr Rgba kBright{238, 241, 245, 255};
constexpr Rgba kSoft{188, 194, 203, 255};

// Lengths at a height of 720, where the unit is 1.
constexpr double kPad = 14.0;
constexpr double kBar = 200.0;
constexpr double kClass = 24.0;
constexpr double kTitleLine = 22.0;
constexpr double kSmall = 13.0;

double unit_of(const Image& picture) {
  return std::clamp(std::min(picture.height / 720.0, picture.width / 1000.0), 0.6, 4.0);
}

}  // namespace

Image with_legend(const Image& picture, const learning::Field& field, const plot::Colouring& colouring,
                  const std::string& owner) {
  double below_px = 0.0;
  return with_legend(picture, field, colouring, owner, below_px);
}

Image with_legend(const Image& picture, const learning::Field& field, const plot::Colouring& colouring,
                  const std::string& owner, double& below_px, std::optional<double> letters_px) {
  using canvas::TextStyle;
  const double unit = letters_px ? *letters_px / kSmall : unit_of(picture);
  canvas::Canvas canvas(picture);
  const KeyLook look{unit, 14.0 * unit, 1.0, kBright};
  const TextStyle title{16.0 * unit, canvas::Weight::kSemiBold, kBright, canvas::Align::kLeft};
  const TextStyle small{kSmall * unit, canvas::Weight::kRegular, kSoft, canvas::Align::kLeft};
  const double head = (kTitleLine + (owner.empty() ? 0.0 : kTitleLine)) * unit;
  // Cells that are not known are not drawn in the scene; a key without marks has no word for them.
  learning::Field known = field;
  std::replace_if(
      known.values.begin(), known.values.end(), [](double value) { return !std::isfinite(value); },
      colouring.scale.low);
  const double bar =
      (colouring.categories.empty() ? kBar : kClass * static_cast<double>(field.categories.size())) * unit;
  const double wide =
      2 * kPad * unit + std::max({canvas.text_width(field.title, title), canvas.text_width(owner, small),
                                  key_width(canvas, known, {}, colouring, look)});
  const double left = picture.width - wide - kPad * unit;
  const double top = below_px + kPad * unit;
  const double tall = head + bar + 2 * kPad * unit;
  if (below_px > 0.0 && top + tall > picture.height) return picture;
  below_px = top + tall;
  canvas.rectangle(left, top, wide, tall, kCard, 6.0 * unit);
  const double x = left + kPad * unit;
  double base = top + (kPad + 12.0) * unit;
  canvas.text({x, base}, field.title, title);
  base += kTitleLine * unit;
  if (!owner.empty()) canvas.text({x, base - 2.0 * unit}, owner, small);
  draw_key(canvas, known, {}, colouring, {x, top + kPad * unit + head, bar, look});
  return canvas.picture();
}

}  // namespace trocar::figure
