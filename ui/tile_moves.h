/// What people do to a layout, as functions from one tree to another: each panel is in it at most once, no tile becomes
/// empty, the shares of neighbours add up to 1, and the last panel stays.
#pragma once

#include <cstdint>
#include <optional>

#include "ui/tile_tree.h"

namespace trocar::ui {

enum class Side : std::uint8_t { kLeft, kRight, kUp, kDown };

/// Where a panel is dropped.
struct DropPlace {
  PanelId beside = PanelId::kView;  ///< Of the tile that it is dropped on.
  std::optional<Side> side;         ///< Half of that tile becomes its own; none: it becomes a tab of it.
  int index = -1;                   ///< Which tab, counted before it is moved; −1: the last.
};

/// `panel`, open or closed, is at `place` and in front. Where that is where it is, or `beside` is closed: as it was.
Tile dropped(const Tile& root, PanelId panel, const DropPlace& place);
/// Into the tile on that side, or into a new one at that edge of the window. As it was where it is at the edge already.
Tile moved(const Tile& root, PanelId panel, Side side);
Tile closed(const Tile& root, PanelId panel);
/// In front of its tile; a closed panel comes to those that it is with in `home`, a hidden one comes out with all that
/// was hidden with it.
Tile opened(const Tile& root, PanelId panel, const Tile& home);
/// Puts the left or right side of the window away, or shows it again. As it was where there is nothing beside it.
Tile with_side_toggled(const Tile& root, Side side);
/// All tiles beside or above each other with that of `panel` are as large as each other.
Tile equalised(const Tile& root, PanelId panel);

}  // namespace trocar::ui
