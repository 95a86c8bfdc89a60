/// The two people of a trial, scripted where nobody else is, and what of theirs has arrived at the arms.
#pragma once

#include <memory>

#include "engine/trial/hand_line.h"
#include "engine/trial/scripted_operator.h"
#include "engine/trial/shared_control_session.h"
#include "engine/trial/task.h"

namespace trocar::trial {

/// The user's hand and pedals come late, by the delay of the line; the assistant's hand does not ("Shared control",
/// Inputs, Scripted operator, and rules 5 to 7 of Guard). Hands are in the display's frame D. Threads: one at a time.
class TrialPeople {
 public:
  /// Who is in `inputs` must outlive it.
  TrialPeople(const TrialOptions& options, const TrialInputs& inputs);

  /// Every tick, before anything else of the tick: both hands are asked every 5 ticks, and in those between the user
  /// for what does not wait. Nothing of the user's is sent while the link is cut.
  void listen(const simulation::WorldState& seen);

  /// The user's hand and pedals as they last arrived; a hand at rest before any have.
  const HandSample& hand() const { return line_.sample(); }
  bool arrived() const { return line_.any(); }
  /// The first of all has arrived in this tick.
  bool joins() const { return joins_; }
  /// The user's link as the left arm hears of it: as old as the last that has come through the delay, too.
  LinkState link() const;
  const HandSample& assistant_hand() const { return assistant_hand_; }
  /// Nobody is present at the right arm before the user is there.
  LinkState assistant_link() const;

  /// Both have done their part: a script says so of itself, of anybody else the task does.
  bool finished(const Task& task) const;
  /// No person has the right arm.
  bool assistant_scripted() const { return scripted_inputs_ || assistant_ == scripted_assistant_.get(); }
  /// For the delays, in seconds, as they were applied.
  const HandLine& line() const { return line_; }

 private:
  std::unique_ptr<ScriptedOperator> scripted_user_;
  std::unique_ptr<ScriptedOperator> scripted_assistant_;
  bool scripted_inputs_;  ///< What moves them is no person.
  OperatorInput* user_;
  OperatorInput* assistant_;
  HandLine line_;
  bool joins_ = false;
  LinkState user_link_;
  LinkState assistant_link_;
  HandSample assistant_hand_;
};

}  // namespace trocar::trial
