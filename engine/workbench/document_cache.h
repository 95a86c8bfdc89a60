/// Documents at points of the history, so that going there applies few edits or none.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <unordered_map>

#include "engine/workbench/project.h"

namespace trocar::workbench {

/// What kept documents may hold of samples beside those of the document that is shown: an edit of all of an hour at
/// 200 Hz takes about 100 MB.
constexpr std::size_t kDocumentBudget_bytes = std::size_t{128} << 20U;
/// Neighbours in the history that are kept, so that undo and redo of a heavy edit do not make it again.
constexpr std::size_t kRecentDocuments = 16;
/// A history of 60,000 edits has as many that are kept for good.
constexpr std::size_t kMostDocuments = 1024;

/// Threads: one at a time.
class DocumentCache {
 public:
  enum class For {
    kGood,    ///< A way station on long ways: goes only when there is no room.
    kAWhile,  ///< One of the last `kRecentDocuments`.
  };

  explicit DocumentCache(std::size_t budget_bytes = kDocumentBudget_bytes) : budget_bytes_(budget_bytes) {}

  /// Null if it is not there; of the root of the history, 0, it always is.
  std::shared_ptr<const Project> find(std::int64_t node);
  bool contains(std::int64_t node) const { return node == 0 || kept_.contains(node); }
  void keep(std::int64_t node, std::shared_ptr<const Project> document, For how);
  /// Lets go of what was used longest ago until the budgets are met. `shown` costs nothing, as it is there anyway.
  void bound(const Project& shown);
  std::size_t count() const { return kept_.size(); }

 private:
  struct Kept {
    std::shared_ptr<const Project> document;
    For how = For::kAWhile;
    std::uint64_t used = 0;
  };
  const std::size_t budget_bytes_;
  std::shared_ptr<const Project> empty_ = std::make_shared<const Project>();
  std::unordered_map<std::int64_t, Kept> kept_;
  std::uint64_t clock_ = 0;
  bool large_ = false;  ///< Documents are worth weighing.
};

}  // namespace trocar::workbench
