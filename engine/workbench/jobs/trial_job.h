/// Runs trials in the simulator by scripted operators: which models serve which block, many times real time.
#pragma once

#include <string>
#include <vector>

#include "engine/core/progress.h"
#include "engine/core/result.h"
#include "engine/trial/shared_control_session.h"
#include "engine/workbench/project.h"

namespace trocar::workbench {

/// Several transfers in a row by one mode: one block of a protocol.
struct TrialPlan {
  trial::TrialOptions options;  ///< Of every transfer; seed, block, goal and agents are found from what follows.
  /// Of A and C; those of a segment of which none is named are all that the project has.
  std::vector<ModelId> models;
  std::uint64_t seed = 1;  ///< Of the first transfer; the next ones count up.
  int first_block = 0;     ///< 0 … 5; the next transfer takes the next block, and its goal has the same number.
  int transfers = 1;
  bool same_block = false;  ///< Each transfer takes `first_block`.
  int threads = 1;          ///< The result does not depend on it.
  std::string subject;
  std::string session;
  int block_number = 0;
};

/// The models for a transfer of `block`: of each segment the one whose demonstration was of that block, else, with the
/// lattice at the target, the first there is. None for a manual trial.
/// Errors: kNotFound for a model that is not there; kInvalidArgument for one that is of B, D or E.
Result<std::vector<trial::AgentModel>> agents_for(const Project& project, const TrialPlan& plan, int block);

/// The options of one transfer of the plan. Errors: those of `agents_for`.
Result<trial::TrialOptions> options_of(const Project& project, const TrialPlan& plan, int transfer);

/// What a trial left, to be stored.
struct RanTrial {
  demonstration::Recording recording;
  trial::TrialRecord record;
};

/// The record of a trial that was run with these options, with all that the session tells at its end.
trial::TrialRecord record_of(trial::SharedControlSession& session, const TrialPlan& plan, int transfer,
                             const std::vector<demonstration::Sample>& samples,
                             const std::vector<trial::TrialEvent>& events);

/// Each transfer by scripted operators, in order. Threads: any; `project` is not changed.
/// Errors: kInvalidArgument for less than one transfer; those of `options_of` and `SharedControlSession::create`;
/// kCancelled.
Result<std::vector<RanTrial>> run_trials(const Project& project, const TrialPlan& plan, Progress& progress);

/// "SC 3": the first number that no trial of the mode has.
std::string trial_name(const Project& project, trial::Mode mode);

}  // namespace trocar::workbench
