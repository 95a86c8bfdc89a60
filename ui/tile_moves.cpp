#include "ui/tile_moves.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace trocar::ui {
namespace {

using Kind = Tile::Kind;

constexpr float kEdgeShare = 0.25F;  ///< Of the window, for a new tile at its edge.

bool empty(const Tile& tile) {
  return tile.panels.empty() && tile.children.empty();
}

void scale_to_one(std::vector<float>& shares) {
  float sum = 0.0F;
  for (const float share : shares) sum += share;
  for (float& share : shares) share /= sum;
}

/// No empty tiles, no row or column of one, no row in a row and no column in a column.
Tile tidied(Tile tile) {
  if (tile.kind == Kind::kTabs) {
    tile.active = std::clamp(tile.active, 0, std::max(static_cast<int>(tile.panels.size()) - 1, 0));
    return tile;
  }
  std::vector<Tile> children;
  std::vector<float> shares;
  for (std::size_t i = 0; i < tile.children.size(); ++i) {
    Tile child = tidied(std::move(tile.children[i]));
    if (empty(child)) continue;
    if (child.kind == tile.kind) {
      for (std::size_t j = 0; j < child.children.size(); ++j) {
        child.children[j].hidden = child.children[j].hidden || child.hidden;
        shares.push_back(tile.shares[i] * child.shares[j]);
        children.push_back(std::move(child.children[j]));
      }
    } else {
      shares.push_back(tile.shares[i]);
      children.push_back(std::move(child));
    }
  }
  if (children.size() == 1) {
    Tile only = std::move(children.front());
    only.hidden = tile.hidden;
    return only;
  }
  if (children.empty()) return Tile{};
  scale_to_one(shares);
  tile.children = std::move(children);
  tile.shares = std::move(shares);
  return tile;
}

void show_all(Tile& tile) {
  tile.hidden = false;
  for (Tile& child : tile.children) show_all(child);
}

/// Also: what is hidden is at a side of the window, and something is not.
Tile whole(Tile root) {
  Tile tile = tidied(std::move(root));
  tile.hidden = false;
  bool any = false;
  for (std::size_t i = 0; i < tile.children.size(); ++i) {
    Tile& child = tile.children[i];
    const bool at_side = tile.kind == Kind::kRow && (i == 0 || i + 1 == tile.children.size());
    const bool hidden = child.hidden && at_side;
    show_all(child);
    child.hidden = hidden;
    any = any || !hidden;
  }
  if (!any) show_all(tile);
  return tile;
}

void take_out(Tile& tile, PanelId panel) {
  const auto at = std::find(tile.panels.begin(), tile.panels.end(), panel);
  if (at == tile.panels.end()) return;
  if (at - tile.panels.begin() < tile.active) --tile.active;
  tile.panels.erase(at);
}

Tile alone(PanelId panel) {
  Tile tile;
  tile.panels = {panel};
  return tile;
}

bool before(Side side) {
  return side == Side::kLeft || side == Side::kUp;
}

Kind kind_of(Side side) {
  return side == Side::kLeft || side == Side::kRight ? Kind::kRow : Kind::kColumn;
}

Tile split_off(PanelId panel, Tile rest, Side side, float share) {
  Tile tile;
  tile.kind = kind_of(side);
  tile.hidden = std::exchange(rest.hidden, false);
  tile.shares = before(side) ? std::vector{share, 1.0F - share} : std::vector{1.0F - share, share};
  tile.children.push_back(before(side) ? alone(panel) : std::move(rest));
  tile.children.push_back(before(side) ? std::move(rest) : alone(panel));
  return tile;
}

void put_into(Tile& tabs, PanelId panel, int index) {
  const auto count = static_cast<int>(tabs.panels.size());
  tabs.active = index < 0 ? count : std::min(index, count);
  tabs.panels.insert(tabs.panels.begin() + tabs.active, panel);
}

/// Where the tiles lie in a window of 1 by 1.
std::vector<PlacedTile> places_of(Tile& root) {
  return place(root, {0.0F, 0.0F, 1.0F, 1.0F}, {0.0F, 0.0F, 0.0F}).tiles;
}

bool holds(const PlacedTile& placed, PanelId panel) {
  return std::find(placed.tile->panels.begin(), placed.tile->panels.end(), panel) != placed.tile->panels.end();
}

// How much of the edge two tiles share; 0 if `other` does not lie on that side of `own`.
float touch(const Rect& own, const Rect& other, Side side) {
  constexpr float kSame = 1e-4F;
  const bool across = kind_of(side) == Kind::kRow;
  const float edge = side == Side::kLeft ? own.x0 : side == Side::kRight ? own.x1 : side == Side::kUp ? own.y0 : own.y1;
  const float theirs = side == Side::kLeft    ? other.x1
                       : side == Side::kRight ? other.x0
                       : side == Side::kUp    ? other.y1
                                              : other.y0;
  if (std::abs(edge - theirs) > kSame) return 0.0F;
  const float low = across ? std::max(own.y0, other.y0) : std::max(own.x0, other.x0);
  const float high = across ? std::min(own.y1, other.y1) : std::min(own.x1, other.x1);
  return std::max(high - low - kSame, 0.0F);
}

Tile* parent_of(Tile& tile, PanelId panel) {
  for (Tile& child : tile.children) {
    if (child.kind == Kind::kTabs && std::find(child.panels.begin(), child.panels.end(), panel) != child.panels.end())
      return &tile;
    if (Tile* found = parent_of(child, panel)) return found;
  }
  return nullptr;
}

/// The child of the root in which the panel is comes out if it was put away.
void reveal(Tile& root, PanelId panel) {
  for (Tile& child : root.children) {
    if (find_panel(child, panel) != nullptr) child.hidden = false;
  }
}

}  // namespace

