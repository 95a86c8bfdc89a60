/// The one gate in front of every arm, the simulated one too ("Shared control, teleoperation and safety", Guard).
#pragma once

#include <array>
#include <bitset>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/control/arm.h"
#include "engine/control/setpoint_limiter.h"
#include "engine/spatial/box.h"

namespace trocar::control {

/// By their numbers in the list of the rules.
enum class Rule : std::uint8_t {
  kReadiness =
      1,  ///< Nothing moves before fresh feedback, homed, frame confirmed, armed, and a dead-man pressed after it.
  kFirstCommand = 2,  ///< The first command equals the current setpoint.
  kLimits = 3,        ///< Step, speed, acceleration, angular rate, jaw: saturated and told; a jump over 5 mm holds.
  kWorkspace = 4,     ///< Box, floor; while autonomous the pegs and the safe set.
  kDeadMan = 5,       ///< Held, and confirmed again and again.
  kAge = 6,           ///< Of feedback and of commands; stamps that do not grow.
  kDisconnect = 7,    ///< Who commands has gone.
  kFollowing = 8,     ///< The arm is elsewhere than it was told to be, for a while.
  kNoRearming = 9,    ///< After a fault, a disable or a pause somebody arms it again, or nobody.
  kSoftStop = 10,     ///< Not an emergency stop.
  kMalformed = 11,    ///< Not finite, not a rotation: dropped and counted.
  kRecord = 12,       ///< Every command that was not passed as it was, every limit and every change is in the record.
};
constexpr int kRules = 12;
/// "dead-man" …
std::string_view to_string(Rule rule);

enum class GuardState : std::uint8_t {
  kDisarmed,  ///< Nothing moves until `arm()`.
  kArmed,     ///< Waits for the dead-man to be pressed.
  kMoving,    ///< Commands pass.
  kHeld,      ///< Nothing moves; goes on by itself once what held it is over and a command equals the setpoint.
};
std::string_view to_string(GuardState state);

/// An upright cylinder that the tool keeps out of while nobody steers it.
struct KeepOut {
  Eigen::Vector3d foot_W{0.0, 0.0, 0.0};  ///< Metres.
  double radius_m = 0.0;
  double top_m = 0.0;  ///< z_W.
};

struct GuardSettings {
  MotionLimits limits;
  double period_s = 0.005;  ///< Of commands.
  double jump_m = 0.005;
  spatial::Box tip_W{{-0.15, -0.15, 0.0005}, {0.15, 0.15, 0.15}};  ///< Its low z is the floor.
  std::vector<KeepOut> keep_out;
  Tick feedback_age{100};
  Tick command_age{100};
  Tick heartbeat_age{100};
  double following_m = 0.003;
  Tick following_time{200};
  /// Rules that are left out, by their numbers: for the tests, which show what would happen without each.
  std::bitset<kRules + 1> left_out;
};

/// What the guard is shown every tick.
struct GuardLook {
  Tick now;
  ArmFeedback feedback;
  bool dead_man = false;     ///< The level of the dead-man of whoever steers.
  Tick dead_man_stamp;       ///< When that was last confirmed.
  bool agent_pedal = false;  ///< The level of the left pedal: without it nothing autonomous passes (rule 5).
  bool connected = true;     ///< Who commands is there.
  bool soft_stop = false;    ///< Somebody asks for it, now.
};

/// Where the tool shall be at the end of the coming period.
struct Wish {
  ToolCommand command;
  Tick stamp;  ///< Of who made it.
  double period_s = 0.005;
  bool autonomous = false;  ///< The agent's: keep-outs and the safe set count.
};

struct Admitted {
  ToolCommand command;  ///< What is to be sent.
  LimitReport limits;
  bool held = false;         ///< The wish was not followed: the tool brakes or stands.
  bool engaged = false;      ///< This wish passed as the first after a hold.
  Rule why = Rule::kRecord;  ///< Of `held`.
};

/// A line of the record (rule 12).
struct GuardEvent {
  Tick at;
  Rule rule = Rule::kRecord;
  std::string text;
};

/// Threads: one at a time. Deterministic: the same looks and wishes give the same answers.
class Guard {
 public:
  Guard(GuardSettings settings, const ToolCommand& setpoint);

