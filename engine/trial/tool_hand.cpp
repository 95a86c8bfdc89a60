#include "engine/trial/tool_hand.h"

#include <algorithm>
#include <cmath>

#include "engine/demonstration/recording.h"
#include "engine/spatial/grid.h"
#include "engine/trial/human_hand.h"

namespace trocar::trial {
namespace {

constexpr double kPeriod_s = 1.0 / demonstration::kSampleRate_hz;
constexpr double kJawRate_rad_s = 1.2;
/// A speed that begins or ends does so within about a tenth of a second.
constexpr double kRamp_m_s2 = 0.4;
/// One cell in a tenth of a second: at its fastest 47 mm/s, as fast as the agent.
constexpr int kStepSamples = 20;
constexpr std::size_t kWaitingSteps = 8;
/// Mean speeds of a way that is led by minimum jerk.
constexpr double kLeadSpeed_m_s = 0.04;
constexpr double kLeadTurn_rad_s = 1.0;
constexpr double kShortestLead_s = 0.2;

/// The middle of the cell of the lattice, endless in all directions, that is `cells` away from the one that holds p_WQ.
Eigen::Vector3d middle_of_cell(const Eigen::Vector3d& p_WQ, const Eigen::Vector3d& cells) {
  const spatial::Grid grid;
  const Eigen::Vector3d index = ((p_WQ - grid.p_WGo) / grid.cell_m).array().floor();
  const Eigen::Vector3d whole = (index + cells).array() + 0.5;
  return grid.p_WGo + grid.cell_m * whole;
}

int lead_samples(const spatial::Pose& from, const spatial::Pose& to) {
  const double seconds = std::max({(to.p - from.p).norm() / kLeadSpeed_m_s,
                                   spatial::angle_between(from.q, to.q) / kLeadTurn_rad_s, kShortestLead_s});
  return static_cast<int>(std::ceil(seconds * demonstration::kSampleRate_hz));
}

bool same_place(const spatial::Pose& a, const spatial::Pose& b) {
  return (a.p - b.p).norm() < 1e-6 && spatial::angle_between(a.q, b.q) < 1e-6;
}

}  // namespace

ToolHand::ToolHand(HandMode mode, const control::ToolCommand& start)
    : mode_(mode), wish_(start), place_(start.X_WT), jaw_goal_rad_(start.jaw_rad) {
  if (mode_ != HandMode::kStep) return;
  place_.p = middle_of_cell(start.X_WT.p, Eigen::Vector3d::Zero());
  goals_.push_back({place_, lead_samples(start.X_WT, place_)});
  goal_from_ = start.X_WT;
}

void ToolHand::keep_off_the_floor(spatial::Pose& X_WT) {
  at_floor_ = X_WT.p.z() < kFloor_m;
  if (at_floor_) X_WT.p.z() = kFloor_m;
}

void ToolHand::drive(const Eigen::Vector3d& v_WT, const Eigen::Vector3d& w_WT_T) {
  if (!v_WT.allFinite() || !w_WT_T.allFinite()) return;
  v_wanted_ = v_WT;
  w_wanted_T_ = w_WT_T;
}

void ToolHand::step(const Eigen::Vector3d& cells) {
  if (clutch_ || goals_.size() >= kWaitingSteps) return;
  spatial::Pose next = place_;
  next.p = middle_of_cell(place_.p, cells);
  if (next.p.z() < kFloor_m) {
    at_floor_ = true;
    return;
  }
  at_floor_ = false;
  place_ = next;
  if (mode_ != HandMode::kWaypoint) add_goal();
}

void ToolHand::add_goal() {
  if (goals_.empty()) {
    goal_from_ = wish_.X_WT;
    goal_sample_ = 0;
  }
  goals_.push_back({place_, kStepSamples});
}

void ToolHand::shift(const Eigen::Vector3d& by_W_m) {
  if (goals_.size() >= kWaitingSteps || clutch_ || !by_W_m.allFinite()) return;
  if (mode_ != HandMode::kStep && under_way()) return;
  place_.p += by_W_m;
  keep_off_the_floor(place_);
  if (mode_ == HandMode::kStep) add_goal();
}

void ToolHand::place(const spatial::Pose& X_WT) {
  if (clutch_ || under_way() || !X_WT.finite()) return;
  place_ = X_WT;
  keep_off_the_floor(place_);
}

void ToolHand::toggle_jaw() {
  jaw_goal_rad_ = jaw_goal_rad_ > 0.5 * kHandOpen_rad ? kHandGrip_rad : kHandOpen_rad;
}

void ToolHand::hold_clutch(bool down) {
  clutch_ = down;
}

void ToolHand::go() {
  if (mode_ != HandMode::kWaypoint || clutch_ || same_place(wish_.X_WT, place_)) return;
  goals_.assign(1, {place_, lead_samples(wish_.X_WT, place_)});
  goal_from_ = wish_.X_WT;
  goal_sample_ = 0;
}

void ToolHand::lead_to(const control::ToolCommand& place) {
  place_ = place.X_WT;
  jaw_goal_rad_ = place.jaw_rad;
  goals_.assign(1, {place_, lead_samples(wish_.X_WT, place_)});
  goal_from_ = wish_.X_WT;
  goal_sample_ = 0;
}

void ToolHand::follow_goals() {
  const Goal& goal = goals_.front();
  ++goal_sample_;
  if (goal_sample_ >= goal.samples) {
    wish_.X_WT = goal_from_ = goal.X_WT;
    goal_sample_ = 0;
    goals_.pop_front();
    return;
  }
  wish_.X_WT =
      spatial::interpolate(goal_from_, goal.X_WT, minimum_jerk(static_cast<double>(goal_sample_) / goal.samples));
}

void ToolHand::follow_speed() {
  const Eigen::Vector3d wanted = clutch_ ? Eigen::Vector3d(Eigen::Vector3d::Zero()) : v_wanted_;
  const Eigen::Vector3d change = wanted - v_WT_;
  const double most = kRamp_m_s2 * kPeriod_s;
  v_WT_ = change.norm() > most ? Eigen::Vector3d(v_WT_ + change * (most / change.norm())) : wanted;
  place_.p += v_WT_ * kPeriod_s;
  if (v_WT_.squaredNorm() > 0.0) keep_off_the_floor(place_);
  const double turn_rad = w_wanted_T_.norm() * kPeriod_s;
  if (clutch_ || turn_rad == 0.0) return;
  place_.q = (place_.q * Eigen::AngleAxisd(turn_rad, w_wanted_T_.normalized())).normalized();
}

control::ToolCommand ToolHand::next() {
  const double jaw_step =
      std::clamp(jaw_goal_rad_ - wish_.jaw_rad, -kJawRate_rad_s * kPeriod_s, kJawRate_rad_s * kPeriod_s);
  wish_.jaw_rad =
      std::abs(jaw_goal_rad_ - wish_.jaw_rad) <= kJawRate_rad_s * kPeriod_s ? jaw_goal_rad_ : wish_.jaw_rad + jaw_step;
  if (under_way()) {
    if (!clutch_) follow_goals();
    return wish_;
  }
  follow_speed();
  if (mode_ != HandMode::kWaypoint) wish_.X_WT = place_;
  return wish_;
}

void ToolHand::stay_at(const control::ToolCommand& setpoint) {
  wish_.X_WT = setpoint.X_WT;
  v_WT_.setZero();
  goals_.clear();
  goal_sample_ = 0;
  // A waypoint out of reach stays where it was put, so that it can be taken back from there.
  if (mode_ != HandMode::kWaypoint) place_ = setpoint.X_WT;
}

std::optional<spatial::Pose> ToolHand::waypoint() const {
  if (mode_ != HandMode::kWaypoint || same_place(wish_.X_WT, place_)) return std::nullopt;
  return place_;
}

}  // namespace trocar::trial
