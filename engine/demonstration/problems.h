/// What is wrong, odd or worth knowing about a demonstration, each with its place and, where there is one, a fix.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "engine/demonstration/demonstration.h"
#include "engine/spatial/grid.h"

namespace trocar::demonstration {

enum class ProblemKind {
  kNotFinite,     ///< "not-finite"
  kTime,          ///< "time": a gap, or time that stands still
  kQuaternion,    ///< "quaternion": not of unit length
  kLattice,       ///< "lattice": segment A or C outside of the learning cube
  kWorkspace,     ///< "workspace": a tool, or where it is told to be, outside of where the arms work
  kSpeed,         ///< "speed"
  kAcceleration,  ///< "acceleration"
  kJerk,          ///< "jerk"
  kSegments,      ///< "segments": one is missing, out of order, or a stretch has no label
  kIdle,          ///< "idle": an end in which nothing moves
  kJaw,           ///< "jaw": closed on nothing, handed over without both arms holding, or beyond its limits
  kCollision,     ///< "collision": a tool goes into something
  kClearance,     ///< "clearance": a tool passes too near to something
  kJoint,         ///< "joint": a setpoint is beyond a joint's limit
  kSafeSet,       ///< "safe-set": a segment leaves the cells that a model knows
  kEnds,          ///< "ends": the transfer begins or ends elsewhere than it should
};
std::string_view to_string(ProblemKind kind);

enum class Severity {
  kInfo,     ///< Worth knowing.
  kWarning,  ///< Will probably teach something that is not wanted.
  kError,    ///< Must not be learned from.
};
std::string_view to_string(Severity severity);

struct Problem {
  ProblemKind kind = ProblemKind::kTime;
  Severity severity = Severity::kInfo;
  double begin_s = 0.0;  ///< Of the demonstration.
  double end_s = 0.0;
  std::string message;  ///< One sentence without a full stop.
  std::string fix;      ///< An edit as `trocar demo edit` takes it: "trim --from 0.40 --to 12.30"; empty: none.
  int arm = -1;         ///< 0 left, 1 right, −1 both or neither.
  std::string id{};     ///< "speed-2", unique in a review; empty before.
};

/// What a tool may do; the values of the guard of the simulated arms, and the jerk of reaching its acceleration in
/// 20 ms.
struct MotionBounds {
  double speed_m_s = 0.25;
  double acceleration_m_s2 = 8.0;
  double jerk_m_s3 = 400.0;
};

/// Of what lies between the gates, by time; only what samples and labels alone tell. All problems, fixes included, are
/// in `review::Reviewer`. Neighbouring samples with the same problem are one entry.
std::vector<Problem> problems(const Demonstration& document, const spatial::Grid& grid,
                              const MotionBounds& bounds = {});

}  // namespace trocar::demonstration
