#include "engine/film/film_overlay.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/canvas/canvas.h"
#include "engine/core/check.h"
#include "engine/film/emblems.h"
#include "engine/film/pixels.h"

namespace trocar::film {
namespace {

using canvas::Align;
using canvas::Canvas;
using canvas::Point;
using canvas::TextStyle;
using canvas::Weight;

// Lengths at a height of 720, where the unit is 1.
constexpr double kRowHeight = 40.0;
constexpr double kRowTop = 14.0;
constexpr double kRowGap = 8.0;
constexpr double kBand = 92.0;
constexpr double kTwoRowBand = kBand + kRowHeight + kRowGap;
constexpr double kFoot = 14.0;  // Of the last line's letters above the band's lower edge.
// What a row needs; narrower frames get smaller letters.
constexpr double kOneRowWidth = 1000.0;
constexpr double kTwoRowWidth = 560.0;
constexpr double kShortWidth = 520.0;
// Of a small picture, so much of the height may be band.
constexpr double kMostBand = 0.3;
constexpr double kLowBand = 0.2;

/// "01:05.3".
std::string clock_text(double seconds) {
  const auto tenths = static_cast<std::int64_t>(std::floor(std::max(0.0, seconds) * 10.0 + 1e-6));
  return fmt::format("{:02}:{:02}.{}", tenths / 600, tenths / 10 % 60, tenths % 10);
}

std::string speed_text(double speed) {
  if (speed == 0.0) return "held";
  return speed == 1.0 ? "" : fmt::format("{:.3g}× speed", speed);
}

/// Shortens from the end until it fits.
std::string fitted(const Canvas& canvas, const std::string& text, const TextStyle& style, double width) {
  if (canvas.text_width(text, style) <= width) return text;
  std::string shorter = text;
  while (!shorter.empty() && canvas.text_width(shorter + "…", style) > width) {
    do shorter.pop_back();
    while (!shorter.empty() && (static_cast<std::uint8_t>(shorter.back()) & 0xC0U) == 0x80U);
    if (!shorter.empty() && static_cast<std::uint8_t>(shorter.back()) >= 0xC0U) shorter.pop_back();
  }
  return shorter + "…";
}

/// The width of a clock's text, and the text itself, with every digit as wide as a zero: it must not tremble as it
/// runs.
double clock_width(const Canvas& canvas, const std::string& text, const TextStyle& style) {
  const double zero = canvas.text_width("0", style);
  double width = 0.0;
  for (const char& c : text) {
    width += c >= '0' && c <= '9' ? zero : canvas.text_width(std::string_view(&c, 1), style);
  }
  return width;
}

void draw_clock(Canvas& canvas, Point at, const std::string& text, TextStyle style) {
  const double zero = canvas.text_width("0", style);
  style.align = Align::kCentre;
  for (const char& c : text) {
    const double width = c >= '0' && c <= '9' ? zero : canvas.text_width(std::string_view(&c, 1), style);
    canvas.text({at.x + width / 2, at.y}, std::string_view(&c, 1), style);
    at.x += width;
  }
}

/// What of the frame is drawn on, as a canvas with the frame's own coordinates shifted to its corner.
template <typename Draw>
void draw_part(Image& frame, const Part& wanted, Draw draw) {
  const Part part = clipped(wanted, frame.width, frame.height);
  if (part.width == 0 || part.height == 0) return;
  Canvas canvas(copy_of(frame, part));
  draw(canvas);
  put(frame, canvas.picture(), part.x, part.y);
}

}  // namespace

Band band_for(const Overlays& shown, int width, int height) {
  bool any = false;
  for (const Overlay part : {Overlay::kTimer, Overlay::kSegment, Overlay::kAuthority, Overlay::kPedals, Overlay::kJaws,
                             Overlay::kProvenance}) {
    any = any || shown.has(part);
  }
  constexpr int kSmall = 300;
  constexpr int kLow = 500;
  if (!any) return Band::kNone;
  if (width >= 5 * height / 2 || (height >= kLow && 2 * width >= 3 * height)) return Band::kOneRow;
  return height < kSmall ? Band::kShort : Band::kTwoRows;
}

double unit_of(Band band, int width, int height) {
  switch (band) {
    case Band::kOneRow:
      // One of two that lie above each other is low, yet as wide as ever.
      if (5 * width > 11 * height) {
        return std::min({std::max(1.0, height / 720.0), width / kOneRowWidth, kLowBand * height / kBand});
      }
      return std::min(height / 720.0, width / kOneRowWidth);
    case Band::kTwoRows:
      return std::min({1.0 * std::max(1.0, height / 720.0), width / kTwoRowWidth, kMostBand * height / kTwoRowBand});
    case Band::kShort:
      return std::min(width / kShortWidth, kMostBand * height / kBand);
    case Band::kNone:
      break;
  }
  return std::min(std::max(height / 720.0, 0.7), width / 320.0);
}

int band_height_of(Band band, int width, int height) {
  if (band == Band::kNone) return 0;
  const double rows = band == Band::kTwoRows ? kTwoRowBand : kBand;
  return std::min(height, static_cast<int>(std::ceil(rows * unit_of(band, width, height))));
}

struct FilmOverlay::Impl {
  int width = 0;
  int height = 0;
  Band band = Band::kOneRow;
  double unit = 1.0;
  Canvas ruler{Image(1, 1)};  ///< Measures texts.

