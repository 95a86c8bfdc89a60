/// What can be stepped in the simulation thread and recorded there, whoever drives it.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/demonstration/recording.h"
#include "engine/simulation/world_state.h"
#include "engine/trial/trial_status.h"

namespace trocar::trial {

/// Where a take stands. Scripted transfers are recorded from their first tick to their last.
enum class Phase : std::uint8_t {
  kLeadIn,     ///< The arms are led to where the take begins.
  kCountdown,  ///< The simulator runs; nothing is recorded yet.
  kRecording,
  kPaused,  ///< Simulated time stands.
  kEnded,
};

/// What became of the last wish for one arm, and of all before.
struct ArmReport {
  bool limited = false;            ///< A limit of speed, acceleration, turn or jaw, or the floor.
  std::string refusal;             ///< Why the arm cannot reach it; "" if it can.
  std::int64_t limited_count = 0;  ///< Samples of the take.
  std::int64_t refused_count = 0;
  std::optional<spatial::Pose> waypoint;  ///< X_WT: where the tool will go when told to.
};

struct SessionStatus {
  Phase phase = Phase::kRecording;
  double countdown_s = 0.0;        ///< Until recording begins.
  double pre_roll_s = 0.0;         ///< What could be kept of the time before it.
  std::array<ArmReport, 2> arms;   ///< By `kinematics::index_of`.
  bool clutch = false;             ///< Held.
  std::int64_t dropped_input = 0;  ///< What the operator did and nobody could take in any more.
};

/// A word that the recorder says about an instant.
struct TakeNote {
  std::int64_t tick = 0;
  std::string text;
};

/// Threads: the simulation thread, where a class does not say otherwise.
class LiveSession {
 public:
  virtual ~LiveSession() = default;

  /// One millisecond of wall time, and one tick unless the session is paused. No effect once `done()`.
  virtual void step() = 0;
  virtual bool done() const = 0;
  virtual const simulation::WorldState& state() const = 0;
  virtual demonstration::Segment segment() const = 0;
  virtual demonstration::Authority authority() const = 0;
  virtual demonstration::Outcome outcome() const = 0;
  virtual bool placed() const = 0;
  virtual SessionStatus status() const { return {}; }

  /// The world in which the recording begins, once, when it begins.
  virtual std::optional<std::string> take_initial_world() = 0;
  /// What was recorded since the last call, in order. The setpoint of a sample is where the arm was told to be at the
  /// sample's tick; from one sample to the next the commands are interpolated (`between`).
  virtual std::vector<demonstration::Sample> take_samples() = 0;
  /// State hashes at the start, every second, and at the end.
  virtual std::vector<demonstration::HashMark> take_marks() = 0;
  virtual std::vector<TakeNote> take_notes() { return {}; }
  /// Of a trial; nothing else has them.
  virtual std::optional<TrialStatus> trial_status() const { return std::nullopt; }
  virtual std::vector<TrialEvent> take_events() { return {}; }
};

}  // namespace trocar::trial