Tile dropped(const Tile& root, PanelId panel, const DropPlace& place) {
  Tile out = root;
  Tile* target = find_panel(out, place.beside);
  if (target == nullptr) return out;
  Tile* from = find_panel(out, panel);
  // Taken out first, so that the tile is found by another of its panels.
  PanelId beside = place.beside;
  int index = place.index;
  if (from == target) {
    if (target->panels.size() == 1) return out;
    const auto at = std::find(target->panels.begin(), target->panels.end(), panel) - target->panels.begin();
    if (index > at) --index;
    if (beside == panel) beside = target->panels[at == 0 ? 1 : 0];
  }
  if (from != nullptr) take_out(*from, panel);
  target = find_panel(out, beside);
  if (!place.side) {
    put_into(*target, panel, index);
  } else {
    Tile rest = std::move(*target);
    *target = split_off(panel, std::move(rest), *place.side, 0.5F);
  }
  reveal(out, panel);
  return whole(std::move(out));
}

Tile moved(const Tile& root, PanelId panel, Side side) {
  Tile out = root;
  const std::vector<PlacedTile> places = places_of(out);
  const auto own = std::find_if(places.begin(), places.end(), [&](const PlacedTile& one) { return holds(one, panel); });
  if (own == places.end()) return out;
  const PlacedTile* best = nullptr;
  for (const PlacedTile& other : places) {
    const float shared = touch(own->rect, other.rect, side);
    if (shared > 0.0F && (best == nullptr || shared > touch(own->rect, best->rect, side))) best = &other;
  }
  if (best != nullptr) {
    const PanelId beside = best->tile->panels[static_cast<std::size_t>(best->tile->active)];
    return dropped(root, panel, {beside, {}, -1});
  }
  const bool spans = kind_of(side) == Kind::kRow ? own->rect.height() > 0.999F : own->rect.width() > 0.999F;
  if (own->tile->panels.size() == 1 && spans) return out;
  take_out(*find_panel(out, panel), panel);
  return whole(split_off(panel, std::move(out), side, kEdgeShare));
}

Tile closed(const Tile& root, PanelId panel) {
  Tile out = root;
  Tile* tile = find_panel(out, panel);
  if (tile == nullptr || panels_of(out).size() == 1) return out;
  take_out(*tile, panel);
  return whole(std::move(out));
}

Tile opened(const Tile& root, PanelId panel, const Tile& home) {
  Tile out = root;
  if (Tile* tile = find_panel(out, panel)) {
    const auto at = std::find(tile->panels.begin(), tile->panels.end(), panel) - tile->panels.begin();
    tile->active = static_cast<int>(at);
    reveal(out, panel);
    return out;
  }
  const std::vector<PanelId> open = panels_of(out);
  PanelId beside = open.front();
  if (const Tile* group = find_panel(home, panel)) {
    const auto friendly = std::find_if(group->panels.begin(), group->panels.end(), [&](PanelId other) {
      return std::find(open.begin(), open.end(), other) != open.end();
    });
    if (friendly != group->panels.end()) beside = *friendly;
  }
  return dropped(out, panel, {beside, {}, -1});
}

Tile with_side_toggled(const Tile& root, Side side) {
  Tile out = root;
  if (out.kind != Kind::kRow || out.children.size() < 2) return out;
  Tile& child = side == Side::kLeft ? out.children.front() : out.children.back();
  child.hidden = !child.hidden;
  const bool any = std::any_of(out.children.begin(), out.children.end(), [](const Tile& one) { return !one.hidden; });
  return any ? out : root;
}

Tile equalised(const Tile& root, PanelId panel) {
  Tile out = root;
  if (Tile* parent = parent_of(out, panel)) {
    std::fill(parent->shares.begin(), parent->shares.end(), 1.0F / static_cast<float>(parent->shares.size()));
  }
  return out;
}

}  // namespace trocar::ui
