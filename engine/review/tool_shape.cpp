#include "engine/review/tool_shape.h"

#include <algorithm>
#include <cmath>

#include "engine/kinematics/chain.h"
#include "engine/simulation/shapes.h"

namespace trocar::review {
namespace {

using Eigen::Vector3d;
using kinematics::kTipFromWrist_m;

/// The wrist-pitch joint: the arm bends the less of the two ways in which it could get to the wrist.
Vector3d wrist_pitch(const Vector3d& remote_centre, const Vector3d& p_WY, const Vector3d& hinge) {
  const Vector3d from_centre = p_WY - remote_centre;
  const Vector3d across = from_centre - hinge * hinge.dot(from_centre);
  const double distance = across.norm();
  if (!(distance > 1e-9)) return p_WY;
  return p_WY - kinematics::kWrist_m / distance * across;
}

/// As `simulation::jaw_pose`, from the sine and cosine of a jaw's angle.
RoundedBox jaw(const Vector3d& p_WY, const Eigen::Matrix3d& R_WT, double side, double cosine, double sine) {
  RoundedBox box;
  const Vector3d y = R_WT.col(1);
  const Vector3d z = R_WT.col(2);
  box.R.col(0) = R_WT.col(0);
  box.R.col(1) = cosine * y - side * sine * z;
  box.R.col(2) = cosine * z + side * sine * y;
  box.half_m = 0.5 * Vector3d(simulation::kJawWidth_m, simulation::kJawThickness_m, kTipFromWrist_m);
  box.p = p_WY + side * box.half_m.y() * box.R.col(1) + box.half_m.z() * box.R.col(2);
  return box;
}

}  // namespace

std::string_view to_string(Part part) {
  switch (part) {
    case Part::kShaft:
      return "shaft";
    case Part::kWrist:
      return "wrist";
    case Part::kJaw0:
    case Part::kJaw1:
      return "jaws";
  }
  return "tool";
}

ToolShape tool_shape(const kinematics::PsmModel& model, const spatial::Pose& X_WT, double jaw_rad) {
  const Eigen::Matrix3d R_WT = X_WT.rotation();
  const Vector3d p_WY = X_WT.p - kTipFromWrist_m * R_WT.col(2);
  const Vector3d pitch = wrist_pitch(model.X_WB.p, p_WY, R_WT.col(0));
  const double half_rad = 0.5 * std::max(jaw_rad, 0.0);
  const double cosine = std::cos(half_rad);
  const double sine = std::sin(half_rad);
  return {capsule(model.X_WB.p, pitch, simulation::kShaftRadius_m), capsule(pitch, p_WY, simulation::kWristRadius_m),
          jaw(p_WY, R_WT, 1.0, cosine, sine), jaw(p_WY, R_WT, -1.0, cosine, sine)};
}

}  // namespace trocar::review
