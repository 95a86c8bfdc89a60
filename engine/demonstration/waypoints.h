/// Waypoints: the instants at which an expert has moved or turned a tool, where that can be changed again.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "engine/demonstration/demonstration.h"
#include "engine/demonstration/edit.h"

namespace trocar::demonstration {

/// Instants closer than this are one: half the time between two samples.
constexpr double kSameInstant_s = 0.0025;

struct Waypoint {
  std::int64_t entry = 0;  ///< Of the stack.
  Edit edit;               ///< A MoveTool or a RotateTool.
  double at_s = 0.0;       ///< Of the demonstration as it is shown.
  Arms arms = Arms::kLeft;
};

/// Those between the gates, by time. An entry that is switched off is none, nor is one whose instant a later edit has
/// moved in time.
std::vector<Waypoint> waypoints_of(const Demonstration& document);

/// The waypoint of the same kind and arms at an instant, if there is one: displacing the tool further changes it.
std::optional<Waypoint> waypoint_at(const Demonstration& document, const MoveTool& move);
std::optional<Waypoint> waypoint_at(const Demonstration& document, const RotateTool& turn);

}  // namespace trocar::demonstration
