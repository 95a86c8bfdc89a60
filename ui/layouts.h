/// Layouts that are kept by name, and the way back through what was done to the tiles.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "ui/tile_tree.h"

namespace trocar::ui {

struct NamedLayout {
  std::string name;  ///< No two of a workspace have the same.
  Tile tree;
};

/// Whatever changes the tiles is one step once it has come to rest: a drag of a splitter as much as a reset. Which
/// panel is in front is no step. Forgotten when the window closes.
class LayoutHistory {
 public:
  /// Call each frame in which nothing is being dragged.
  void settle(Workspace workspace, const Tile& now);
  /// The layout before or after, which is from then on the settled one; nothing if there is none.
  std::optional<Tile> undo(Workspace workspace);
  std::optional<Tile> redo(Workspace workspace);

 private:
  struct Line {
    std::optional<Tile> settled;
    std::vector<Tile> past;  ///< Oldest first, at most 100.
    std::vector<Tile> future;
  };
  Line& line(Workspace workspace) { return lines_[static_cast<std::size_t>(workspace)]; }
  std::array<Line, kWorkspaceCount> lines_;
};

}  // namespace trocar::ui
