/// One transfer by one mode: what is asked for, and what came of it ("Shared control", Trial).
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "engine/control/delay_model.h"
#include "engine/demonstration/recording.h"
#include "engine/trial/agent.h"
#include "engine/trial/skill.h"

namespace trocar::trial {

/// MT: the operator does all of A to D. SC: the agent moves the tool in A and C while the left pedal is held.
enum class Mode : std::uint8_t { kManual, kShared };
/// "MT" or "SC", as in the paper.
std::string_view to_string(Mode mode);
/// Errors: kInvalidArgument.
Result<Mode> mode_from(std::string_view text);

struct TrialOptions {
  Mode mode = Mode::kManual;
  Skill skill = Skill::kExpert;  ///< Of the scripted operator; the assistant is always an expert.
  std::uint64_t seed = 1;        ///< The same of both modes: the same world, and the same person on the same day.
  int block = 0;                 ///< 0 … 5.
  int goal = 0;                  ///< 0 … 5.
  /// Where the left tool begins, in W, turned as it is when it is ready; nothing: where it is ready.
  std::optional<Eigen::Vector3d> begin_p_W;
  double time_limit_s = 120.0;
  double scale = 0.2;           ///< Of hand to tool.
  double agent_rate_hz = 20.0;  ///< Cells a second.
  Anchor anchor = Anchor::kBoard;
  control::DelayOptions delay;     ///< From the operator's hand to the arm.
  std::vector<AgentModel> agents;  ///< Of A and C, of as many as there are; none is needed for MT.
};

enum class TrialEventKind : std::uint8_t { kPedal, kState, kGuard, kSegment, kOutcome, kAgent, kIncident };
std::string_view to_string(TrialEventKind kind);
/// A line of the record.
struct TrialEvent {
  std::int64_t tick = 0;
  TrialEventKind kind = TrialEventKind::kState;
  std::string text;
};

/// What the record says besides the samples.
struct TrialCounts {
  int attempts = 0;
  int misses = 0;
  int clutches = 0;
  double clutch_s = 0.0;
  int hand_overs = 0;
  int agent_steps = 0;
  double agent_s = 0.0;          ///< Time that the agent had the arm.
  std::int64_t limit_hits = 0;   ///< Samples at which a limit was hit.
  std::int64_t unreachable = 0;  ///< Likewise at which the arm could not get there.
  double delay_mean_s = 0.0;     ///< As applied.
  double delay_worst_s = 0.0;
  std::array<double, demonstration::kSegmentCount> segment_s{};  ///< Time in each, up to the decision.
};

}  // namespace trocar::trial
