/// Where the parts of a tool are that can hit something.
#pragma once

#include <array>
#include <string_view>

#include "engine/kinematics/psm.h"
#include "engine/review/convex.h"

namespace trocar::review {

enum class Part : std::uint8_t { kShaft, kWrist, kJaw0, kJaw1 };
constexpr std::size_t kPartCount = 4;
/// "shaft", "wrist", "jaws".
std::string_view to_string(Part part);

/// The simulation's shapes, by `Part`.
using ToolShape = std::array<RoundedBox, kPartCount>;

/// Of a tool whose tip is at X_WT, the jaws opened by half of `jaw_rad` each. Also for poses beyond the joints' limits:
/// the wrist then bends as far as it must. Precondition: finite and of unit length.
ToolShape tool_shape(const kinematics::PsmModel& model, const spatial::Pose& X_WT, double jaw_rad);

}  // namespace trocar::review
