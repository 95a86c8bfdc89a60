#include "ui/layouts.h"

#include <utility>

namespace trocar::ui {
namespace {

constexpr std::size_t kMostSteps = 100;

std::optional<Tile> step(std::optional<Tile>& settled, std::vector<Tile>& from, std::vector<Tile>& to) {
  if (from.empty() || !settled) return {};
  to.push_back(std::move(*settled));
  settled = std::move(from.back());
  from.pop_back();
  return settled;
}

}  // namespace

void LayoutHistory::settle(Workspace workspace, const Tile& now) {
  Line& own = line(workspace);
  if (own.settled && same_places(*own.settled, now)) return;
  if (own.settled) {
    own.past.push_back(std::move(*own.settled));
    if (own.past.size() > kMostSteps) own.past.erase(own.past.begin());
    own.future.clear();
  }
  own.settled = now;
}

std::optional<Tile> LayoutHistory::undo(Workspace workspace) {
  Line& own = line(workspace);
  return step(own.settled, own.past, own.future);
}

std::optional<Tile> LayoutHistory::redo(Workspace workspace) {
  Line& own = line(workspace);
  return step(own.settled, own.future, own.past);
}

}  // namespace trocar::ui
