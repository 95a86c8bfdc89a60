/// What the trials of a project say together: tidy tables, and manual against shared control as in section V.B.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/result.h"
#include "engine/figure/paired_figure.h"
#include "engine/statistics/paired_tests.h"
#include "engine/statistics/proportion.h"
#include "engine/workbench/project.h"

namespace trocar::workbench {

using Trials = std::vector<std::shared_ptr<const TrialEntry>>;

/// Those that count, by id: not excluded, no familiarisation, of this session (""; all).
Trials counted_trials(const Project& project, const std::string& session);

/// One row for each trial, excluded ones too, and one for each of its segments. Every row says who made it: "scripted"
/// or "person".
std::string trials_csv(const Project& project, const std::string& session);
std::string segments_csv(const Project& project, const std::string& session);

/// Aborted, interrupted or ended by a fault: it tells nothing of the mode.
bool was_stopped(const trial::TrialRecord& record);

struct ModeResults {
  int trials = 0;   ///< That were not stopped.
  int stopped = 0;  ///< `was_stopped`.
  int succeeded = 0;
  int dropped = 0;
  int placed = 0;
  int misses = 0;
  int clutches = 0;
  double success_share = 0.0;
  statistics::Interval success;      ///< Wilson, 95 %.
  std::vector<double> completion_s;  ///< Of those that succeeded.
  double mean_s = 0.0;
  double deviation_s = 0.0;  ///< n − 1.
  double median_s = 0.0;
  double clutch_s = 0.0;  ///< A trial, mean.
  double path_m = 0.0;    ///< Likewise.
  double economy = 0.0;
  double smoothness = 0.0;
  double agent_share = 0.0;
  std::array<double, demonstration::kSegmentCount> segment_s{};  ///< Mean of those that succeeded.
};

/// Trials of both modes that had the same seed, block, subject and skill, and both succeeded.
struct PairedResults {
  int pairs = 0;
  std::vector<double> differences_s;  ///< Completion, MT − SC: above 0 shared control was faster.
  std::vector<std::array<double, 2>> completion_s;
  double mean_s = 0.0;
  double deviation_s = 0.0;
  statistics::Normality normality;
  statistics::PairedT t;
  statistics::SignedRank signed_rank;
  int only_manual_succeeds = 0;
  int only_shared_succeeds = 0;
  double mcnemar_p = 1.0;
};

/// One person, or one script, by both modes.
struct Participant {
  std::string name;           ///< The subject's id, of a script with what it is.
  std::string operator_kind;  ///< "scripted" or "person"; one of each with the same id are two.
  std::array<ModeResults, 2> modes;
};

struct TrialResults {
  std::array<ModeResults, 2> modes;       ///< MT, SC.
  std::vector<Participant> participants;  ///< By name.
  /// One value for each participant: the difference of their mean completion times, MT − SC, of those who succeed by
  /// both. What one person does again and again is no further evidence of people.
  PairedResults by_participant;
  PairedResults paired;
  std::vector<std::string> operators;  ///< "scripted expert", "person" …: whose trials these are.
  bool scripted = false;               ///< Any of them: to be labelled so wherever they are shown.
  bool mixed = false;                  ///< Persons' and scripts' together.
};
TrialResults results_of(const Trials& trials);
/// Completion and segments of those that succeed, and each pair: to be drawn.
figure::PairedFigure results_figure(const Trials& trials, const TrialResults& results);
/// As .png, .svg or .pdf; `preset` of `figure::print_from`, "": for a screen. Errors: kInvalidArgument, kIo.
Status write_results_figure(const Trials& trials, const TrialResults& results, const std::string& preset,
                            const std::filesystem::path& path);

/// A line of the table of both modes.
struct ResultRow {
  std::string name;
  std::array<std::string, 2> values;  ///< MT, SC; "–" where there is nothing to say.
};
std::vector<ResultRow> result_rows(const TrialResults& results);
/// Of the paired trials, a test a line.
std::vector<std::string> paired_lines(const PairedResults& paired);
/// A line for each participant, and the test of one value each; none for one alone.
std::vector<std::string> participant_lines(const TrialResults& results);
/// Who it was; says of a script that it is one.
std::string operators_label(const TrialResults& results);

/// One row for each participant and mode: how many trials, successes, mean and spread of completion.
std::string participants_csv(const TrialResults& results);

/// What a person reads: one line each, without a judgement that the numbers do not carry.
std::string results_text(const TrialResults& results);
/// The same as a page of its own, without anything from elsewhere.
std::string results_html(const TrialResults& results, const std::string& title);

}  // namespace trocar::workbench
