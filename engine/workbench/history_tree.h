/// The shape of the history: which node follows which, and where redo leads. No documents in it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "engine/core/result.h"

namespace trocar::workbench {

/// A node of the history tree.
struct HistoryNode {
  std::int64_t id = 0;
  std::int64_t parent = 0;
  std::string name;
  std::string description;
  std::string time;
};

/// Node 0, the empty project, is always there and not in `nodes()`. Threads: one at a time.
class HistoryTree {
 public:
  /// Redo of the parent now leads to it. Errors: kCorrupt for an id that does not grow or an unknown parent.
  Status add(HistoryNode node);
  bool contains(std::int64_t id) const { return id == 0 || index_.contains(id); }
  /// Precondition (here and below): `contains(id)`.
  std::int64_t parent(std::int64_t id) const;
  int depth(std::int64_t id) const;
  /// The child last added, or last set.
  std::optional<std::int64_t> redo(std::int64_t id) const;
  /// Returns false if redo led there already. Precondition: `parent(child) == parent`.
  bool set_redo(std::int64_t parent, std::int64_t child);
  /// From `ancestor` (left out) down to `id`; empty if it is no ancestor or the same.
  std::vector<std::int64_t> path(std::int64_t ancestor, std::int64_t id) const;
  /// The id of the newest node, 0 if there is none.
  std::int64_t newest() const { return nodes_.empty() ? 0 : nodes_.back().id; }
  /// By increasing id.
  const std::vector<HistoryNode>& nodes() const { return nodes_; }

 private:
  std::vector<HistoryNode> nodes_;
  std::vector<int> depths_;
  std::unordered_map<std::int64_t, std::size_t> index_;
  std::unordered_map<std::int64_t, std::int64_t> redo_;
};

}  // namespace trocar::workbench
