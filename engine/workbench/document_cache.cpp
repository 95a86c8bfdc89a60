#include "engine/workbench/document_cache.h"

#include <algorithm>
#include <functional>
#include <unordered_set>
#include <utility>
#include <vector>

namespace trocar::workbench {
namespace {

/// As many documents as are kept do not reach the budget if none has a demonstration longer than this.
constexpr std::size_t kSmall_samples = 50'000;

/// Adds up what documents hold, each block of samples once.
class Weigher {
 public:
  /// Bytes of samples that no document before held.
  std::size_t add(const Project& project) {
    std::size_t bytes = 0;
    for (const auto& [id, document] : project.demonstrations) {
      if (!documents_.insert(document.get()).second) continue;
      const auto weigh = [&](const demonstration::SampleBlock& block) {
        if (blocks_.insert(&block).second) bytes += block.bytes();
      };
      document->samples.visit_blocks(weigh);
      document->recorded.visit_blocks(weigh);
    }
    return bytes;
  }

 private:
  std::unordered_set<const demonstration::Demonstration*> documents_;
  std::unordered_set<const demonstration::SampleBlock*> blocks_;
};

}  // namespace

std::shared_ptr<const Project> DocumentCache::find(std::int64_t node) {
  if (node == 0) return empty_;
  const auto found = kept_.find(node);
  if (found == kept_.end()) return nullptr;
  found->second.used = ++clock_;
  return found->second.document;
}

void DocumentCache::keep(std::int64_t node, std::shared_ptr<const Project> document, For how) {
  Kept& kept = kept_[node];
  // What is kept for good stays so.
  if (!kept.document || how == For::kGood) kept.how = how;
  kept.document = std::move(document);
  kept.used = ++clock_;
  const auto& all = kept.document->demonstrations;
  large_ = large_ || std::any_of(all.begin(), all.end(),
                                 [](const auto& each) { return each.second->samples.size() > kSmall_samples; });
}

void DocumentCache::bound(const Project& shown) {
  std::vector<std::pair<std::uint64_t, std::int64_t>> by_use;
  by_use.reserve(kept_.size());
  for (const auto& [node, kept] : kept_) by_use.emplace_back(kept.used, node);
  std::sort(by_use.begin(), by_use.end(), std::greater<>());
  Weigher weigher;
  if (large_) weigher.add(shown);
  std::size_t bytes = 0;
  std::size_t recent = 0;
  std::size_t all = 0;
  for (const auto& [used, node] : by_use) {
    const auto place = kept_.find(node);
    bool stays = ++all <= kMostDocuments;
    if (stays && place->second.how == For::kAWhile) stays = ++recent <= kRecentDocuments;
    if (stays && large_) {
      bytes += weigher.add(*place->second.document);
      stays = bytes <= budget_bytes_;
    }
    if (!stays) kept_.erase(place);
  }
}

}  // namespace trocar::workbench
