#include "engine/trial/trial_setup.h"

#include <cmath>
#include <utility>

#include "engine/control/tool_mapping.h"
#include "engine/trial/provenance.h"

namespace trocar::trial {

Status check(const TrialOptions& options) {
  const auto refuse = [](std::string why) { return fail(ErrorCode::kInvalidArgument, std::move(why)); };
  const auto exists = [](int index) { return index >= 0 && index < peg_board::kBlockCount; };
  if (!exists(options.block)) return refuse("the block is a number from 0 to 5");
  if (!exists(options.goal)) return refuse("the goal is a number from 0 to 5");
  if (!std::isfinite(options.time_limit_s) || options.time_limit_s <= 0.0)
    return refuse("the time limit is not positive");
  if (!(options.scale >= control::kSmallestScale && options.scale <= control::kLargestScale)) {
    return refuse("the scale from hand to tool is 0.1 to 0.5");
  }
  if (!(options.agent_rate_hz >= 1.0 && options.agent_rate_hz <= 40.0)) {
    return refuse("the agent steps 1 to 40 times a second");
  }
  if (options.mode == Mode::kShared && options.agents.empty()) {
    return refuse("shared control needs a model: train one of segment A or C");
  }
  if (options.begin_p_W) {
    spatial::Pose X_WT = kinematics::ready_pose(kinematics::ArmSide::kLeft);
    X_WT.p = *options.begin_p_W;
    const auto joints = kinematics::inverse(kinematics::psm_model(kinematics::ArmSide::kLeft), X_WT);
    if (!joints) return tl::unexpected(Error(joints.error()).in("begin a trial there"));
  }
  return {};
}

simulation::WorldOptions world_options(const TrialOptions& options) {
  simulation::WorldOptions world;
  world.seed = options.seed;
  world.left_begin_p_WT = options.begin_p_W;
  return world;
}

demonstration::Provenance provenance_of(const TrialOptions& options, const simulation::WorldOptions& world,
                                        const TrialInputs& inputs) {
  const bool by_skill = inputs.user == nullptr;
  demonstration::Provenance provenance = provenance_on(world, options.seed, options.block, options.goal);
  provenance.operator_kind = by_skill || inputs.scripted ? "scripted" : "person";
  if (by_skill) provenance.skill = to_string(options.skill);
  provenance.device = by_skill ? "scripted hand" : std::string(inputs.user->name());
  return provenance;
}

Assignment assignment_of(const TrialOptions& options, Skill skill) {
  Assignment assignment{options.block, options.goal, parameters(skill), std::string(to_string(skill)), -1.0};
  assignment.shares_control = options.mode == Mode::kShared;
  assignment.scale = options.scale;
  return assignment;
}

}  // namespace trocar::trial
