#include "engine/workbench/history_tree.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "engine/core/check.h"

namespace trocar::workbench {

Status HistoryTree::add(HistoryNode node) {
  if (node.id <= newest() || !contains(node.parent)) {
    return fail(ErrorCode::kCorrupt, fmt::format("the history's entry {} does not fit its tree", node.id));
  }
  depths_.push_back(depth(node.parent) + 1);
  index_[node.id] = nodes_.size();
  redo_[node.parent] = node.id;
  nodes_.push_back(std::move(node));
  return {};
}

std::int64_t HistoryTree::parent(std::int64_t id) const {
  TROCAR_CHECK(contains(id));
  return id == 0 ? 0 : nodes_[index_.at(id)].parent;
}

int HistoryTree::depth(std::int64_t id) const {
  TROCAR_CHECK(contains(id));
  return id == 0 ? 0 : depths_[index_.at(id)];
}

std::optional<std::int64_t> HistoryTree::redo(std::int64_t id) const {
  const auto found = redo_.find(id);
  if (found == redo_.end()) return std::nullopt;
  return found->second;
}

bool HistoryTree::set_redo(std::int64_t parent_id, std::int64_t child) {
  TROCAR_CHECK(child != 0 && parent(child) == parent_id);
  return std::exchange(redo_[parent_id], child) != child;
}

std::vector<std::int64_t> HistoryTree::path(std::int64_t ancestor, std::int64_t id) const {
  std::vector<std::int64_t> nodes;
  for (; id != ancestor; id = parent(id)) {
    if (id == 0) return {};
    nodes.push_back(id);
  }
  std::reverse(nodes.begin(), nodes.end());
  return nodes;
}

}  // namespace trocar::workbench
