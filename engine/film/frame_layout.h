/// Where the pictures of a film's sources lie in its frames.
#pragma once

#include <cstddef>
#include <vector>

#include "engine/core/image.h"
#include "engine/film/composition.h"

namespace trocar::film {

/// In whole pixels of the frame, from the top left.
struct Cell {
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;
  bool operator==(const Cell&) const = default;
};

/// One for each source, by rows; of a grid together they are the whole frame. A picture in the picture comes second,
/// within the margins of the first and off its captions at the foot.
std::vector<Cell> cells_of(const Composition& film, int width, int height);

/// The pictures at their cells, with lines between them, and around one that lies in another; black where none is.
/// Precondition: as many pictures as cells, each of its cell's size.
Image composed(std::vector<Image> pictures, const std::vector<Cell>& cells, int width, int height);

}  // namespace trocar::film
