/// Runs trials in the simulator by scripted operators: which models serve which block, many times real time.
#pragma once

#include <string>
#include <vector>

#include "engine/core/progress.h"
#include "engine/core/result.h"
#include "engine/link/hand_server.h"
#include "engine/trial/protocol.h"
#include "engine/trial/shared_control_session.h"
#include "engine/workbench/project.h"
#include "engine/workbench/trial_plan.h"

namespace trocar::workbench {

/// The models for a transfer of `block`: of each segment the one whose demonstration was of that block. Where there is
/// none, the first there is: of C, which ends at the hand-off for all, and of A with the lattice at the target; on the
/// board the agent has none then. None for a manual trial.
/// Errors: kNotFound for a model that is not there; kInvalidArgument for one that is of B, D or E.
Result<std::vector<trial::AgentModel>> agents_for(const Project& project, const TrialPlan& plan, int block);

/// The options of one transfer of the plan. Errors: those of `agents_for`; kInvalidArgument, naming the block, for
/// shared control where no model serves it.
Result<trial::TrialOptions> options_of(const Project& project, const TrialPlan& plan, int transfer);
/// Whether each of so many transfers can be run: known before the first of them. Errors: as `options_of`.
Status check_blocks(const Project& project, const TrialPlan& plan, int transfers);

/// What a trial left, to be stored.
struct RanTrial {
  demonstration::Recording recording;
  trial::TrialRecord record;
};

/// The record of a trial that was run with these options, with all that the session tells at its end.
trial::TrialRecord record_of(trial::SharedControlSession& session, const TrialPlan& plan, int transfer,
                             const std::vector<demonstration::Sample>& samples,
                             const std::vector<trial::TrialEvent>& events);

/// What the session cannot know: that no person was at the other end, and the network's part of the delay.
void add_link(const link::HandServerStatus& link, trial::TrialRecord& record);

/// Each transfer by scripted operators, in order. When it is cancelled those under way are stopped and come back as
/// aborted, those not begun do not: nothing that was run is lost. Threads: any; `project` is not changed.
/// Errors: kInvalidArgument for less than one transfer; those of `options_of` and `SharedControlSession::create`.
Result<std::vector<RanTrial>> run_trials(const Project& project, const TrialPlan& plan, Progress& progress);

/// The transfers of one block of a protocol, until it is over. Errors: as `run_trials`.
Result<std::vector<RanTrial>> run_block(const Project& project, TrialPlan plan, const trial::ProtocolBlock& block,
                                        Progress& progress);
/// The plan of a block: mode and delay are the block's, and its seeds are those of the other mode's block of the same
/// rank, so that both have the same scenes. Errors: those of `control::delay_from`.
Result<TrialPlan> plan_of(TrialPlan plan, const std::vector<trial::ProtocolBlock>& blocks, std::size_t number);

/// "SC 3": the first number that no trial of the mode has.
std::string trial_name(const Project& project, trial::Mode mode);

}  // namespace trocar::workbench
