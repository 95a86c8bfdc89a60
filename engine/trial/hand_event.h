/// What an operator does to the tools in the simulator, whatever device it comes from, as a stream in order.
#pragma once

#include <cstdint>
#include <variant>

#include "engine/kinematics/psm.h"
#include "engine/spatial/pose.h"

namespace trocar::trial {

/// How the operator's wishes become motion.
enum class HandMode : std::uint8_t {
  kContinuous,  ///< The tool moves as long as it is told to.
  kStep,        ///< The tool goes from cell to cell of the lattice, one at a time.
  kWaypoint,    ///< A pose is set first; the tool goes there when told to.
};

/// From now on the tool moves at that speed; zero stops it.
struct DriveTool {
  kinematics::ArmSide arm = kinematics::ArmSide::kLeft;
  Eigen::Vector3d v_WT{0.0, 0.0, 0.0};    ///< m/s.
  Eigen::Vector3d w_WT_T{0.0, 0.0, 0.0};  ///< rad/s, about the tool's own axes.
};
/// By `cells` of the lattice along the axes of W, to the middle of a cell.
struct StepTool {
  kinematics::ArmSide arm = kinematics::ArmSide::kLeft;
  Eigen::Vector3d cells{0.0, 0.0, 0.0};
};
/// By so much, in W; what a mouse does.
struct ShiftTool {
  kinematics::ArmSide arm = kinematics::ArmSide::kLeft;
  Eigen::Vector3d by_W_m{0.0, 0.0, 0.0};
};
/// Sets the waypoint of `kWaypoint`, or where the tool is wished to be.
struct PlaceTool {
  kinematics::ArmSide arm = kinematics::ArmSide::kLeft;
  spatial::Pose X_WT;
};
/// Opens the jaws if they are shut, else shuts them.
struct ToggleJaw {
  kinematics::ArmSide arm = kinematics::ArmSide::kLeft;
};
struct HoldClutch {
  bool down = false;
};
/// The left pedal of a trial: the agent may move while it is down.
struct HoldAgentPedal {
  bool down = false;
};
/// To the waypoints that are set, by minimum jerk.
struct GoToWaypoint {};

struct PauseTake {
  bool paused = true;
};
/// Ends the countdown at once.
struct BeginTake {};
struct EndTake {};

using HandEvent = std::variant<DriveTool, StepTool, ShiftTool, PlaceTool, ToggleJaw, HoldClutch, HoldAgentPedal,
                               GoToWaypoint, PauseTake, BeginTake, EndTake>;

}  // namespace trocar::trial
