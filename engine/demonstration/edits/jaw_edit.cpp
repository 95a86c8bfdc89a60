// SetJaw: a gripper opens or closes.
#include <algorithm>
#include <cmath>

#include "engine/demonstration/edits/edit_functions.h"
#include "engine/demonstration/edits/stretch.h"

namespace trocar::demonstration {

Result<Demonstration> made_by(const Demonstration& document, const SetJaw& edit) {
  // The dVRK's large needle driver opens to 80° and can be closed beyond 0 to press.
  constexpr double kLowest_rad = -0.35;
  constexpr double kHighest_rad = 1.4;
  if (!(edit.jaw_rad >= kLowest_rad && edit.jaw_rad <= kHighest_rad)) {
    return fail(ErrorCode::kInvalidArgument, "a jaw opens from -20° to 80°");
  }
  if (!(edit.ramp_s >= 0.0) || edit.ramp_s > 60.0) {
    return fail(ErrorCode::kInvalidArgument, "the ramp must be a number from 0 to 60 s");
  }
  TROCAR_ASSIGN_OR_RETURN(Stretch stretch, stretch_of(document, edit.from_s, edit.to_s, 1));
  for (Sample& sample : stretch.samples) {
    const double t_s = document.time_of(sample);
    const double from_edge_s = std::min(t_s - edit.from_s, edit.to_s - t_s);
    const double share = edit.ramp_s > 0.0 ? std::clamp(from_edge_s / edit.ramp_s, 0.0, 1.0) : 1.0;
    for (const std::size_t arm : indices_of(edit.arms)) {
      ArmSample& moved = sample.arms[arm];
      moved.setpoint_jaw_rad += share * (edit.jaw_rad - moved.setpoint_jaw_rad);
      const auto jaw_rad = static_cast<double>(moved.jaw_rad);
      moved.jaw_rad = static_cast<float>(jaw_rad + share * (edit.jaw_rad - jaw_rad));
    }
  }
  return with_stretch(document, std::move(stretch));
}

}  // namespace trocar::demonstration
