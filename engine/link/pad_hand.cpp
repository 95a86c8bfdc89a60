#include "engine/link/pad_hand.h"

#include <algorithm>

#include "engine/control/tool_mapping.h"

namespace trocar::link {
namespace {

constexpr double kLongestStep_s = 0.05;
/// As fast as the simulated jaws go.
constexpr double kGrip_rad_s = 1.5;

Eigen::Quaterniond turned(const Eigen::Quaterniond& q, const Eigen::Vector3d& by) {
  if (by.norm() == 0.0) return q;
  return (Eigen::Quaterniond(Eigen::AngleAxisd(by.norm(), by.normalized())) * q).normalized();
}

}  // namespace

HandFrame PadHand::at(double t_s, const trial::GamepadLook& pad) {
  const double step_s = std::clamp(t_s - t_s_, 0.0, kLongestStep_s);
  t_s_ = t_s;
  // Sticks are looked at as if no tool were turned: what they say of turns is in W then.
  const std::array<Eigen::Quaterniond, 2> in_W{Eigen::Quaterniond::Identity(), Eigen::Quaterniond::Identity()};
  const Eigen::Quaterniond R_DW = control::display_rotation().conjugate();
  for (const trial::HandEvent& event : sticks_.look(trial::look_of(pad), {true, true}, in_W)) {
    if (const auto* drive = std::get_if<trial::DriveTool>(&event)) {
      Arm& arm = arms_[kinematics::index_of(drive->arm)];
      arm.v_D = R_DW * drive->v_WT / scale_;
      arm.w_D = R_DW * drive->w_WT_T;
    } else if (const auto* jaw = std::get_if<trial::ToggleJaw>(&event)) {
      double& goal_rad = arms_[kinematics::index_of(jaw->arm)].grip_goal_rad;
      goal_rad = goal_rad == trial::kHandOpen_rad ? trial::kHandGrip_rad : trial::kHandOpen_rad;
    } else if (const auto* clutch = std::get_if<trial::HoldClutch>(&event)) {
      pedals_.clutch_pedal = clutch->down;
      pedals_.clutch_presses += clutch->down ? 1 : 0;
    } else if (const auto* agent = std::get_if<trial::HoldAgentPedal>(&event)) {
      pedals_.agent_pedal = agent->down;
      pedals_.agent_presses += agent->down ? 1 : 0;
    }
  }
  for (Arm& arm : arms_) {
    // While the clutch is held the hand rests: it has no reach that would have to be won back.
    if (!pedals_.clutch_pedal) {
      arm.hand.X_DH.p += step_s * arm.v_D;
      arm.hand.X_DH.q = turned(arm.hand.X_DH.q, step_s * arm.w_D);
    }
    const double most_rad = step_s * kGrip_rad_s;
    arm.hand.grip_rad += std::clamp(arm.grip_goal_rad - arm.hand.grip_rad, -most_rad, most_rad);
  }
  HandFrame frame = pedals_;
  frame.left = arms_[0].hand;
  frame.right = arms_[1].hand;
  return frame;
}

}  // namespace trocar::link
