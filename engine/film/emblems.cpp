#include "engine/film/emblems.h"

#include <algorithm>
#include <cmath>

#include "engine/plot/colour_map.h"

namespace trocar::film {

using canvas::Canvas;
using canvas::Point;
using demonstration::Authority;

AuthorityLook look_of(Authority authority) {
  // Okabe and Ito's blue, orange and green; no two are confused by any reader, and the words and shapes differ too.
  switch (authority) {
    case Authority::kAgent:
      return {"AGENT", plot::category(4), kWhite};
    case Authority::kOperator:
      return {"OPERATOR", plot::category(0), kDark};
    case Authority::kAssistant:
      return {"ASSISTANT", plot::category(2), kWhite};
    case Authority::kHold:
      break;
  }
  return {"HOLD", {92, 99, 110, 255}, kWhite};
}

void draw_authority_shape(Canvas& canvas, Authority authority, Point c, double r, Rgba ink) {
  switch (authority) {
    case Authority::kAgent:  // A diamond.
      canvas.polygon({{c.x, c.y - r}, {c.x + r, c.y}, {c.x, c.y + r}, {c.x - r, c.y}}, ink);
      return;
    case Authority::kOperator:
      canvas.circle(c, 0.86 * r, ink);
      return;
    case Authority::kAssistant:  // A triangle.
      canvas.polygon({{c.x, c.y - 0.9 * r}, {c.x + r, c.y + 0.8 * r}, {c.x - r, c.y + 0.8 * r}}, ink);
      return;
    case Authority::kHold:  // Two bars.
      canvas.rectangle(c.x - 0.75 * r, c.y - 0.85 * r, 0.5 * r, 1.7 * r, ink);
      canvas.rectangle(c.x + 0.25 * r, c.y - 0.85 * r, 0.5 * r, 1.7 * r, ink);
      return;
  }
}

void draw_chip(Canvas& canvas, char letter, ChipState state, double progress, Point corner, double width,
               double height) {
  const double radius = 0.16 * height;
  const double bar = std::max(2.0, 0.11 * height);
  const bool now = state == ChipState::kNow;
  if (now) canvas.rectangle(corner.x, corner.y, width, height, kWhite, radius);
  if (state == ChipState::kPast) canvas.rectangle(corner.x, corner.y, width, height, kFaint, radius);
  if (state == ChipState::kAhead) {
    canvas.outline(corner.x + 0.5, corner.y + 0.5, width - 1.0, height - 1.0, kFaint, 1.0, radius);
  }
  const double size = 0.56 * height;
  canvas.text({corner.x + width / 2, corner.y + height / 2 + 0.36 * size - (now ? 0.5 * bar : 0.0)},
              std::string_view(&letter, 1),
              {size, canvas::Weight::kBold,
               now                         ? kDark
               : state == ChipState::kPast ? kWhite
                                           : kSoft,
               canvas::Align::kCentre});
  if (!now) return;
  const double inset = 0.14 * width;
  const double whole = width - 2 * inset;
  const double y = corner.y + height - 2.0 * bar;
  canvas.rectangle(corner.x + inset, y, whole, bar, {190, 196, 205, 255}, bar / 2);
  const double done = whole * std::clamp(progress, 0.0, 1.0);
  if (done > 0.0) canvas.rectangle(corner.x + inset, y, std::max(done, bar), bar, plot::category(4), bar / 2);
}

void draw_pedal(Canvas& canvas, bool pressed, Point corner, double width, double height) {
  const double thick = 0.24 * height;
  const double floor = corner.y + height;
  canvas.rectangle(corner.x, floor - 0.5 * thick, width, 0.5 * thick, kSoft);
  const double lift = pressed ? 0.0 : 0.62 * height;
  const double right = corner.x + width;
  const double low = floor - 0.75 * thick;
  const std::vector<Point> plate{
      {corner.x, low - thick}, {right, low - lift - thick}, {right, low - lift}, {corner.x, low}};
  if (pressed) {
    canvas.polygon(plate, kLit);
  } else {
    std::vector<Point> closed = plate;
    closed.push_back(plate.front());
    canvas.polyline(closed, kSoft, std::max(1.0, 0.08 * height));
  }
}

void draw_jaws(Canvas& canvas, double jaw_rad, Point hinge, double length) {
  const double half = std::clamp(jaw_rad, 0.0, 1.6) / 2.0;
  const double width = std::max(1.5, 0.13 * length);
  for (const double side : {-1.0, 1.0}) {
    const Point tip{hinge.x + length * std::cos(half), hinge.y + side * (length * std::sin(half) + 0.5 * width)};
    canvas.line({hinge.x, hinge.y + side * 0.5 * width}, tip, kWhite, width);
  }
  canvas.circle(hinge, 1.1 * width, kSoft);
}

}  // namespace trocar::film
