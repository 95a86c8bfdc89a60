#include "ui/widgets/stroke.h"

#include <cmath>
#include <vector>

namespace trocar::ui {
namespace {

constexpr float kApart = 0.4F;        // Pixels.
constexpr float kSharpCosine = 0.2F;  // A turn of more than some 80° is a corner.

struct Step {
  float x = 0.0F;
  float y = 0.0F;
  float length = 0.0F;
};

Step step(ImVec2 from, ImVec2 to) {
  const float x = to.x - from.x;
  const float y = to.y - from.y;
  return {x, y, std::hypot(x, y)};
}

void flush(ImDrawList& list, std::vector<ImVec2>& piece, ImU32 colour, float width) {
  if (piece.size() >= 2) {
    list.AddPolyline(piece.data(), static_cast<int>(piece.size()), colour, ImDrawFlags_None, width);
  }
  piece.erase(piece.begin(), piece.end() - 1);
}

}  // namespace

void stroke(ImDrawList& list, std::span<const ImVec2> points, ImU32 colour, float width) {
  if (points.size() < 2) return;
  std::vector<ImVec2> piece{points.front()};
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Step next = step(piece.back(), points[i]);
    if (next.length < kApart && i + 1 < points.size()) continue;
    if (next.length == 0.0F) continue;
    if (piece.size() >= 2) {
      const Step before = step(piece[piece.size() - 2], piece.back());
      const float cosine = (before.x * next.x + before.y * next.y) / (before.length * next.length);
      if (cosine < kSharpCosine) flush(list, piece, colour, width);
    }
    piece.push_back(points[i]);
  }
  flush(list, piece, colour, width);
}

}  // namespace trocar::ui
