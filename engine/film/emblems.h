/// The small drawings of a film's caption band. Private to the module. Sizes are in pixels of the canvas.
#pragma once

#include "engine/canvas/canvas.h"
#include "engine/demonstration/recording.h"

namespace trocar::film {

// Light letters on dark glass: legible whatever is behind.
constexpr Rgba kGlass{14, 17, 22, 216};
constexpr Rgba kWhite{245, 247, 250, 255};
constexpr Rgba kSoft{176, 184, 196, 255};
constexpr Rgba kFaint{245, 247, 250, 64};
constexpr Rgba kLit{240, 228, 66, 255};
constexpr Rgba kDark{14, 17, 22, 255};

/// Word, colour and shape of who moves the tool; the shape is drawn in a square of side 2 · `radius`.
struct AuthorityLook {
  const char* word;
  Rgba ground;
  Rgba ink;
};
AuthorityLook look_of(demonstration::Authority authority);
void draw_authority_shape(canvas::Canvas& canvas, demonstration::Authority authority, canvas::Point centre,
                          double radius, Rgba ink);

/// How far a film has come with a segment.
enum class ChipState { kAhead, kNow, kPast };
void draw_chip(canvas::Canvas& canvas, char letter, ChipState state, double progress, canvas::Point corner,
               double width, double height);
/// A pedal from the side: flat and filled when pressed, raised and hollow when not.
void draw_pedal(canvas::Canvas& canvas, bool pressed, canvas::Point corner, double width, double height);
/// Two jaws that open by `jaw_rad`.
void draw_jaws(canvas::Canvas& canvas, double jaw_rad, canvas::Point hinge, double length);

}  // namespace trocar::film
