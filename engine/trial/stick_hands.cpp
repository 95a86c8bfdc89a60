#include "engine/trial/stick_hands.h"

#include <algorithm>
#include <cmath>

namespace trocar::trial {
namespace {

using kinematics::ArmSide;
using kinematics::index_of;

constexpr double kSpeed_m_s = 0.060;
constexpr double kTurn_rad_s = 1.2;
constexpr double kFine = 0.2;
/// No stick rests exactly in its middle.
constexpr double kDeadZone = 0.15;
constexpr double kSpaceMouseFull = 350.0;

/// Nothing in the dead zone, from there on slowly and then faster, so that small ways can be gone too.
double shaped(double pushed) {
  if (!std::isfinite(pushed)) return 0.0;
  const double beyond = std::clamp((std::abs(pushed) - kDeadZone) / (1.0 - kDeadZone), 0.0, 1.0);
  return std::copysign(beyond * beyond, pushed);
}

Eigen::Vector3d shaped(const Eigen::Vector3d& pushed) {
  return {shaped(pushed.x()), shaped(pushed.y()), shaped(pushed.z())};
}

bool down(const GamepadLook& pad, int button) {
  return (pad.buttons >> static_cast<unsigned>(button) & 1U) != 0;
}

}  // namespace

StickLook look_of(const GamepadLook& pad) {
  const auto axis = [&pad](std::size_t i) { return static_cast<double>(pad.axes[i]); };
  StickLook look;
  look.move_W = {axis(1), axis(0), -axis(3)};
  look.turn_W = {0.0, 0.0, -axis(2)};
  look.jaw = down(pad, 0);
  look.clutch = down(pad, 1);
  look.agent = down(pad, 4);
  look.other_arm = down(pad, 3);
  look.fine = down(pad, 5);
  return look;
}

StickLook look_of_space_mouse(const std::array<int, 6>& axes, std::uint32_t buttons) {
  const auto axis = [&axes](std::size_t i) { return static_cast<double>(axes[i]) / kSpaceMouseFull; };
  StickLook look;
  // W: x towards the operator, y right, z up.
  look.move_W = {-axis(2), axis(0), axis(1)};
  look.turn_W = {-axis(5), axis(3), axis(4)};
  look.jaw = (buttons & 1U) != 0;
  look.other_arm = (buttons & 2U) != 0;
  return look;
}

std::vector<HandEvent> StickHands::look(const StickLook& now, const std::array<bool, 2>& drivable,
                                        const std::array<Eigen::Quaterniond, 2>& q_WT) {
  std::vector<HandEvent> events;
  const ArmSide other = arm_ == ArmSide::kLeft ? ArmSide::kRight : ArmSide::kLeft;
  const bool change = (now.other_arm && !last_.other_arm) || !drivable[index_of(arm_)];
  if (change && drivable[index_of(other)]) {
    if (sent_.v_WT.norm() + sent_.w_WT_T.norm() > 0.0) events.emplace_back(DriveTool{arm_, {0, 0, 0}, {0, 0, 0}});
    arm_ = other;
    sent_ = {};
  }
  const double share = now.fine ? kFine : 1.0;
  DriveTool drive{arm_, share * kSpeed_m_s * shaped(now.move_W), {0, 0, 0}};
  drive.w_WT_T = q_WT[index_of(arm_)].conjugate() * (share * kTurn_rad_s * shaped(now.turn_W));
  // A turned tool changes what the same push means, but one that is not pushed says nothing.
  if (drive.v_WT != sent_.v_WT || drive.w_WT_T != sent_.w_WT_T) {
    sent_ = drive;
    events.emplace_back(drive);
  }
  if (now.jaw && !last_.jaw) events.emplace_back(ToggleJaw{arm_});
  if (now.clutch != last_.clutch) events.emplace_back(HoldClutch{now.clutch});
  if (now.agent != last_.agent) events.emplace_back(HoldAgentPedal{now.agent});
  last_ = now;
  return events;
}

}  // namespace trocar::trial
