#include "engine/workbench/trial_results.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "engine/core/ending.h"
#include "engine/media/picture_file.h"
#include "engine/statistics/summary.h"

namespace trocar::workbench {
namespace {

using demonstration::Outcome;
using trial::TrialRecord;

std::string operator_of(const TrialRecord& record) {
  return record.skill.empty() ? record.operator_kind : record.operator_kind + " " + record.skill;
}

ModeResults of_mode(const Trials& trials, trial::Mode mode) {
  ModeResults results;
  int counted = 0;
  for (const auto& each : trials) {
    const TrialRecord& record = each->record;
    if (record.mode != mode) continue;
    if (was_stopped(record)) {
      ++results.stopped;
      continue;
    }
    ++results.trials;
    results.placed += record.placed ? 1 : 0;
    results.dropped += record.outcome == Outcome::kDropped ? 1 : 0;
    results.misses += record.counts.misses;
    results.clutches += record.counts.clutches;
    results.clutch_s += record.counts.clutch_s;
    if (record.outcome != Outcome::kSuccess || !record.completion_s) continue;
    ++results.succeeded;
    ++counted;
    results.completion_s.push_back(*record.completion_s);
    results.path_m += record.metrics.path_length_m;
    results.economy += record.metrics.economy;
    results.smoothness += record.metrics.smoothness;
    results.agent_share += record.metrics.agent_share;
    for (std::size_t i = 0; i < results.segment_s.size(); ++i) results.segment_s[i] += record.counts.segment_s[i];
  }
  results.success = statistics::wilson_interval(results.succeeded, results.trials);
  if (results.trials > 0) {
    results.success_share = static_cast<double>(results.succeeded) / results.trials;
    results.clutch_s /= results.trials;
  }
  if (counted == 0) return results;
  for (double* mean : {&results.path_m, &results.economy, &results.smoothness, &results.agent_share}) *mean /= counted;
  for (double& segment_s : results.segment_s) segment_s /= counted;
  results.mean_s = statistics::mean(results.completion_s);
  results.deviation_s = counted > 1 ? statistics::standard_deviation(results.completion_s) : 0.0;
  results.median_s = statistics::median(results.completion_s);
  return results;
}

/// The tests of differences that are there.
void test_differences(PairedResults& results) {
  results.pairs = static_cast<int>(results.differences_s.size());
  if (results.pairs > 0) results.mean_s = statistics::mean(results.differences_s);
  if (results.pairs > 1) results.deviation_s = statistics::standard_deviation(results.differences_s);
  results.normality = statistics::shapiro_wilk(results.differences_s);
  results.t = statistics::paired_t(results.differences_s);
  results.signed_rank = statistics::wilcoxon_signed_rank(results.differences_s);
}

PairedResults paired(const Trials& trials) {
  // The same person or script, scene and conditions; in shared control the models are the mode's own matter.
  using Key = std::tuple<std::string, std::string, std::uint64_t, int, int, std::string, double>;
  std::map<Key, std::array<const TrialRecord*, 2>> pairs;
  for (const auto& each : trials) {
    const TrialRecord& record = each->record;
    const Key key{record.subject, operator_of(record), record.seed, record.block,
                  record.goal,    record.delay,        record.scale};
    // What was stopped tells nothing of the mode. Run again, the last one counts.
    if (was_stopped(record)) continue;
    pairs[key][record.mode == trial::Mode::kManual ? 0 : 1] = &record;
  }
  PairedResults results;
  for (const auto& [key, both] : pairs) {
    if (both[0] == nullptr || both[1] == nullptr) continue;
    const bool manual = both[0]->outcome == Outcome::kSuccess;
    const bool shared = both[1]->outcome == Outcome::kSuccess;
    results.only_manual_succeeds += manual && !shared ? 1 : 0;
    results.only_shared_succeeds += shared && !manual ? 1 : 0;
    if (!manual || !shared || !both[0]->completion_s || !both[1]->completion_s) continue;
    results.completion_s.push_back({*both[0]->completion_s, *both[1]->completion_s});
    results.differences_s.push_back(*both[0]->completion_s - *both[1]->completion_s);
  }
  results.mcnemar_p = statistics::mcnemar_exact_p(results.only_manual_succeeds, results.only_shared_succeeds);
  test_differences(results);
  return results;
}

std::string participant_of(const TrialRecord& record) {
  if (record.subject.empty()) return operator_of(record);
  return record.operator_kind == "scripted" ? fmt::format("{} ({})", record.subject, operator_of(record))
                                            : record.subject;
}

std::vector<Participant> participants_of(const Trials& trials) {
  std::map<std::string, Trials> by_name;
  for (const auto& each : trials) by_name[participant_of(each->record)].push_back(each);
  std::vector<Participant> participants;
  for (const auto& [name, own] : by_name) {
    participants.push_back({name,
                            own.front()->record.operator_kind,
                            {of_mode(own, trial::Mode::kManual), of_mode(own, trial::Mode::kShared)}});
  }
  return participants;
}

PairedResults one_value_each(const std::vector<Participant>& participants) {
  PairedResults results;
  for (const Participant& each : participants) {
    if (each.modes[0].succeeded == 0 || each.modes[1].succeeded == 0) continue;
    results.completion_s.push_back({each.modes[0].mean_s, each.modes[1].mean_s});
    results.differences_s.push_back(each.modes[0].mean_s - each.modes[1].mean_s);
  }
  test_differences(results);
  return results;
}

}  // namespace

bool was_stopped(const TrialRecord& record) {
  return record.interrupted || record.outcome == Outcome::kAborted || record.outcome == Outcome::kFault;
}

Trials counted_trials(const Project& project, const std::string& session) {
  Trials trials;
  for (const auto& [id, trial] : project.trials) {
    const bool counts = !trial->excluded && trial->record.in_results;
    if (counts && (session.empty() || trial->record.session == session)) trials.push_back(trial);
  }
  return trials;
}

figure::PairedFigure results_figure(const Trials& trials, const TrialResults& results) {
  figure::PairedFigure drawn;
  drawn.title = "Manual and shared control";
  drawn.label = operators_label(results);
  drawn.scripted = results.scripted;
  drawn.unit = "s, of those that succeed";
  drawn.measures = {{"all", {}}, {"A", {}}, {"B", {}}, {"C", {}}, {"D", {}}};
  for (const auto& each : trials) {
    const TrialRecord& record = each->record;
    if (record.outcome != Outcome::kSuccess || !record.completion_s) continue;
    const std::size_t group = record.mode == trial::Mode::kManual ? 0 : 1;
    drawn.measures[0].values[group].push_back(*record.completion_s);
    for (std::size_t i = 1; i < drawn.measures.size(); ++i) {
      drawn.measures[i].values[group].push_back(record.counts.segment_s[i - 1]);
    }
  }
  drawn.pairs_title = "s, the same scene";
  drawn.pairs = results.paired.completion_s;
  if (results.participants.size() < 2) return drawn;
  for (const Participant& each : results.participants) {
    drawn.panels.push_back({each.name, {each.modes[0].completion_s, each.modes[1].completion_s}});
  }
  return drawn;
}

Status write_results_figure(const Trials& trials, const TrialResults& results, const std::string& preset,
                            const std::filesystem::path& path) {
  figure::PairedFigure drawn = results_figure(trials, results);
  if (!preset.empty()) {
    TROCAR_ASSIGN_OR_RETURN(drawn.print, figure::print_from(preset));
  }
  if (ending_of(path) != ".png") return figure::save_paired(drawn, path);
  return media::write_png(path, figure::draw_paired(drawn),
                          drawn.print ? std::optional(drawn.print->dpi) : std::nullopt);
}

TrialResults results_of(const Trials& trials) {
  TrialResults results;
  results.modes = {of_mode(trials, trial::Mode::kManual), of_mode(trials, trial::Mode::kShared)};
  results.paired = paired(trials);
  results.participants = participants_of(trials);
  results.by_participant = one_value_each(results.participants);
  std::set<std::string> operators;
  for (const auto& each : trials) {
    operators.insert(operator_of(each->record));
    const bool script = each->record.operator_kind == "scripted";
    results.scripted = results.scripted || script;
    results.mixed = results.mixed || !script;
  }
  results.mixed = results.mixed && results.scripted;
  results.operators.assign(operators.begin(), operators.end());
  return results;
}

}  // namespace trocar::workbench
