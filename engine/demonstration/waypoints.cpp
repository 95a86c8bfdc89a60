#include "engine/demonstration/waypoints.h"

#include <algorithm>
#include <cmath>
#include <variant>

namespace trocar::demonstration {
namespace {

/// True if what comes after it may lie at another time than before it.
bool moves_time(const Edit& edit) {
  if (const auto* bridge = std::get_if<Bridge>(&edit)) return bridge->peak_speed_m_s > 0.0;
  if (const auto* idle = std::get_if<TrimIdle>(&edit)) return idle->inside;
  if (const auto* span = std::get_if<DeleteSpan>(&edit)) return span->ripple;
  return std::holds_alternative<Splice>(edit) || std::holds_alternative<Retime>(edit) ||
         std::holds_alternative<SnapToGrid>(edit);
}

/// Left and right have changed places since.
bool swaps_arms(const Edit& edit) {
  return std::holds_alternative<Mirror>(edit);
}

template <typename Displacement>
Waypoint waypoint(const StackEntry& entry, const Displacement& edit) {
  return {entry.id, edit, edit.at_s, edit.arms};
}

template <typename Displacement>
std::optional<Waypoint> found(const Demonstration& document, const Displacement& wanted) {
  for (const Waypoint& known : waypoints_of(document)) {
    const bool same = std::holds_alternative<Displacement>(known.edit) && known.arms == wanted.arms;
    if (same && std::abs(known.at_s - wanted.at_s) < kSameInstant_s) return known;
  }
  return std::nullopt;
}

}  // namespace

std::vector<Waypoint> waypoints_of(const Demonstration& document) {
  std::vector<Waypoint> list;
  const EditStack& stack = *document.stack;
  for (auto entry = stack.rbegin(); entry != stack.rend(); ++entry) {
    if (!entry->enabled || !entry->conflict.empty()) continue;
    if (moves_time(*entry->edit) || swaps_arms(*entry->edit)) break;
    if (const auto* move = std::get_if<MoveTool>(entry->edit.get())) list.push_back(waypoint(*entry, *move));
    if (const auto* turn = std::get_if<RotateTool>(entry->edit.get())) list.push_back(waypoint(*entry, *turn));
  }
  const auto outside = [&](const Waypoint& w) {
    return w.at_s < document.begin_s - kSameInstant_s || w.at_s > document.end_s + kSameInstant_s;
  };
  list.erase(std::remove_if(list.begin(), list.end(), outside), list.end());
  std::stable_sort(list.begin(), list.end(), [](const Waypoint& a, const Waypoint& b) { return a.at_s < b.at_s; });
  return list;
}

std::optional<Waypoint> waypoint_at(const Demonstration& document, const MoveTool& move) {
  return found(document, move);
}

std::optional<Waypoint> waypoint_at(const Demonstration& document, const RotateTool& turn) {
  return found(document, turn);
}

}  // namespace trocar::demonstration
