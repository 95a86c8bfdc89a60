/// The seam to an arm, simulated or physical: a setpoint of pose and jaw in, a stamped measured state out. Names and
/// meanings are CRTK's; nothing of a simulator or of ROS is in it.
#pragma once

#include <cstdint>
#include <string_view>

#include "engine/control/setpoint_limiter.h"
#include "engine/core/result.h"
#include "engine/core/tick.h"

namespace trocar::control {

enum class OperatingState : std::uint8_t { kDisabled, kEnabled, kPaused, kFault };
/// "DISABLED" …
std::string_view to_string(OperatingState state);

/// What an arm says of itself.
struct ArmFeedback {
  Tick stamp;                 ///< When it was measured.
  spatial::Pose measured_cp;  ///< X_WT.
  double measured_jaw_rad = 0.0;
  OperatingState operating_state = OperatingState::kDisabled;
  bool homed = false;
  bool busy = false;
};

/// Threads: one at a time.
class Arm {
 public:
  virtual ~Arm() = default;
  virtual ArmFeedback feedback() const = 0;
  /// Where the arm was last told to be.
  virtual ToolCommand setpoint_cp() const = 0;
  /// `servo_cp` and the jaw's `servo_jp` in one. Errors: kOutOfReach, kInvalidArgument; the old setpoint then stays.
  virtual Status servo_cp(const ToolCommand& setpoint) = 0;
  /// Whether the arm could be there, without going. Errors: kOutOfReach naming the joint.
  virtual Status reaches(const spatial::Pose& X_WT) const = 0;
};

}  // namespace trocar::control
