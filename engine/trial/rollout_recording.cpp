#include "engine/trial/rollout_recording.h"

#include <fmt/format.h>

#include <utility>

#include "engine/learning/rollout.h"
#include "engine/trial/provenance.h"
#include "engine/trial/sampling.h"
#include "engine/trial/segment_world.h"

namespace trocar::trial {

Result<RecordedRollout> record_rollout(const learning::Model& model, spatial::CellIndex start,
                                       const PhysicsOptions& options, Progress& progress) {
  TransferOptions transfer;
  transfer.seed = options.seed;
  transfer.block = options.block;
  transfer.goal = options.goal;
  TROCAR_ASSIGN_OR_RETURN(const std::string world, segment_world(options.segment, transfer, progress));

  auto recording = std::make_shared<demonstration::Recording>();
  SampleContext context;
  context.block = options.block;
  context.authority = demonstration::Authority::kAgent;
  context.segment = options.segment;
  const auto watch = [&](const simulation::WorldState& state) {
    for (const kinematics::ArmSide side : kinematics::kArmSides) {
      context.setpoints[kinematics::index_of(side)] = setpoint_of(state, side);
    }
    demonstration::Sample sample = make_sample(state, context);
    sample.tick = static_cast<std::int64_t>(recording->samples.size()) * demonstration::kTicksPerSample;
    recording->samples.push_back(sample);
  };
  RecordedRollout recorded;
  recorded.result = physics_rollout(model, learning::greedy_policy(model), start, options, world, watch);
  if (recording->samples.empty()) {
    const spatial::CellCoordinates cell = model.grid.coordinates(start);
    return fail(ErrorCode::kCheckFailed, fmt::format("the tool cannot be led to the cell {},{},{}: {}", cell.x, cell.y,
                                                     cell.z, to_string(recorded.result.end)));
  }

  simulation::WorldOptions scene;
  scene.seed = options.seed;
  recording->provenance = provenance_on(scene, options.seed, options.block, options.goal);
  recording->provenance.operator_kind = "agent";
  recording->provenance.device = "rollout";
  recorded.recording = std::move(recording);
  return recorded;
}

}  // namespace trocar::trial