  TextStyle style(double size, Weight weight, Rgba colour, Align align = Align::kLeft) const {
    return {size * unit, weight, colour, align};
  }

  /// A line of text on glass; `x` is its left end, middle or right end by `align`.
  void panel(Image& frame, const std::string& text, double x, double y, const TextStyle& letters) {
    const double pad = 12.0 * unit;
    const double tall = 2.0 * letters.size_px;
    const std::string shown = fitted(ruler, text, letters, width - 2 * (kMargin * unit + pad));
    const double wide = ruler.text_width(shown, letters) + 2 * pad;
    const double left = letters.align == Align::kLeft ? x : letters.align == Align::kCentre ? x - wide / 2 : x - wide;
    const Part part{static_cast<int>(std::floor(left)), static_cast<int>(std::floor(y)),
                    static_cast<int>(std::ceil(wide)) + 1, static_cast<int>(std::ceil(tall)) + 1};
    draw_part(frame, part, [&](Canvas& canvas) {
      canvas.rectangle(0, 0, wide, tall, kGlass, 6.0 * unit);
      TextStyle from_left = letters;
      from_left.align = Align::kLeft;
      canvas.text({pad, tall / 2 + 0.36 * letters.size_px}, shown, from_left);
    });
  }

  void draw_top(Image& frame, const FrameCaption& caption) {
    const double margin = kMargin * unit;
    const std::string speed = speed_text(caption.speed);
    if (!speed.empty()) {
      panel(frame, speed, width - margin, margin, style(20.0, Weight::kSemiBold, kLit, Align::kRight));
    }
    if (!caption.title.empty()) {
      const TextStyle letters = style(20.0, Weight::kSemiBold, kWhite);
      const double room = width - 2 * margin - (speed.empty() ? 24.0 : 190.0) * unit;
      panel(frame, fitted(ruler, caption.title, letters, room), margin, margin, letters);
    }
    double y = margin + (caption.title.empty() ? 0.0 : 46.0 * unit);
    if (caption.scripted && !(band != Band::kNone && caption.shown.has(Overlay::kProvenance))) {
      panel(frame, "scripted", margin, y, style(16.0, Weight::kSemiBold, kLit));
      y += 37.0 * unit;
    }
    if (caption.lines_at_right) y = margin + (speed.empty() ? 0.0 : 46.0 * unit);
    for (const std::string& line : caption.lines) {
      const Align align = caption.lines_at_right ? Align::kRight : Align::kLeft;
      panel(frame, line, caption.lines_at_right ? width - margin : margin, y,
            style(16.0, Weight::kRegular, kWhite, align));
      y += 37.0 * unit;
    }
    if (!caption.colours) return;
    if (caption.colours_at_left) return draw_colour_key(frame, *caption.colours, margin, y, unit, false);
    const double below_speed = margin + (speed.empty() ? 0.0 : 46.0 * unit);
    draw_colour_key(frame, *caption.colours, width - margin, caption.lines_at_right ? y : below_speed, unit, true);
  }

