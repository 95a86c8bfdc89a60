/// Whether a take by hand makes sense, and who is said to have made it.
#pragma once

#include "engine/simulation/world.h"
#include "engine/trial/hand_session.h"

namespace trocar::trial {

/// Errors: kInvalidArgument, as `HandSession::create` says.
Status check(const HandOptions& options);

/// `created` is left empty for the caller, who has the clock.
demonstration::Provenance provenance_of(const HandOptions& options, const simulation::WorldOptions& world);

}  // namespace trocar::trial
