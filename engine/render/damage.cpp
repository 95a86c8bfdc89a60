#include "engine/render/damage.h"

#include <algorithm>
#include <cstddef>

namespace trocar::render {
namespace {

constexpr int kTile_px = 32;
/// Each box costs a walk through the scene.
constexpr std::size_t kMostBoxes = 6;
/// From this share on the whole picture is drawn, which needs no care.
constexpr double kWholeFrom = 0.7;

/// Runs of marked tiles, equal ones below each other as one.
std::vector<PixelBox> runs(const std::vector<std::uint8_t>& tiles, int columns, int rows) {
  std::vector<PixelBox> found;
  for (int row = 0; row < rows; ++row) {
    const std::uint8_t* marks = tiles.data() + static_cast<std::ptrdiff_t>(row) * columns;
    for (int begin = 0; begin < columns; ++begin) {
      if (marks[begin] == 0) continue;
      int end = begin;
      while (end < columns && marks[end] != 0) ++end;
      const auto above = std::find_if(found.begin(), found.end(), [&](const PixelBox& box) {
        return box.bottom == row && box.left == begin && box.right == end;
      });
      if (above != found.end()) {
        ++above->bottom;
      } else {
        found.push_back({begin, row, end, row + 1});
      }
      begin = end;
    }
  }
  return found;
}

/// Joins the two that waste the least.
void join_two(std::vector<PixelBox>& boxes) {
  std::size_t first = 0;
  std::size_t second = 1;
  std::int64_t least = INT64_MAX;
  for (std::size_t a = 0; a < boxes.size(); ++a) {
    for (std::size_t b = a + 1; b < boxes.size(); ++b) {
      const std::int64_t waste = boxes[a].with(boxes[b]).area() - boxes[a].area() - boxes[b].area();
      if (waste >= least) continue;
      least = waste;
      first = a;
      second = b;
    }
  }
  boxes[first] = boxes[first].with(boxes[second]);
  boxes.erase(boxes.begin() + static_cast<std::ptrdiff_t>(second));
}

}  // namespace

Changes changes(const std::vector<Item>& before, const std::vector<Item>& now) {
  const std::size_t shorter = std::min(before.size(), now.size());
  std::size_t head = 0;
  while (head < shorter && before[head] == now[head]) ++head;
  std::size_t tail = 0;
  while (tail < shorter - head && before[before.size() - 1 - tail] == now[now.size() - 1 - tail]) ++tail;
  Changes found;
  const bool aligned = before.size() == now.size();
  for (std::size_t i = head; i + tail < before.size(); ++i) {
    if (before[i].source != 0 && !(aligned && before[i] == now[i])) found.gone.push_back(&before[i]);
  }
  for (std::size_t i = head; i + tail < now.size(); ++i) {
    if (now[i].source != 0 && !(aligned && before[i] == now[i])) found.come.push_back(&now[i]);
  }
  return found;
}

Damage::Damage(const Window& window)
    : window_(window),
      columns_((window.width + kTile_px - 1) / kTile_px),
      rows_((window.height + kTile_px - 1) / kTile_px),
      tiles_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), 0) {}

void Damage::add_all() {
  all_ = true;
}

void Damage::mark(const PixelBox& box) {
  const int left = std::clamp(box.left / kTile_px, 0, columns_);
  const int right = std::clamp((box.right + kTile_px - 1) / kTile_px, 0, columns_);
  const int top = std::clamp(box.top / kTile_px, 0, rows_);
  const int bottom = std::clamp((box.bottom + kTile_px - 1) / kTile_px, 0, rows_);
  for (int row = top; row < bottom; ++row) {
    std::fill_n(tiles_.begin() + static_cast<std::ptrdiff_t>(row) * columns_ + left, std::max(0, right - left), 1);
  }
}

void Damage::add(const Corners& corners) {
  const auto box = bounds(corners, window_);
  if (!box) return add_all();
  mark(*box);
}

std::vector<PixelBox> Damage::boxes() const {
  const PixelBox whole{0, 0, window_.width, window_.height};
  if (all_) return {whole};
  std::vector<PixelBox> found = runs(tiles_, columns_, rows_);
  while (found.size() > kMostBoxes) join_two(found);
  std::int64_t area = 0;
  for (PixelBox& box : found) {
    box = {box.left * kTile_px, box.top * kTile_px, std::min(box.right * kTile_px, whole.right),
           std::min(box.bottom * kTile_px, whole.bottom)};
    area += box.area();
  }
  if (static_cast<double>(area) >= kWholeFrom * static_cast<double>(whole.area())) return {whole};
  return found;
}

}  // namespace trocar::render
