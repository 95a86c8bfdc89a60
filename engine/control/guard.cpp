#include "engine/control/guard.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace trocar::control {
namespace {

constexpr std::size_t kMostEvents = 1000;
constexpr Tick kAhead{5};  // a stamp may be of so much later: clocks differ a little
constexpr double kSame_m = 1e-4;
constexpr double kSame_rad = 1e-3;

bool same(const ToolCommand& a, const ToolCommand& b) {
  return (a.X_WT.p - b.X_WT.p).norm() <= kSame_m && spatial::angle_between(a.X_WT.q, b.X_WT.q) <= kSame_rad;
}

bool inside(const KeepOut& keep_out, const Eigen::Vector3d& p_W) {
  const double across = std::hypot(p_W.x() - keep_out.foot_W.x(), p_W.y() - keep_out.foot_W.y());
  return across < keep_out.radius_m && p_W.z() < keep_out.top_m;
}

std::string words(const LimitReport& report) {
  std::string text;
  const auto add = [&text](bool hit, const char* word) {
    if (hit) text += (text.empty() ? "" : ", ") + std::string(word);
  };
  add(report.speed, "speed");
  add(report.acceleration, "acceleration");
  add(report.angular, "angular rate");
  add(report.jaw, "jaw rate");
  return text;
}

}  // namespace

std::string_view to_string(Rule rule) {
  constexpr std::array<std::string_view, kRules + 1> kNames{
      "",           "readiness",       "first command", "limits",    "workspace", "dead-man", "age",
      "disconnect", "following error", "no re-arming",  "soft stop", "malformed", "record"};
  return kNames[static_cast<std::size_t>(rule)];
}

std::string_view to_string(GuardState state) {
  constexpr std::array<std::string_view, 4> kNames{"disarmed", "armed", "moving", "held"};
  return kNames[static_cast<std::size_t>(state)];
}

Guard::Guard(GuardSettings settings, const ToolCommand& setpoint)
    : settings_(std::move(settings)), limiter_(settings_.limits, settings_.period_s, setpoint) {}

void Guard::note(Rule rule, std::string text) {
  ++counts_[static_cast<std::size_t>(rule)];
  if (obeys(Rule::kRecord) && events_.size() < kMostEvents) events_.push_back({now_, rule, std::move(text)});
}

void Guard::go(GuardState state, Rule rule, const std::string& why) {
  if (state == state_ && rule == reason_) return;
  state_ = state;
  reason_ = rule;
  reason_text_ = why;
  if (state != GuardState::kMoving) engaged_ = false;
  note(rule, why.empty() ? std::string(to_string(state)) : std::string(to_string(state)) + ": " + why);
}

Status Guard::arm(const ArmFeedback& feedback, Tick now) {
  now_ = now;
  if (obeys(Rule::kReadiness)) {
    const auto refuse = [](const char* why) { return fail(ErrorCode::kCheckFailed, why); };
    if (feedback.stamp.count <= 0 || now.count - feedback.stamp.count > settings_.feedback_age.count) {
      return refuse("the arm's feedback is not fresh");
    }
    if (feedback.operating_state != OperatingState::kEnabled) return refuse("the arm is not enabled");
    if (!feedback.homed) return refuse("the arm is not homed");
    if (!frame_confirmed_) return refuse("nobody has confirmed the arm's frame");
  }
  dead_man_up_seen_ = false;
  commanded_ = false;
  command_late_ = false;
  apart_since_.reset();
  limiter_.restart(limiter_.setpoint());
  go(GuardState::kArmed, Rule::kReadiness, "waits for the dead-man");
  return {};
}

void Guard::disarm(Rule rule, const std::string& why) {
  go(GuardState::kDisarmed, rule, why);
}

void Guard::hold(Rule rule, const std::string& why) {
  if (state_ == GuardState::kMoving) go(GuardState::kHeld, rule, why);
}

