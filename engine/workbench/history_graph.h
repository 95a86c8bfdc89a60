/// The history as a tree on paper: a row for each point, newest first, and the lines between them.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/workbench/history_tree.h"

namespace trocar::workbench {

/// Lanes beyond this one are drawn as it; there is no more room.
constexpr int kMostLanes = 12;

struct HistoryRow {
  std::int64_t node = 0;
  std::int64_t parent = 0;
  std::size_t index = 0;    ///< Into the history; meaningless of node 0.
  int lane = 0;             ///< 0: the line that HEAD is on, up and down.
  std::uint16_t above = 0;  ///< Lanes (as bits) whose line enters this row from the one above it.
  std::uint16_t below = 0;  ///< Lanes whose line leaves it downwards.
  std::uint16_t joins = 0;  ///< Lanes that end at this row's point, coming from above.
  bool done = false;        ///< It is part of the document as it is: HEAD or before it.
  bool ahead = false;       ///< Redo leads there.
};

/// `nodes` by increasing id. The last row is node 0. Takes time by the length of the history.
std::vector<HistoryRow> history_graph(const std::vector<HistoryNode>& nodes, std::int64_t head);

}  // namespace trocar::workbench
