#include "engine/workbench/history_graph.h"

#include <algorithm>
#include <array>
#include <optional>
#include <unordered_map>

namespace trocar::workbench {
namespace {

/// Which point each lane waits for on its way down; nothing: it is free.
class Lanes {
 public:
  /// The lanes that wait for `node`, as bits; they are free afterwards.
  std::uint16_t take(std::int64_t node) {
    std::uint16_t taken = 0;
    for (std::size_t i = 0; i < waits_.size(); ++i) {
      if (waits_[i].empty() || std::find(waits_[i].begin(), waits_[i].end(), node) == waits_[i].end()) continue;
      std::erase(waits_[i], node);
      taken = static_cast<std::uint16_t>(taken | 1U << i);
    }
    return taken;
  }
  void wait(int lane, std::int64_t node) { waits_[static_cast<std::size_t>(lane)].push_back(node); }
  std::uint16_t busy() const {
    std::uint16_t lanes = 0;
    for (std::size_t i = 0; i < waits_.size(); ++i) {
      if (!waits_[i].empty()) lanes = static_cast<std::uint16_t>(lanes | 1U << i);
    }
    return lanes;
  }
  /// The first free lane beside the main one; the last one if all are taken.
  int free() const {
    for (int i = 1; i < kMostLanes; ++i) {
      if (waits_[static_cast<std::size_t>(i)].empty()) return i;
    }
    return kMostLanes - 1;
  }

 private:
  /// Only the last lane waits for several.
  std::array<std::vector<std::int64_t>, kMostLanes> waits_;
};

/// The nodes on HEAD's line: those before it, and the newest way on from it.
struct Line {
  std::vector<bool> done;
  std::vector<bool> ahead;
};

Line line_of(const std::vector<HistoryNode>& nodes, const std::unordered_map<std::int64_t, std::size_t>& places,
             std::int64_t head) {
  Line line{std::vector<bool>(nodes.size()), std::vector<bool>(nodes.size())};
  for (auto at = places.find(head); at != places.end(); at = places.find(nodes[at->second].parent)) {
    line.done[at->second] = true;
  }
  std::unordered_map<std::int64_t, std::size_t> newest_child;
  for (std::size_t i = 0; i < nodes.size(); ++i) newest_child[nodes[i].parent] = i;
  for (auto at = newest_child.find(head); at != newest_child.end(); at = newest_child.find(nodes[at->second].id)) {
    line.ahead[at->second] = true;
  }
  return line;
}

int lowest(std::uint16_t lanes) {
  int lane = 0;
  while ((lanes >> lane & 1U) == 0) ++lane;
  return lane;
}

}  // namespace

std::vector<HistoryRow> history_graph(const std::vector<HistoryNode>& nodes, std::int64_t head) {
  std::unordered_map<std::int64_t, std::size_t> places;
  for (std::size_t i = 0; i < nodes.size(); ++i) places[nodes[i].id] = i;
  const Line line = line_of(nodes, places, head);
  Lanes lanes;
  std::vector<HistoryRow> rows;
  rows.reserve(nodes.size() + 1);
  for (std::size_t left = nodes.size(); left-- > 0;) {
    HistoryRow row;
    row.node = nodes[left].id;
    row.parent = nodes[left].parent;
    row.index = left;
    row.done = line.done[left];
    row.ahead = line.ahead[left];
    row.above = lanes.busy();
    row.joins = lanes.take(row.node);
    const bool main = row.done || row.ahead;
    row.lane = main ? 0 : (row.joins != 0 ? lowest(row.joins) : lanes.free());
    lanes.wait(row.lane, row.parent);
    row.below = lanes.busy();
    rows.push_back(row);
  }
  HistoryRow root;
  root.above = lanes.busy();
  root.joins = root.above;
  root.done = true;
  rows.push_back(root);
  return rows;
}

}  // namespace trocar::workbench
