/// What a trial leaves beside its samples: how it was run, what came of it, and every event.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/result.h"
#include "engine/demonstration/sample_track.h"
#include "engine/trial/trial_options.h"

namespace trocar::trial {

/// Of the left tool, up to where the outcome was decided.
struct TrialMetrics {
  double path_length_m = 0.0;
  /// Sum of the straight ways of the segments by the length of the path, 0 … 1; 1 is straight. 0 where nothing moved.
  double economy = 0.0;
  /// Spectral arc length of the speed profile (Balasubramanian et al.): at most 0, nearer to 0 is smoother.
  double smoothness = 0.0;
  double agent_share = 0.0;  ///< Of the time.
};

struct TrialRecord {
  Mode mode = Mode::kManual;
  std::string operator_kind;  ///< "scripted" or "person": what a script made is never passed off as a person's.
  std::string skill;          ///< Of a scripted operator.
  std::string assistant = "scripted";  ///< Likewise "scripted" or "person": who has the right arm.
  std::string subject;                 ///< An id, never a name; "" of a script.
  std::string session;                 ///< What was run together has the same.
  int block_number = 0;                ///< Of the protocol, from 0.
  int transfer = 0;                    ///< In its block, from 0.
  bool in_results = true;              ///< Familiarisation is not.
  std::uint64_t seed = 0;
  int block = 0;
  int goal = 0;
  std::optional<Eigen::Vector3d> begin_p_W;  ///< Where the left tool began, if not where it is ready.
  double scale = 0.0;
  double agent_rate_hz = 0.0;
  Anchor anchor = Anchor::kBoard;
  std::string delay;  ///< As `control::to_string` says it.
  /// Name and hash of each model, A and C as far as there are; empty for MT.
  struct ModelUsed {
    std::string name;
    demonstration::Segment segment = demonstration::Segment::kA;
    std::uint64_t hash = 0;
  };
  std::vector<ModelUsed> models;
  demonstration::Outcome outcome = demonstration::Outcome::kUnfinished;
  bool placed = false;
  bool interrupted = false;
  std::optional<double> completion_s;  ///< Of a success only.
  double duration_s = 0.0;
  TrialCounts counts;
  TrialMetrics metrics;
  std::vector<TrialEvent> events;
};

/// From the samples of a trial and when it was decided. Threads: any.
TrialMetrics trial_metrics(const std::vector<demonstration::Sample>& samples, std::optional<double> decided_s,
                           double agent_s);
/// Spectral arc length of a speed profile sampled at `rate_hz`: amplitude threshold 0.05, cut-off at most 10 Hz, zero
/// padding to 2⁴ times the next power of two. 0 for fewer than 8 samples or a tool at rest.
double spectral_arc_length(const std::vector<double>& speed, double rate_hz);

/// As an object, for the journal. The reader takes what it knows and refuses what makes no sense (kCorrupt).
std::string to_json(const TrialRecord& record);
Result<TrialRecord> record_from_json(std::string_view text);

}  // namespace trocar::trial
