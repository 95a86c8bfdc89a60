/// Whether an edited demonstration still works: its setpoints drive the simulator from the recording's own world.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>

#include "engine/core/progress.h"
#include "engine/core/result.h"
#include "engine/demonstration/demonstration.h"

namespace trocar::review {

/// Times are of the demonstration, in seconds.
struct Resimulation {
  demonstration::Outcome outcome = demonstration::Outcome::kUnfinished;  ///< As the task judges it.
  bool placed = false;                 ///< At the end the block is seated on its goal peg, both grippers open.
  bool lifted = false;                 ///< The left arm held the block clear of the board.
  std::optional<double> decided_at_s;  ///< When it was handed over or found dropped.
  double last_touch_s = 0.0;           ///< When an arm touched the block for the last time before that, or at all.
  int last_arm = -1;                   ///< Which one: 0 left, 1 right, −1 none ever.
  Eigen::Vector3d last_p_WK{0, 0, 0};  ///< Where the block was then, in W, metres.
  double from_goal_m = 0.0;            ///< Across the board, of the block at the end from the goal peg.
  int refused = 0;                     ///< Samples whose setpoint an arm could not reach and held instead.
  bool transferred() const { return outcome == demonstration::Outcome::kSuccess && placed; }
  std::string sentence;  ///< All that, for people, without a full stop.
};

/// All samples up to the end gate are driven, also those before the begin gate, as the world is that before the first.
/// The arms are led to the first setpoint if it is elsewhere than they are, and hold for a moment after the last.
/// Errors: kInvalidArgument if the recording has no initial world, as imports, or names no block or goal; those of
/// `simulation::World::restore`; kCancelled.
Result<Resimulation> resimulate(const demonstration::Demonstration& document, Progress& progress);

}  // namespace trocar::review
