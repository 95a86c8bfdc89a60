/// From the operator's hand to the tool: scaled, clutched, without a jump (control, "Teleoperation mathematics").
#pragma once

#include "engine/spatial/pose.h"

namespace trocar::control {

/// The range that the menu offers.
constexpr double kSmallestScale = 0.1;
constexpr double kLargestScale = 0.5;

/// p = p₀ + s R_WD (m − m₀), R = R_m R_m0ᵀ R_p0, from the moment of engagement on, both hand rotations seen from W
/// (R_m = R_WD R_DH). The hand's frame D is the display: x right, y up, z towards the operator; R_WD turns it into the
/// board frame, so that a push to the right moves the tool right in the picture. Threads: one at a time.
class ToolMapping {
 public:
  explicit ToolMapping(const Eigen::Quaterniond& R_WD, double scale = 0.2) : R_WD_(R_WD), scale_(scale) {}

  /// Begins to follow: the hand at X_DH now means the tool's setpoint X_WT.
  void engage(const spatial::Pose& X_DH, const spatial::Pose& X_WT);
  void release() { engaged_ = false; }
  bool engaged() const { return engaged_; }
  /// Clamped to 0.1 … 0.5; re-engages with the hand at X_DH where the tool is then, so nothing jumps.
  void set_scale(double scale, const spatial::Pose& X_DH);
  /// The tool's setpoint for this hand; the last one while released.
  spatial::Pose map(const spatial::Pose& X_DH);
  double scale() const { return scale_; }
  const Eigen::Quaterniond& R_WD() const { return R_WD_; }

 private:
  Eigen::Quaterniond R_WD_;
  double scale_;
  bool engaged_ = false;
  spatial::Pose hand_at_engagement_;
  spatial::Pose tool_at_engagement_;
  Eigen::Quaterniond R_HT_ = Eigen::Quaterniond::Identity();  ///< Offset of the tool from the hand, kept while engaged.
  spatial::Pose output_;
};

/// R_WD of the paper's camera: right is +y, up on the screen is mostly +z, towards the operator is mostly +x.
Eigen::Quaterniond display_rotation();

}  // namespace trocar::control
