/// Who has the left arm of a trial, tick by tick, and what ends the trial.
#pragma once

#include <optional>

#include "engine/control/authority.h"
#include "engine/control/guard.h"
#include "engine/trial/trial_recorder.h"

namespace trocar::trial {

/// What a tick shows before anything moves in it.
struct TrialLook {
  Tick now;  ///< The world's.
  demonstration::Segment segment = demonstration::Segment::kA;
  bool dropped = false;      ///< The block is lost, and the trial with it.
  bool agent_pedal = false;  ///< Level of the left pedal, as it has arrived at the arm.
  bool clutch_pedal = false;
  bool connected = true;         ///< The operator's link to the left arm.
  bool homed = true;             ///< The left arm.
  bool agent_can_begin = false;  ///< The segment is an agent's, who knows what to do from where the tool is.
  bool stop = false;             ///< Somebody presses it, now.
};

/// What the pedals, the guards and the task mean for a trial ("Shared control", Authority and Trial). Moves nothing:
/// it is shown guards and agents, and says who may move. Deterministic. Threads: one at a time.
class TrialAuthority {
 public:
  /// `recorder` gets pedals, states and what broke the trial off, and must outlive it. `time_limit_s`: simulated.
  TrialAuthority(TrialRecorder& recorder, double time_limit_s) : recorder_(&recorder), time_limit_s_(time_limit_s) {}

  /// Every tick, after both guards have had their own look.
  void look(const TrialLook& look, const control::Guard& left, const control::Guard& right);
  /// Every 5th tick, once it is over. `nothing_left`: nobody has anything to do any more.
  void look_for_end(Tick now, bool nothing_left);

  control::ControlState state() const { return machine_.state(); }
  /// The last look changed the state: somebody else has the arm from this tick on.
  bool changed() const { return machine_.changed(); }
  bool agent_has() const { return state() == control::ControlState::kAgent; }
  /// Steering or by the clutch.
  bool operator_has() const;
  /// For the record, where the task has come to `segment`.
  demonstration::Authority owner(demonstration::Segment segment) const;

  /// A stop or a fault breaks the trial off in this tick: both arms come to rest from here on.
  bool halts() const { return halts_; }
  /// It was broken off, in this tick or before.
  bool broken_off() const { return broken_off_.has_value(); }
  /// What the task found, unless the trial was broken off before that.
  demonstration::Outcome outcome(demonstration::Outcome of_task) const;
  /// Nothing more is recorded.
  bool ended() const { return ended_; }

  int agent_presses() const { return presses_; }
  bool agent_pedal_stuck() const { return machine_.agent_pedal_stuck(); }
  int hand_overs() const { return machine_.hand_overs(); }

 private:
  bool agent_may(const TrialLook& look, const control::Guard& left) const;
  void log_changes(Tick now);
  void break_off(Tick now, demonstration::Outcome as, const std::string& why);

  TrialRecorder* recorder_;
  double time_limit_s_;
  control::AuthorityMachine machine_;
  demonstration::Segment segment_of_agent_ = demonstration::Segment::kA;  ///< In which it got the arm.
  bool begun_ = false;                                                    ///< The operator has had the arm.
  bool left_moves_ = false;                                               ///< Its guard has let it, once.
  bool halts_ = false;
  std::optional<demonstration::Outcome> broken_off_;
  std::optional<Tick> ends_at_;
  bool ended_ = false;
  int presses_ = 0;
};

}  // namespace trocar::trial