void Guard::look_at_arm(const GuardLook& look) {
  const ArmFeedback& arm = look.feedback;
  if (arm.operating_state != OperatingState::kEnabled) {
    const std::string why = "the arm is " + std::string(to_string(arm.operating_state));
    if (obeys(Rule::kNoRearming)) {
      if (state_ != GuardState::kDisarmed) disarm(Rule::kNoRearming, why);
    } else {
      hold(Rule::kNoRearming, why);
    }
    trouble_ = true;
  }
  if (obeys(Rule::kAge)) {
    const bool ahead = arm.stamp.count > look.now.count + kAhead.count;
    const bool old = arm.stamp.count <= 0 || ahead || look.now.count - arm.stamp.count > settings_.feedback_age.count;
    const bool backwards = looked_ && (look.now < now_ || arm.stamp < last_feedback_stamp_);
    last_feedback_stamp_ = arm.stamp;
    if (old) hold(Rule::kAge, ahead ? "the arm's feedback is of the future" : "the arm's feedback is old");
    if (backwards) hold(Rule::kAge, "a clock ran backwards");
    trouble_ = trouble_ || old || backwards;
    command_late_ = commanded_ && look.now.count - last_command_stamp_.count > settings_.command_age.count;
    if (command_late_) hold(Rule::kAge, "no command came");
  }
  if (obeys(Rule::kFollowing)) {
    const bool apart = (arm.measured_cp.p - limiter_.setpoint().X_WT.p).norm() > settings_.following_m;
    if (!apart) apart_since_.reset();
    if (apart && !apart_since_) apart_since_ = look.now;
    if (apart && look.now.count - apart_since_->count >= settings_.following_time.count) {
      hold(Rule::kFollowing, "the arm does not follow");
      trouble_ = true;
    }
  }
}

void Guard::look_at_dead_man(const GuardLook& look) {
  if (!look.dead_man) dead_man_up_seen_ = true;
  const std::int64_t age = look.now.count - look.dead_man_stamp.count;
  const bool confirmed = age <= settings_.heartbeat_age.count && age >= -kAhead.count;
  const bool pressed = look.dead_man && (dead_man_up_seen_ || !obeys(Rule::kReadiness));
  if (state_ == GuardState::kArmed && pressed && (confirmed || !obeys(Rule::kDeadMan))) {
    go(GuardState::kMoving, Rule::kReadiness, "");
  }
  if (!obeys(Rule::kDeadMan)) return;
  if (!look.dead_man) {
    hold(Rule::kDeadMan, "the dead-man is up");
    trouble_ = true;
  } else if (!confirmed) {
    hold(Rule::kDeadMan, "the dead-man is not confirmed");
    trouble_ = true;
  }
}

void Guard::look(const GuardLook& look) {
  trouble_ = false;
  agent_pedal_ = look.agent_pedal;
  look_at_arm(look);
  now_ = look.now;
  looked_ = true;
  if (look.soft_stop && obeys(Rule::kSoftStop)) {
    if (state_ != GuardState::kDisarmed) disarm(Rule::kSoftStop, "soft stop");
    trouble_ = true;
  }
  if (!look.connected && obeys(Rule::kDisconnect)) {
    hold(Rule::kDisconnect, "who commands has gone");
    trouble_ = true;
  }
  look_at_dead_man(look);
}

std::string Guard::forbidden(const Eigen::Vector3d& p_W, bool autonomous) const {
  if (!autonomous || !obeys(Rule::kWorkspace)) return "";
  for (const KeepOut& keep_out : settings_.keep_out) {
    if (inside(keep_out, p_W)) return "a peg is in the agent's way";
  }
  if (safe_ && !safe_(p_W)) return "the agent would leave the safe set";
  return "";
}

Eigen::Vector3d Guard::within_box(const Eigen::Vector3d& wish, double period_s) const {
  Eigen::Vector3d bounded = settings_.tip_W.clamp(wish);
  const Eigen::Vector3d& now = limiter_.setpoint().X_WT.p;
  // Half of what the arm could do is left for the other axes, and for the period that braking begins late.
  const double a = 0.5 * settings_.limits.acceleration_m_s2;
  for (int axis = 0; axis < 3; ++axis) {
    const auto fastest = [&](double room) {
      const double step = a * period_s;
      return std::max(0.0, std::sqrt(step * step + 2.0 * a * std::max(0.0, room)) - step);
    };
    const double up = fastest(settings_.tip_W.high[axis] - now[axis]) * period_s;
    const double down = fastest(now[axis] - settings_.tip_W.low[axis]) * period_s;
    bounded[axis] = std::clamp(bounded[axis], now[axis] - down, now[axis] + up);
  }
  return bounded;
}

