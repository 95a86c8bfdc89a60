/// A take that a person drives live in the simulator: one arm or both, the rest by script, by replay, or at rest.
#pragma once

#include <array>
#include <memory>
#include <optional>

#include "engine/control/setpoint_limiter.h"
#include "engine/core/result.h"
#include "engine/trial/hand_event.h"
#include "engine/trial/live_session.h"
#include "engine/trial/transfer_session.h"

namespace trocar::trial {

enum class ArmSource : std::uint8_t {
  kHand,      ///< The operator.
  kScripted,  ///< As in a scripted transfer: the user on the left, the assistant on the right.
  kReplay,    ///< The setpoints of a demonstration.
  kStill,
};
std::string_view to_string(ArmSource source);

/// Setpoints of both arms every 5 ticks, by `kinematics::index_of`.
using Setpoints = std::vector<std::array<control::ToolCommand, 2>>;

struct HandOptions {
  std::array<ArmSource, 2> sources{ArmSource::kHand, ArmSource::kScripted};  ///< By `kinematics::index_of`.
  HandMode mode = HandMode::kContinuous;
  Skill skill = Skill::kExpert;  ///< Of the scripted arms.
  std::uint64_t seed = 1;
  int block = 0;              ///< 0 … 5.
  int goal = 0;               ///< 0 … 5.
  double countdown_s = 3.0;   ///< 0: recording begins at once.
  bool pre_roll = false;      ///< Keeps up to 5 s from before the recording began.
  double time_limit_s = 600;  ///< The take ends then by itself.

  std::string operator_kind = "person";  ///< "scripted" where a script plays the operator.
  std::string device = "keyboard";       ///< Of the arms that the operator drives.

  /// Where the take begins, if not in a new world: a world, and the setpoints that lead from it to the beginning.
  std::string initial_world;
  /// A scripted expert plays until this segment begins; not together with `initial_world`.
  std::optional<demonstration::Segment> begin_segment;
  Setpoints lead_in;
  /// What replayed arms do from the beginning of the recording on; they hold after its end. All arms are led to its
  /// first setpoints before.
  Setpoints replay;
  std::string replay_of;  ///< The demonstration's name.
  /// Where the tips are led before the recording begins, each turned as it is; none: nowhere. W, metres.
  std::array<std::optional<Eigen::Vector3d>, 2> begin_p_WT;
};

/// Threads: `post` in the interface's, everything else in one other (or the same).
class HandSession final : public LiveSession {
 public:
  /// Errors: kInvalidArgument for a block or goal outside of 0 … 5, times that are negative or not finite, no arm that
  /// the operator drives, a replay without setpoints, or two places to begin in; those of `simulation::World::restore`.
  static Result<std::unique_ptr<HandSession>> create(HandOptions options);
  ~HandSession() override;

  /// Takes effect with the next sample. False if so much waits already that it was dropped, which is counted.
  bool post(const HandEvent& event);

  const demonstration::Provenance& provenance() const;
  const HandOptions& options() const;

  /// Leading in takes as many steps as it needs, many ticks each.
  void step() override;
  bool done() const override;
  const simulation::WorldState& state() const override;
  demonstration::Segment segment() const override;
  demonstration::Authority authority() const override;
  demonstration::Outcome outcome() const override;
  bool placed() const override;
  SessionStatus status() const override;
  std::optional<std::string> take_initial_world() override;
  std::vector<demonstration::Sample> take_samples() override;
  std::vector<demonstration::HashMark> take_marks() override;
  /// Where the operator paused.
  std::vector<TakeNote> take_notes() override;

 private:
  struct Impl;
  explicit HandSession(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace trocar::trial
