/// What a trial begins with: whether its options make sense, the world, who is said to have made it, and what the
/// scripted people are told.
#pragma once

#include "engine/simulation/world.h"
#include "engine/trial/scripted_operator.h"
#include "engine/trial/shared_control_session.h"

namespace trocar::trial {

/// Errors: kInvalidArgument, as `SharedControlSession::create` says.
Status check(const TrialOptions& options);

simulation::WorldOptions world_options(const TrialOptions& options);

/// `created` is left empty for the caller, who has the clock.
demonstration::Provenance provenance_of(const TrialOptions& options, const simulation::WorldOptions& world,
                                        const TrialInputs& inputs);

/// Of the scripted operator, or with the assistant's skill of the scripted assistant.
Assignment assignment_of(const TrialOptions& options, Skill skill);

}  // namespace trocar::trial
