#include "engine/control/tool_mapping.h"

#include <algorithm>
#include <cmath>

#include "engine/peg_board/peg_board.h"

namespace trocar::control {

void ToolMapping::engage(const spatial::Pose& X_DH, const spatial::Pose& X_WT) {
  hand_at_engagement_ = X_DH;
  tool_at_engagement_ = X_WT;
  output_ = X_WT;
  // The offset multiplies the hand from the right: on the left it would be a rotation of the world, not of the tool.
  R_HT_ = (R_WD_ * X_DH.q).conjugate() * X_WT.q;
  engaged_ = true;
}

void ToolMapping::set_scale(double scale, const spatial::Pose& X_DH) {
  const bool follows = engaged_;
  if (follows) map(X_DH);
  scale_ = std::clamp(scale, kSmallestScale, kLargestScale);
  if (follows) engage(X_DH, output_);
}

spatial::Pose ToolMapping::map(const spatial::Pose& X_DH) {
  if (!engaged_) return output_;
  output_.p = tool_at_engagement_.p + scale_ * (R_WD_ * (X_DH.p - hand_at_engagement_.p));
  output_.q = (R_WD_ * X_DH.q * R_HT_).normalized();
  return output_;
}

Eigen::Quaterniond display_rotation() {
  const double pitch_rad = peg_board::paper_camera().pitch_rad;
  const Eigen::Vector3d right_W = Eigen::Vector3d::UnitY();
  const Eigen::Vector3d towards_W{std::cos(pitch_rad), 0.0, -std::sin(pitch_rad)};
  Eigen::Matrix3d R_WD;
  R_WD << right_W, towards_W.cross(right_W), towards_W;
  return Eigen::Quaterniond(R_WD).normalized();
}

}  // namespace trocar::control
