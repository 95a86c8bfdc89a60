#include "engine/trial/human_hand.h"

#include <algorithm>
#include <cmath>

#include "engine/core/check.h"
#include "engine/demonstration/recording.h"
#include "engine/spatial/rotation.h"

namespace trocar::trial {
namespace {

constexpr double kPedal_s = 0.10;   ///< Foot down before the hand leaves, foot up before it pushes again.
constexpr double kReturn_s = 0.45;  ///< Hand back to where there is room.
constexpr double kTurnRate_rad_s = 1.2;
// After a clutch the hand lies this share of its reach on the other side, so that the next stroke is long.
constexpr double kReturnShare = 0.6;
// A stroke that could do less than this share of what is left is not worth beginning.
constexpr double kWorthwhile = 0.4;

int steps_of(double duration_s) {
  return std::max(1, static_cast<int>(std::lround(duration_s * demonstration::kSampleRate_hz)));
}

/// The largest share of `way` that stays within reach from `from`.
double share_within_reach(const Eigen::Vector3d& from, const Eigen::Vector3d& way) {
  double share = 1.0;
  for (int axis = 0; axis < 3; ++axis) {
    if (way[axis] == 0.0) continue;
    const double room = way[axis] > 0.0 ? kHandReach_m - from[axis] : kHandReach_m + from[axis];
    share = std::min(share, std::max(0.0, room) / std::abs(way[axis]));
  }
  return share;
}

}  // namespace

double minimum_jerk(double s) {
  const double t = std::clamp(s, 0.0, 1.0);
  return t * t * t * (10.0 + t * (-15.0 + 6.0 * t));
}

HumanHand::HumanHand(const SkillParameters& skill, const Random& random, const Eigen::Quaterniond& R_WD, double scale)
    : skill_(skill), random_(random), R_WD_(R_WD), scale_(scale), tremor_(skill.tremor_m, random.child(1)) {}

void HumanHand::begin(Phase phase, const Eigen::Vector3d& to, const Eigen::Quaterniond& q_to, double duration_s) {
  phase_ = phase;
  stroke_ = {hand_.p, to, hand_.q, q_to, steps_of(duration_s), 0};
}

Eigen::Vector3d HumanHand::noise(const Eigen::Vector3d& way_D) {
  const double length = way_D.norm();
  if (length == 0.0) return Eigen::Vector3d::Zero();
  const Eigen::Vector3d along = way_D / length;
  const double x = random_.normal();
  const double y = random_.normal();
  const double z = random_.normal();
  Eigen::Vector3d e{x, y, skill_.depth_weakness * z};
  // Larger along the way than across it.
  e = skill_.cross_noise * e + (1.0 - skill_.cross_noise) * along * along.dot(e);
  return skill_.aim_noise * length * e;
}

void HumanHand::move(const Intention& intention) {
  TROCAR_CHECK(!busy());
  const Eigen::Vector3d way_D = R_WD_.conjugate() * intention.way_W / scale_;
  const double share = share_within_reach(hand_.p, way_D);
  wanted_D_.setZero();
  if (share < 1.0) {
    wanted_D_ = way_D;
    if (share < kWorthwhile) {
      begin_clutching();
      return;
    }
  }
  const double distance_m = share * intention.way_W.norm();
  const double fitts_s = skill_.fitts_a_s + skill_.fitts_b_s * std::log2(distance_m / intention.width_m + 1.0);
  const double angle_rad = spatial::angle_between(intention.turn_W, Eigen::Quaterniond::Identity());
  const double duration_s = std::max(intention.care * fitts_s, angle_rad / kTurnRate_rad_s);

  // A turn's noise shrinks with the turn, like that of a way.
  const double turn_sigma = skill_.turn_noise_rad * std::min(1.0, angle_rad / 0.5);
  const double rx = turn_sigma * random_.normal();
  const double ry = turn_sigma * random_.normal();
  const double rz = turn_sigma * random_.normal();
  const Eigen::Quaterniond slip = spatial::about_x(rx) * spatial::about_y(ry) * spatial::about_z(rz);
  const Eigen::Quaterniond turn_D = R_WD_.conjugate() * intention.turn_W * R_WD_;
  const Eigen::Vector3d to = hand_.p + share * way_D + noise(share * way_D);
  begin(Phase::kMoving, to, (slip * turn_D * hand_.q).normalized(), duration_s);
}

void HumanHand::begin_clutching() {
  begin(Phase::kPressing, hand_.p, hand_.q, kPedal_s);
}

void HumanHand::grip(double grip_rad, double duration_s) {
  const double s = grip_steps_ == 0 ? 1.0 : static_cast<double>(grip_step_) / grip_steps_;
  grip_from_ += (grip_to_ - grip_from_) * minimum_jerk(s);
  grip_to_ = grip_rad;
  grip_step_ = 0;
  grip_steps_ = steps_of(duration_s);
}

void HumanHand::advance() {
  if (phase_ == Phase::kStill) return;
  ++stroke_.step;
  const double s = minimum_jerk(static_cast<double>(stroke_.step) / stroke_.steps);
  hand_.p = stroke_.from + s * (stroke_.to - stroke_.from);
  hand_.q = stroke_.q_from.slerp(s, stroke_.q_to).normalized();
  if (stroke_.step < stroke_.steps) return;
  switch (phase_) {
    case Phase::kMoving:
      phase_ = Phase::kStill;
      if (wanted_D_.squaredNorm() > 0.0) begin_clutching();
      break;
    case Phase::kPressing:
      begin(Phase::kReturning, -kReturnShare * kHandReach_m * wanted_D_ / wanted_D_.cwiseAbs().maxCoeff(), hand_.q,
            kReturn_s);
      break;
    case Phase::kReturning:
      wanted_D_.setZero();
      begin(Phase::kReleasing, hand_.p, hand_.q, kPedal_s);
      break;
    case Phase::kReleasing:
    case Phase::kStill:
      phase_ = Phase::kStill;
      break;
  }
}

HandSample HumanHand::step() {
  advance();
  if (grip_step_ < grip_steps_) ++grip_step_;
  HandSample sample;
  sample.X_DH = {hand_.p + tremor_.next(), hand_.q};
  const double s = grip_steps_ == 0 ? 1.0 : static_cast<double>(grip_step_) / grip_steps_;
  sample.grip_rad = grip_from_ + (grip_to_ - grip_from_) * minimum_jerk(s);
  sample.clutch_pedal = phase_ == Phase::kPressing || phase_ == Phase::kReturning;
  return sample;
}

}  // namespace trocar::trial
