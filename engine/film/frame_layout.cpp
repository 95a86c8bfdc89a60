#include "engine/film/frame_layout.h"

#include <algorithm>
#include <cmath>

#include "engine/core/check.h"
#include "engine/film/emblems.h"
#include "engine/film/film_overlay.h"
#include "engine/film/pixels.h"

namespace trocar::film {
namespace {

std::vector<Cell> grid_of(int columns, int rows, std::size_t count, int width, int height) {
  std::vector<Cell> cells;
  for (int i = 0; i < static_cast<int>(count); ++i) {
    const int column = i % columns;
    const int row = i / columns;
    const int left = width * column / columns;
    const int top = height * row / rows;
    cells.push_back({left, top, width * (column + 1) / columns - left, height * (row + 1) / rows - top});
  }
  return cells;
}

/// Below the titles at the top, above the band at the foot.
Cell inset_of(const Composition& film, int width, int height) {
  const double unit = unit_of(Band::kOneRow, width, height);
  const int margin = static_cast<int>(std::lround(kMargin * unit));
  const int inset_width = static_cast<int>(std::lround(film.share * width));
  const int inset_height = inset_width * height / width;
  const bool left = film.corner == Corner::kTopLeft || film.corner == Corner::kBottomLeft;
  const bool top = film.corner == Corner::kTopLeft || film.corner == Corner::kTopRight;
  const int below_titles = margin + static_cast<int>(std::lround(52.0 * unit));
  const int above_band = height - band_height_of(Band::kOneRow, width, height) - margin / 2 - inset_height;
  return {left ? margin : width - margin - inset_width, std::max(0, top ? below_titles : above_band), inset_width,
          inset_height};
}

void fill(Image& frame, const Part& wanted, Rgba colour) {
  const Part part = clipped(wanted, frame.width, frame.height);
  if (part.width > 0 && part.height > 0) put(frame, Image(part.width, part.height, colour), part.x, part.y);
}

}  // namespace

std::vector<Cell> cells_of(const Composition& film, int width, int height) {
  const std::size_t count = film.sources.size();
  switch (film.layout) {
    case Layout::kSingle:
      return {{0, 0, width, height}};
    case Layout::kSideBySide:
      return grid_of(2, 1, count, width, height);
    case Layout::kTopBottom:
      return grid_of(1, 2, count, width, height);
    case Layout::kTwoByTwo:
      return grid_of(2, 2, count, width, height);
    case Layout::kThreeByThree:
      return grid_of(3, 3, count, width, height);
    case Layout::kPictureInPicture:
      break;
  }
  return {{0, 0, width, height}, inset_of(film, width, height)};
}

Image composed(std::vector<Image> pictures, const std::vector<Cell>& cells, int width, int height) {
  TROCAR_CHECK(pictures.size() == cells.size());
  const bool alone = cells.size() == 1 && cells[0].width == width && cells[0].height == height;
  if (alone) return std::move(pictures[0]);
  Image frame(width, height);
  const int line = std::max(2, 2 * static_cast<int>(std::lround(height / 360.0)));
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const Cell& cell = cells[i];
    TROCAR_CHECK(pictures[i].width == cell.width && pictures[i].height == cell.height);
    const bool inside = i > 0 && cells[0].width == width && cells[0].height == height;
    if (inside) fill(frame, {cell.x - line, cell.y - line, cell.width + 2 * line, cell.height + 2 * line}, kSoft);
    put(frame, pictures[i], cell.x, cell.y);
    if (inside) continue;
    if (cell.x > 0) fill(frame, {cell.x - line / 2, cell.y, line, cell.height}, kSoft);
    if (cell.y > 0) fill(frame, {cell.x, cell.y - line / 2, cell.width, line}, kSoft);
  }
  return frame;
}

}  // namespace trocar::film