  void draw_authority(Canvas& canvas, const FrameCaption& caption, double x, double y) const {
    const AuthorityLook look = look_of(caption.authority);
    const double tall = kRowHeight * unit;
    canvas.rectangle(x, y, 176.0 * unit, tall, look.ground, 6.0 * unit);
    draw_authority_shape(canvas, caption.authority, {x + 24.0 * unit, y + tall / 2}, 10.0 * unit, look.ink);
    canvas.text({x + 46.0 * unit, y + tall / 2 + 7.2 * unit}, look.word, style(20.0, Weight::kBold, look.ink));
  }

  void draw_chips(Canvas& canvas, const FrameCaption& caption, double x, double y) const {
    for (int i = 0; i < demonstration::kSegmentCount; ++i) {
      const auto segment = static_cast<demonstration::Segment>(i);
      ChipState state = ChipState::kAhead;
      if (caption.segment && segment == *caption.segment) state = ChipState::kNow;
      if (caption.segment && segment < *caption.segment) state = ChipState::kPast;
      draw_chip(canvas, demonstration::letter(segment), state, caption.segment_progress, {x + i * 50.0 * unit, y},
                44.0 * unit, kRowHeight * unit);
    }
  }

  void draw_pedal_with_name(Canvas& canvas, const char* name, bool pressed, double x, double y) const {
    draw_pedal(canvas, pressed, {x, y + 10.0 * unit}, 30.0 * unit, 20.0 * unit);
    canvas.text({x + 40.0 * unit, y + 18.0 * unit}, name,
                style(14.0, pressed ? Weight::kBold : Weight::kRegular, pressed ? kLit : kSoft));
    canvas.text({x + 40.0 * unit, y + 35.0 * unit}, pressed ? "pressed" : "up",
                style(14.0, pressed ? Weight::kSemiBold : Weight::kRegular, pressed ? kLit : kSoft));
  }

  void draw_jaw_with_name(Canvas& canvas, const char* name, double jaw_rad, double x, double y) const {
    draw_jaws(canvas, jaw_rad, {x + 4.0 * unit, y + 20.0 * unit}, 28.0 * unit);
    const double degrees = std::round(jaw_rad * 180.0 / std::numbers::pi) + 0.0;
    canvas.text({x + 42.0 * unit, y + 18.0 * unit}, name, style(14.0, Weight::kRegular, kSoft));
    canvas.text({x + 42.0 * unit, y + 35.0 * unit}, fmt::format("{:.0f}°", degrees == 0.0 ? 0.0 : degrees),
                style(14.0, Weight::kSemiBold, kWhite));
  }

  /// Pedals and jaws, the last one's right end at `right`.
  void draw_hands(Canvas& canvas, const FrameCaption& caption, double right, double y) const {
    double x = right;
    if (caption.shown.has(Overlay::kJaws)) {
      draw_jaw_with_name(canvas, "right", caption.jaw_rad[1], x - 76.0 * unit, y);
      draw_jaw_with_name(canvas, "left", caption.jaw_rad[0], x - 170.0 * unit, y);
      x -= 180.0 * unit;
    }
    if (caption.shown.has(Overlay::kPedals)) {
      draw_pedal_with_name(canvas, "clutch", caption.clutch_pedal, x - 118.0 * unit, y);
      draw_pedal_with_name(canvas, "agent", caption.agent_pedal, x - 236.0 * unit, y);
    }
  }

