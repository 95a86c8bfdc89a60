/// A trial in the simulator: operator, agent and assistant share the arms, each behind the guard, at 1 kHz.
#pragma once

#include <memory>

#include "engine/trial/live_session.h"
#include "engine/trial/operator_input.h"
#include "engine/trial/trial_options.h"

namespace trocar::trial {

/// From the assistant's hand to the right tool.
constexpr double kAssistantScale = 0.2;

/// Where the operator's hand and pedals come from, if not from the script.
struct TrialInputs {
  OperatorInput* user = nullptr;       ///< Null: the scripted operator of the options' skill.
  OperatorInput* assistant = nullptr;  ///< Null: the scripted expert.
  bool scripted = false;               ///< What moves them says that no person does: never to be passed off as one's.
};

/// Both arms' inputs are asked every 5 ticks; pedals take effect in the tick in which they arrive, in between too: the
/// recording then has a sample at that tick, so that a replay of the setpoints is exact. Ends a moment after operator
/// and assistant have done their part, or after a drop or a fault, at the time limit, or when it is stopped.
/// Deterministic with scripted inputs: the same options give the same samples, hashes and events. Threads: one at a
/// time.
class SharedControlSession final : public LiveSession {
 public:
  /// Errors: kInvalidArgument for a block or goal outside of 0 … 5, a time limit, scale or rate out of range, or a
  /// shared mode without any agent. `inputs` must outlive the session.
  static Result<std::unique_ptr<SharedControlSession>> create(TrialOptions options, TrialInputs inputs = {});
  ~SharedControlSession() override;

  const TrialOptions& options() const;
  /// "scripted" or "person": who has the right arm.
  std::string_view assistant_kind() const;
  const demonstration::Provenance& provenance() const;

  /// From any other thread as well: takes effect in the next tick.
  void stop();
  /// The arm says FAULT from the next tick on, as a physical one might: the trial ends by a fault. Likewise.
  void play_fault(kinematics::ArmSide side = kinematics::ArmSide::kLeft);
  /// Marks an instant for review; likewise.
  void mark_incident(std::string text);

  void step() override;
  bool done() const override;
  const simulation::WorldState& state() const override;
  demonstration::Segment segment() const override;
  demonstration::Authority authority() const override;
  demonstration::Outcome outcome() const override;
  bool placed() const override;
  std::optional<std::string> take_initial_world() override;
  std::vector<demonstration::Sample> take_samples() override;
  std::vector<demonstration::HashMark> take_marks() override;

  std::optional<TrialStatus> trial_status() const override;
  /// When it succeeded, from the beginning; nothing if it did not.
  std::optional<double> completion_s() const;
  /// When the outcome was decided, whichever; nothing if it was not.
  std::optional<double> decided_s() const;
  std::vector<TrialEvent> take_events() override;

 private:
  struct Impl;
  explicit SharedControlSession(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace trocar::trial