  /// Errors: kCheckFailed saying which condition of rule 1 is not met.
  Status arm(const ArmFeedback& feedback, Tick now);
  void disarm(Rule rule, const std::string& why);
  /// Somebody has looked that the frame of the arm is that of the board.
  void confirm_frame(bool confirmed) { frame_confirmed_ = confirmed; }
  /// Where the agent may be; none: anywhere.
  void set_safe_set(std::function<bool(const Eigen::Vector3d&)> safe) { safe_ = std::move(safe); }

  /// Every tick, before `admit`.
  void look(const GuardLook& look);
  /// The command for the coming period: the wish where it may pass.
  Admitted admit(const Wish& wish);
  /// Nobody wishes for anything: the tool brakes and stands, and the next command engages.
  ToolCommand rest(double period_s);
  /// The arm refused what was admitted (out of reach): it stays where it is, and what comes next engages there.
  void refused(const ToolCommand& setpoint);
  /// The last period was cut short at `reached`, between the setpoint before and that admitted for its end.
  void cut_short(const ToolCommand& reached) { limiter_.rewind(reached); }
  /// Nothing moves until the next first command, for whatever reason of the caller.
  void hold(Rule rule, const std::string& why);

  GuardState state() const { return state_; }
  /// The rule that holds or disarmed it; of no account while moving.
  Rule reason() const { return reason_; }
  const std::string& reason_text() const { return reason_text_; }
  const ToolCommand& setpoint() const { return limiter_.setpoint(); }
  const Eigen::Vector3d& velocity() const { return limiter_.velocity(); }
  std::int64_t count(Rule rule) const { return counts_[static_cast<std::size_t>(rule)]; }
  /// Since the last call, in order; at most 1,000, further ones are only counted.
  std::vector<GuardEvent> take_events();

 private:
  bool obeys(Rule rule) const { return !settings_.left_out[static_cast<std::size_t>(rule)]; }
  void note(Rule rule, std::string text);
  void go(GuardState state, Rule rule, const std::string& why);
  void look_at_arm(const GuardLook& look);
  void look_at_dead_man(const GuardLook& look);
  Admitted stand(const Wish& wish, Rule rule);
  /// As near to `wish` as lets the tool brake before each face of the box (rule 4).
  Eigen::Vector3d within_box(const Eigen::Vector3d& wish, double period_s) const;
  /// What rule 4 says of a place, "" if nothing.
  std::string forbidden(const Eigen::Vector3d& p_W, bool autonomous) const;

  GuardSettings settings_;
  SetpointLimiter limiter_;
  std::function<bool(const Eigen::Vector3d&)> safe_;
  GuardState state_ = GuardState::kDisarmed;
  Rule reason_ = Rule::kReadiness;
  std::string reason_text_ = "not armed";
  bool frame_confirmed_ = false;
  bool dead_man_up_seen_ = false;  ///< Since arming, or since it failed.
  bool engaged_ = false;           ///< A first command has passed.
  Tick now_;
  bool looked_ = false;
  Tick last_command_stamp_;
  Tick last_feedback_stamp_;
  bool agent_pedal_ = false;
  bool commanded_ = false;
  bool command_late_ = false;
  bool trouble_ = false;  ///< What held it is still there.
  std::optional<Tick> apart_since_;
  std::array<std::int64_t, kRules + 1> counts_{};
  std::vector<GuardEvent> events_;
  LimitReport limits_before_;
  bool at_face_ = false;  ///< The last wish was held off a face of the box.
};

}  // namespace trocar::control
