/// One tool as keys, mouse or stick drive it: where it is wished to be, sample by sample.
#pragma once

#include <deque>
#include <optional>

#include "engine/control/setpoint_limiter.h"
#include "engine/trial/hand_event.h"

namespace trocar::trial {

/// The jaws as `ToggleJaw` opens and shuts them.
constexpr double kHandOpen_rad = 0.30;
constexpr double kHandGrip_rad = -0.20;
/// No tip is wished to be below this height over the board.
constexpr double kFloor_m = 0.0005;

/// Threads: one at a time. Stepped at 200 Hz.
class ToolHand {
 public:
  /// Wishes for `start` until it is told otherwise; in step mode for the middle of the cell that it is in.
  ToolHand(HandMode mode, const control::ToolCommand& start);

  void drive(const Eigen::Vector3d& v_WT, const Eigen::Vector3d& w_WT_T);
  /// No effect while 8 steps wait.
  void step(const Eigen::Vector3d& cells);
  void shift(const Eigen::Vector3d& by_W_m);
  void place(const spatial::Pose& X_WT);
  void toggle_jaw();
  /// While it is down nothing moves the tool but its jaws.
  void hold_clutch(bool down);
  void go();
  /// The tool is led to a place over as long as that takes, whatever the mode.
  void lead_to(const control::ToolCommand& place);

  /// The wish for the next sample.
  control::ToolCommand next();
  /// The arm did not follow and stays at `setpoint`; so does the wish.
  void stay_at(const control::ToolCommand& setpoint);

  /// A wish below the floor was lifted onto it.
  bool at_floor() const { return at_floor_; }
  /// The way that was begun is not over.
  bool under_way() const { return !goals_.empty(); }
  /// Where `go` leads; nothing if that is where the tool is, and in other modes.
  std::optional<spatial::Pose> waypoint() const;

 private:
  /// A place on the way, and in how many samples it is reached.
  struct Goal {
    spatial::Pose X_WT;
    int samples = 1;
  };

  /// The wish goes to `place_` once it has been where it is going now.
  void add_goal();
  void follow_goals();
  void follow_speed();
  void keep_off_the_floor(spatial::Pose& X_WT);

  HandMode mode_;
  control::ToolCommand wish_;
  spatial::Pose place_;  ///< What the operator moves: the wish itself, or the waypoint.
  double jaw_goal_rad_;
  Eigen::Vector3d v_wanted_{0.0, 0.0, 0.0};
  Eigen::Vector3d w_wanted_T_{0.0, 0.0, 0.0};
  Eigen::Vector3d v_WT_{0.0, 0.0, 0.0};
  std::deque<Goal> goals_;
  spatial::Pose goal_from_;
  int goal_sample_ = 0;
  bool clutch_ = false;
  bool at_floor_ = false;
};

}  // namespace trocar::trial
