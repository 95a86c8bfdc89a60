#include "engine/demonstration/segment_colour.h"

#include <array>

namespace trocar::demonstration {

Rgba segment_colour(Segment segment) {
  constexpr std::array<Rgba, kSegmentCount> kColours{Rgba{86, 180, 233, 255}, Rgba{230, 159, 0, 255},
                                                     Rgba{62, 190, 148, 255}, Rgba{219, 141, 186, 255},
                                                     Rgba{222, 212, 90, 255}};
  return kColours[static_cast<std::size_t>(segment)];
}

}  // namespace trocar::demonstration
