/// A hand-filled state while a person records, and one in which the take waits for its verdict.
#pragma once

#include "engine/kinematics/psm.h"
#include "tests/support/ui_state.h"

namespace trocar::testing {

/// The first 5 s of a demonstration as a recording that goes on has them.
inline std::shared_ptr<const workbench::LiveTrace> made_trace() {
  workbench::LiveTracer tracer;
  const auto recording = made_recording(1);
  tracer.add(std::span(recording->samples).first(1000));
  return tracer.trace();
}

inline workbench::WorkbenchState take_state(trial::Phase phase = trial::Phase::kRecording) {
  workbench::WorkbenchState state = made_state();
  state.live.emplace().elapsed_s = 12.4;
  state.live->samples = 2480;
  state.live->rate_hz = 200.0;
  state.live->status.phase = phase;
  state.live->status.countdown_s = 2.4;
  for (const auto side : kinematics::kArmSides) {
    state.live->world.arms[kinematics::index_of(side)].X_WT = kinematics::ready_pose(side);
  }
  state.live_trace = phase == trial::Phase::kRecording ? made_trace() : nullptr;
  state.disk_free_bytes = 41'300'000'000;
  state.take.emplace().name = "By hand 1";
  state.take->request.options.sources = {trial::ArmSource::kHand, trial::ArmSource::kHand};
  state.camera_preset = scene::CameraPreset::kPaper;
  return state;
}

inline workbench::WorkbenchState verdict_state() {
  workbench::WorkbenchState state = take_state();
  state.take->reviewing = true;
  state.take->summary = "12.4 s, 2480 samples: unfinished; left arm out of reach in 3 samples";
  return state;
}

}  // namespace trocar::testing
