/// A rollout in the simulator as a recording: for films, and for whoever wants to see it go.
#pragma once

#include <memory>

#include "engine/core/progress.h"
#include "engine/core/result.h"
#include "engine/demonstration/recording.h"
#include "engine/trial/physics_rollout.h"

namespace trocar::trial {

struct RecordedRollout {
  PhysicsRollout result;
  /// From the start, at 0 s, to half a second after the end; the agent has the arm all along, and no pedal is held.
  std::shared_ptr<const demonstration::Recording> recording;
};

/// The same to the bit each time. Takes some tenths of a second. Precondition: `start` lies in the model's lattice.
/// Errors: those of `segment_world`; kCheckFailed if the tool cannot be led to the start.
Result<RecordedRollout> record_rollout(const learning::Model& model, spatial::CellIndex start,
                                       const PhysicsOptions& options, Progress& progress);

}  // namespace trocar::trial
