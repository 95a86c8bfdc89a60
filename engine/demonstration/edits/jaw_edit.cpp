// SetJaw: a gripper opens or closes.
#include <algorithm>
#include <cmath>

#include "engine/demonstration/edits/edit_functions.h"
#include "engine/demonstration/edits/stretch.h"
#include "engine/demonstration/jaw_limits.h"

namespace trocar::demonstration {

Result<Demonstration> made_by(const Demonstration& document, const SetJaw& edit) {
  if (!(edit.jaw_rad >= kJawLow_rad - kJawRounding_rad && edit.jaw_rad <= kJawHigh_rad + kJawRounding_rad)) {
    return fail(ErrorCode::kInvalidArgument, "a jaw opens from −40° to 80°");
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
