/// Keeps a tool's setpoint within speed, acceleration, angular rate and jaw rate: saturates, and says so.
#pragma once

#include <cstdint>

#include "engine/spatial/pose.h"

namespace trocar::control {

/// Where a tool is told to be.
struct ToolCommand {
  spatial::Pose X_WT;
  double jaw_rad = 0.0;
};

/// Finite, and turned by a unit quaternion.
bool well_formed(const ToolCommand& command);

struct MotionLimits {
  double speed_m_s = 0.25;
  double acceleration_m_s2 = 8.0;
  double angular_rad_s = 4.0;
  double jaw_rad_s = 8.0;
};

/// Which limits a command would have exceeded; the command was moved to the limit.
struct LimitReport {
  bool speed = false;
  bool acceleration = false;
  bool angular = false;
  bool jaw = false;
  bool invalid = false;  ///< Not finite or not a rotation: dropped, the old setpoint stays.

  bool any() const { return speed || acceleration || angular || jaw || invalid; }
};

struct LimitedCommand {
  ToolCommand command;
  LimitReport report;
};

/// Threads: one at a time. A command within the limits passes through bit for bit.
class SetpointLimiter {
 public:
  /// Starts at rest at `start`. Precondition: all limits and `period_s` are positive.
  SetpointLimiter(const MotionLimits& limits, double period_s, const ToolCommand& start);

  /// The setpoint for the next period. A wish that is out of reach of the limits is approached along a straight line
  /// and braked in time.
  LimitedCommand next(const ToolCommand& wish) { return next(wish, period_s_); }
  /// The same for a period of another length, where one is cut short. Precondition: positive.
  LimitedCommand next(const ToolCommand& wish, double period_s);
  /// The setpoint for the next period where nobody wishes for anything: brakes within the limits and stands.
  ToolCommand brake() { return brake(period_s_); }
  ToolCommand brake(double period_s);
  /// Metres a second: that of the last period.
  const Eigen::Vector3d& velocity() const { return v_WT_; }
  /// The last setpoint.
  const ToolCommand& setpoint() const { return setpoint_; }
  /// Starts again at rest, for instance where the arm refused the last setpoint.
  void restart(const ToolCommand& start);
  /// The last period was cut short: the tool has only come to `reached`, as fast as before.
  void rewind(const ToolCommand& reached);
  /// Periods in which any limit was hit.
  std::int64_t hits() const { return hits_; }

 private:
  Eigen::Vector3d next_position(const Eigen::Vector3d& wish, double period_s, LimitReport& report);

  MotionLimits limits_;
  double period_s_;
  ToolCommand setpoint_;
  Eigen::Vector3d last_wish_;
  Eigen::Vector3d v_WT_{0.0, 0.0, 0.0};
  std::int64_t hits_ = 0;
};

}  // namespace trocar::control