  void draw_foot(Canvas& canvas, const FrameCaption& caption, double base) const {
    const double margin = kMargin * unit;
    const TextStyle letters = style(15.0, Weight::kRegular, kSoft);
    double room = width - 2 * margin;
    if (caption.shown.has(Overlay::kTimer)) {
      std::string clock = clock_text(caption.time_s);
      if (caption.duration_s > 0.0) clock += " / " + clock_text(caption.duration_s);
      const double wide = clock_width(canvas, clock, letters);
      draw_clock(canvas, {width - margin - wide, base}, clock, letters);
      room -= wide + 20.0 * unit;
    }
    if (caption.shown.has(Overlay::kProvenance)) {
      canvas.text({margin, base}, fitted(canvas, caption.provenance, letters, room), letters);
    }
  }

  void draw_band(Canvas& canvas, const FrameCaption& caption) const {
    const double margin = kMargin * unit;
    const double y = kRowTop * unit;
    const double tall = (band == Band::kTwoRows ? kTwoRowBand : kBand) * unit;
    canvas.rectangle(0, 0, width, tall, kGlass);
    if (caption.duration_s > 0.0 && caption.shown.has(Overlay::kTimer)) {
      const double line = std::max(2.0, std::round(3.0 * unit));
      const double done = std::clamp(caption.time_s / caption.duration_s, 0.0, 1.0);
      canvas.rectangle(0, 0, width, line, kFaint);
      canvas.rectangle(0, 0, width * done, line, kWhite);
    }
    double x = margin;
    if (caption.shown.has(Overlay::kAuthority)) {
      draw_authority(canvas, caption, x, y);
      x += 196.0 * unit;
    }
    if (caption.shown.has(Overlay::kSegment)) draw_chips(canvas, caption, x, y);
    if (band == Band::kOneRow) draw_hands(canvas, caption, width - margin, y);
    if (band == Band::kTwoRows) {
      const double wide =
          (caption.shown.has(Overlay::kJaws) ? 180.0 : 0.0) + (caption.shown.has(Overlay::kPedals) ? 236.0 : 0.0);
      draw_hands(canvas, caption, margin + wide * unit, y + (kRowHeight + kRowGap) * unit);
    }
    draw_foot(canvas, caption, tall - kFoot * unit);
  }
};

FilmOverlay::FilmOverlay(int width, int height, Band band) : impl_(std::make_unique<Impl>()) {
  TROCAR_CHECK(width > 0 && height > 0);
  impl_->width = width;
  impl_->height = height;
  impl_->band = band;
  impl_->unit = unit_of(band, width, height);
}
FilmOverlay::~FilmOverlay() = default;
FilmOverlay::FilmOverlay(FilmOverlay&&) noexcept = default;
FilmOverlay& FilmOverlay::operator=(FilmOverlay&&) noexcept = default;

int FilmOverlay::band_height() const {
  return band_height_of(impl_->band, impl_->width, impl_->height);
}

void FilmOverlay::draw(Image& frame, const FrameCaption& caption) {
  TROCAR_CHECK(frame.width == impl_->width && frame.height == impl_->height);
  const int band = band_height();
  impl_->draw_top(frame, caption);
  const double unit = impl_->unit;
  const double middle = frame.width / 2.0;
  const double above = frame.height - band - (impl_->band == Band::kNone ? 20.0 : 0.0) * unit;
  if (!caption.caption.empty()) {
    const TextStyle letters = impl_->style(22.0, Weight::kSemiBold, kWhite, Align::kCentre);
    impl_->panel(frame, caption.caption, middle, above - 60.0 * unit, letters);
  }
  if (!caption.status.empty()) {
    const TextStyle letters = impl_->style(26.0, Weight::kBold, kLit, Align::kCentre);
    impl_->panel(frame, caption.status, middle, above - 124.0 * unit, letters);
  }
  if (band == 0) return;
  draw_part(frame, {0, frame.height - band, frame.width, band},
            [&](Canvas& canvas) { impl_->draw_band(canvas, caption); });
}

}  // namespace trocar::film
