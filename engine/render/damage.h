/// Which parts of a picture have to be drawn anew because what they show, or what shades it, changed.
#pragma once

#include <vector>

#include "engine/render/items.h"

namespace trocar::render {

/// The items that one list has and the other has not, found by position; moved ones are in both results.
struct Changes {
  std::vector<const Item*> gone;
  std::vector<const Item*> come;
  bool none() const { return gone.empty() && come.empty(); }
};
Changes changes(const std::vector<Item>& before, const std::vector<Item>& now);

/// A few boxes that together hold all that can differ between the pictures of two lists; empty if nothing can.
class Damage {
 public:
  explicit Damage(const Window& window);

  void add_all();
  void add(const Corners& corners);

  /// The whole picture is one box of its size.
  std::vector<PixelBox> boxes() const;

 private:
  void mark(const PixelBox& box);

  Window window_;
  int columns_;
  int rows_;
  std::vector<std::uint8_t> tiles_;
  bool all_ = false;
};

}  // namespace trocar::render
