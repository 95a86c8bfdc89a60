/// A demonstration's paths as a small picture: the middle of the board from above, as the paper's camera stands.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "engine/demonstration/demonstration.h"

namespace trocar::workbench {

/// Across to the right (W's y) and down (W's x), each 0 … 1 within the picture. Its sides are as 3 to 2.
struct SketchPoint {
  float x = 0.0F;
  float y = 0.0F;
  std::optional<demonstration::Segment> segment;  ///< That it is in, if any.
};
constexpr float kSketchAspect = 1.5F;

struct PathSketch {
  std::array<std::vector<SketchPoint>, 2> arms;  ///< Left, right; at most 48 points each, by time.
};

/// Of the measured paths between the gates; what leaves the picture is cut to its edge. Quick: a few microseconds for
/// each point, however long the demonstration. Points that are not finite are left out.
PathSketch path_sketch(const demonstration::Demonstration& document);
/// The feet of all pegs, start pegs first.
std::span<const SketchPoint> sketch_pegs();

}  // namespace trocar::workbench