Admitted Guard::stand(const Wish& wish, Rule rule) {
  Admitted admitted;
  admitted.command = limiter_.brake(wish.period_s);
  admitted.held = true;
  admitted.why = rule;
  return admitted;
}

Admitted Guard::admit(const Wish& wish) {
  if (!well_formed(wish.command) && obeys(Rule::kMalformed)) {
    note(Rule::kMalformed, "dropped a command that is no pose");
    return stand(wish, Rule::kMalformed);
  }
  if (obeys(Rule::kAge) && (wish.stamp.count <= 0 || wish.stamp.count > now_.count + kAhead.count ||
                            (commanded_ && wish.stamp <= last_command_stamp_))) {
    note(Rule::kAge, "dropped a command whose stamp does not grow");
    return stand(wish, Rule::kAge);
  }
  last_command_stamp_ = wish.stamp;
  commanded_ = true;
  if (state_ == GuardState::kDisarmed || state_ == GuardState::kArmed) {
    if (obeys(Rule::kReadiness)) return stand(wish, reason_);
  }
  if (state_ == GuardState::kHeld && trouble_) return stand(wish, reason_);
  if (wish.autonomous && !agent_pedal_ && obeys(Rule::kDeadMan)) {
    go(GuardState::kHeld, Rule::kDeadMan, "the agent's pedal is up");
    return stand(wish, Rule::kDeadMan);
  }
  Admitted admitted;
  if (!engaged_) {
    if (obeys(Rule::kFirstCommand) && !same(wish.command, limiter_.setpoint())) {
      go(GuardState::kHeld, Rule::kFirstCommand, "the first command is not where the tool was told to be");
      return stand(wish, Rule::kFirstCommand);
    }
    engaged_ = true;
    admitted.engaged = true;
    if (state_ == GuardState::kHeld) go(GuardState::kMoving, Rule::kReadiness, "");
    engaged_ = true;
  }
  ToolCommand command = wish.command;
  if (obeys(Rule::kLimits) && (command.X_WT.p - limiter_.setpoint().X_WT.p).norm() > settings_.jump_m) {
    go(GuardState::kHeld, Rule::kLimits, "a jump of more than 5 mm");
    return stand(wish, Rule::kLimits);
  }
  // Where it would come to rest if it had to brake from there.
  const Eigen::Vector3d v = (command.X_WT.p - limiter_.setpoint().X_WT.p) / wish.period_s;
  const Eigen::Vector3d rest = command.X_WT.p + v * (v.norm() / (2.0 * settings_.limits.acceleration_m_s2));
  bool at_face = false;
  if (obeys(Rule::kWorkspace)) {
    const Eigen::Vector3d bounded = within_box(command.X_WT.p, wish.period_s);
    at_face = bounded != command.X_WT.p;
    if (at_face) ++counts_[static_cast<std::size_t>(Rule::kWorkspace)];
    if (at_face && !at_face_) {
      --counts_[static_cast<std::size_t>(Rule::kWorkspace)];
      note(Rule::kWorkspace, "at its limit: the workspace");
    }
    command.X_WT.p = bounded;
  }
  at_face_ = at_face;
  if (const std::string why = forbidden(rest, wish.autonomous); !why.empty()) {
    go(GuardState::kHeld, Rule::kWorkspace, why);
    return stand(wish, Rule::kWorkspace);
  }
  if (!obeys(Rule::kLimits)) {
    limiter_.restart(command);
    admitted.command = command;
    return admitted;
  }
  const LimitedCommand limited = limiter_.next(command, wish.period_s);
  const bool other = limited.report.any() && words(limited.report) != words(limits_before_);
  if (limited.report.any()) ++counts_[static_cast<std::size_t>(Rule::kLimits)];
  if (other) {
    --counts_[static_cast<std::size_t>(Rule::kLimits)];
    note(Rule::kLimits, "at its limit: " + words(limited.report));
  }
  limits_before_ = limited.report;
  admitted.command = limited.command;
  admitted.limits = limited.report;
  return admitted;
}

ToolCommand Guard::rest(double period_s) {
  engaged_ = false;
  return limiter_.brake(period_s);
}

void Guard::refused(const ToolCommand& setpoint) {
  limiter_.restart(setpoint);
  engaged_ = false;
}

std::vector<GuardEvent> Guard::take_events() {
  return std::exchange(events_, {});
}

}  // namespace trocar::control
