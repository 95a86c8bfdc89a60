/// What every recording says of where it comes from, whoever moved the arms in it.
#pragma once

#include <cstdint>

#include "engine/demonstration/recording.h"
#include "engine/simulation/world.h"

namespace trocar::trial {

/// Of a recording in `world`, with scene and software; who moves the arms (`operator_kind`, `skill`, `device`) is left
/// empty for the session, and `created` for the caller, who has the clock. `seed` is the session's: that of a world
/// which a demonstration left is the demonstration's. `block` and `goal`: 0 … 5.
demonstration::Provenance provenance_on(const simulation::WorldOptions& world, std::uint64_t seed, int block, int goal);

}  // namespace trocar::trial
