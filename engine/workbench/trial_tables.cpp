// Trials as text: tidy tables, what a person reads, and a page.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <cmath>

#include "engine/workbench/trial_results.h"

namespace trocar::workbench {
namespace {

using trial::TrialRecord;

/// A field of a table: quoted where it must be.
std::string field(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

std::string who(const TrialEntry& trial) {
  const TrialRecord& record = trial.record;
  return fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{}", trial.id.value, field(trial.name), field(record.session),
                     field(record.subject), record.operator_kind, field(record.skill), record.assistant,
                     to_string(record.mode), record.block_number, record.transfer, record.seed, record.block,
                     record.goal);
}
constexpr std::string_view kWho =
    "trial,name,session,subject,operator,skill,assistant,mode,block_number,transfer,seed,block,goal";

std::string number(double value) {
  return std::isfinite(value) ? fmt::format("{:.6g}", value) : "";
}

/// In a sentence.
std::string said(double value) {
  return std::isfinite(value) ? number(value) : "–";
}

std::string p_words(double p) {
  if (!std::isfinite(p)) return "not defined";
  return p < 0.001 ? "< 0.001" : fmt::format("{:.3f}", p);
}

std::string escaped(const std::string& text) {
  std::string html;
  for (const char c : text) {
    if (c == '&')
      html += "&amp;";
    else if (c == '<')
      html += "&lt;";
    else if (c == '>')
      html += "&gt;";
    else
      html += c;
  }
  return html;
}

}  // namespace

std::string trials_csv(const Project& project, const std::string& session) {
  std::string csv(kWho);
  csv +=
      ",outcome,placed,interrupted,in_results,completion_s,duration_s,attempts,misses,clutches,clutch_s,hand_overs,"
      "agent_s,"
      "agent_share,agent_steps,path_length_m,economy,smoothness,limit_hits,unreachable,delay,delay_mean_s,"
      "delay_worst_s,anchor,scale,agent_rate_hz,begin_x_m,begin_y_m,begin_z_m,models,excluded,reason\n";
  for (const auto& [id, trial] : project.trials) {
    const TrialRecord& r = trial->record;
    if (!session.empty() && r.session != session) continue;
    std::string models;
    for (const auto& model : r.models) {
      models += fmt::format("{}{}:{}:{:016x}", models.empty() ? "" : " ", demonstration::letter(model.segment),
                            model.name, model.hash);
    }
    std::string begin = ",,";
    if (r.begin_p_W) {
      begin = fmt::format("{},{},{}", number(r.begin_p_W->x()), number(r.begin_p_W->y()), number(r.begin_p_W->z()));
    }
    csv += who(*trial);
    csv += fmt::format(
        ",{},{:d},{:d},{:d},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{:d},{}\n",
        to_string(r.outcome), r.placed, r.interrupted, r.in_results, r.completion_s ? number(*r.completion_s) : "",
        number(r.duration_s), r.counts.attempts, r.counts.misses, r.counts.clutches, number(r.counts.clutch_s),
        r.counts.hand_overs, number(r.counts.agent_s), number(r.metrics.agent_share), r.counts.agent_steps,
        number(r.metrics.path_length_m), number(r.metrics.economy), number(r.metrics.smoothness), r.counts.limit_hits,
        r.counts.unreachable, field(r.delay), number(r.counts.delay_mean_s), number(r.counts.delay_worst_s),
        to_string(r.anchor), number(r.scale), number(r.agent_rate_hz), begin, field(models), trial->excluded,
        field(trial->reason));
  }
  return csv;
}

std::string segments_csv(const Project& project, const std::string& session) {
  std::string csv(kWho);
  csv += ",outcome,segment,seconds,excluded\n";
  for (const auto& [id, trial] : project.trials) {
    const TrialRecord& r = trial->record;
    if (!session.empty() && r.session != session) continue;
    for (std::size_t i = 0; i < r.counts.segment_s.size(); ++i) {
      csv += fmt::format("{},{},{},{},{:d}\n", who(*trial), to_string(r.outcome),
                         demonstration::letter(static_cast<demonstration::Segment>(i)), number(r.counts.segment_s[i]),
                         trial->excluded);
    }
  }
  return csv;
}

std::string participants_csv(const TrialResults& results) {
  std::string csv =
      "participant,operator,mode,trials,stopped,succeeded,dropped,completion_mean_s,completion_sd_s,completion_median_"
      "s\n";
  constexpr std::array<trial::Mode, 2> kModes{trial::Mode::kManual, trial::Mode::kShared};
  for (const Participant& each : results.participants) {
    for (std::size_t i = 0; i < kModes.size(); ++i) {
      const ModeResults& m = each.modes[i];
      const bool any = m.succeeded > 0;
      csv += fmt::format("{},{},{},{},{},{},{},{},{},{}\n", field(each.name), each.operator_kind, to_string(kModes[i]),
                         m.trials, m.stopped, m.succeeded, m.dropped, any ? number(m.mean_s) : "",
                         m.succeeded > 1 ? number(m.deviation_s) : "", any ? number(m.median_s) : "");
    }
  }
  return csv;
}

std::string operators_label(const TrialResults& results) {
  std::string words = fmt::format("{}", fmt::join(results.operators, ", "));
  if (results.mixed) return words + "; made by scripts and by persons together";
  if (results.scripted) words += "; made by a script, no person took part";
  return words;
}

std::vector<std::string> paired_lines(const PairedResults& paired) {
  if (paired.pairs == 0) return {"No pair of trials with the same seed, block and operator succeeded in both modes"};
  return {fmt::format("Pairs that succeed in both modes: {}; MT − SC: mean {:+.2f} s, standard deviation {:.2f} s",
                      paired.pairs, paired.mean_s, paired.deviation_s),
          fmt::format("Shapiro-Wilk of the differences: W = {}, p = {}", said(paired.normality.w),
                      p_words(paired.normality.p)),
          fmt::format("Paired t: t({}) = {}, p = {}, d = {}", paired.t.degrees_of_freedom, said(paired.t.t),
                      p_words(paired.t.p), said(paired.t.effect)),
          fmt::format("Wilcoxon signed rank: W = {}, n = {}, p = {}{}", said(paired.signed_rank.w),
                      paired.signed_rank.count, p_words(paired.signed_rank.p),
                      paired.signed_rank.exact ? " (exact)" : " (normal)"),
          fmt::format("Succeeds in one mode only: MT {}, SC {}; McNemar p = {}", paired.only_manual_succeeds,
                      paired.only_shared_succeeds, p_words(paired.mcnemar_p))};
}

std::vector<ResultRow> result_rows(const TrialResults& results) {
  std::vector<ResultRow> rows;
  const auto row = [&](const char* name, const auto& of) {
    rows.push_back({name, {of(results.modes[0]), of(results.modes[1])}});
  };
  row("Trials", [](const ModeResults& m) { return fmt::format("{}", m.trials); });
  row("Stopped, left out", [](const ModeResults& m) { return fmt::format("{}", m.stopped); });
  row("Succeed", [](const ModeResults& m) {
    return m.trials == 0 ? std::string("–") : fmt::format("{} ({:.0f} %)", m.succeeded, 100.0 * m.success_share);
  });
  row("  95 % interval", [](const ModeResults& m) {
    return m.trials == 0 ? std::string("–")
                         : fmt::format("{:.0f}–{:.0f} %", 100.0 * m.success.low, 100.0 * m.success.high);
  });
  row("Dropped", [](const ModeResults& m) { return fmt::format("{}", m.dropped); });
  row("Placed", [](const ModeResults& m) { return fmt::format("{}", m.placed); });
  // What is a mean of those that succeeded, where any did.
  const auto mean = [&row](const char* name, const char* form, const auto& value) {
    row(name, [&](const ModeResults& m) {
      return m.succeeded == 0 ? std::string("–") : fmt::format(fmt::runtime(form), value(m));
    });
  };
  mean("Completion, mean", "{:.2f} s", [](const ModeResults& m) { return m.mean_s; });
  mean("  standard deviation", "{:.2f} s", [](const ModeResults& m) { return m.deviation_s; });
  mean("  median", "{:.2f} s", [](const ModeResults& m) { return m.median_s; });
  constexpr std::array<const char*, 4> kSegments{"  in A", "  in B", "  in C", "  in D"};
  for (std::size_t i = 0; i < kSegments.size(); ++i) {
    mean(kSegments[i], "{:.2f} s", [i](const ModeResults& m) { return m.segment_s[i]; });
  }
  row("Misses", [](const ModeResults& m) { return fmt::format("{}", m.misses); });
  row("Clutches", [](const ModeResults& m) { return fmt::format("{}", m.clutches); });
  mean("Path, mean", "{:.0f} mm", [](const ModeResults& m) { return 1e3 * m.path_m; });
  mean("Economy, mean", "{:.2f}", [](const ModeResults& m) { return m.economy; });
  mean("Smoothness (SPARC), mean", "{:.2f}", [](const ModeResults& m) { return m.smoothness; });
  mean("Agent's share, mean", "{:.0f} %", [](const ModeResults& m) { return 100.0 * m.agent_share; });
  return rows;
}

std::vector<std::string> participant_lines(const TrialResults& results) {
  if (results.participants.size() < 2) return {};
  std::vector<std::string> lines;
  for (const Participant& each : results.participants) {
    const auto words = [](const ModeResults& m) {
      return m.succeeded == 0 ? fmt::format("0 of {}", m.trials)
                              : fmt::format("{:.2f} s, {} of {}", m.mean_s, m.succeeded, m.trials);
    };
    lines.push_back(fmt::format("{}: MT {}; SC {}", each.name, words(each.modes[0]), words(each.modes[1])));
  }
  const PairedResults& p = results.by_participant;
  if (p.pairs > 1) {
    lines.push_back(
        fmt::format("One value for each of {} participants: MT − SC {:+.2f} s, standard deviation {:.2f} s; "
                    "t({}) = {}, p = {}; Wilcoxon p = {}{}",
                    p.pairs, p.mean_s, p.deviation_s, p.t.degrees_of_freedom, number(p.t.t), p_words(p.t.p),
                    p_words(p.signed_rank.p), p.signed_rank.exact ? " (exact)" : " (normal)"));
  }
  return lines;
}

std::string results_text(const TrialResults& results) {
  std::string text = "Operator: " + operators_label(results) + "\n";
  text += fmt::format("{:<28}{:>14}{:>14}\n", "", "MT", "SC");
  for (const ResultRow& row : result_rows(results)) {
    text += fmt::format("{:<28}{:>14}{:>14}\n", row.name, row.values[0], row.values[1]);
  }
  text += fmt::format("{}", fmt::join(paired_lines(results.paired), "\n"));
  for (const std::string& line : participant_lines(results)) text += "\n" + line;
  return text;
}

std::string results_html(const TrialResults& results, const std::string& title) {
  std::string html =
      "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>" + escaped(title) +
      "</title>\n<style>body{font:16px/1.5 sans-serif;max-width:60rem;margin:2rem auto;padding:0 1rem}"
      "table{border-collapse:collapse}td,th{padding:.2rem .8rem;text-align:right;border-bottom:1px solid "
      "#ccc}td:first-child,th:first-child{text-align:left}.scripted{background:#fde9c8;padding:.4rem "
      ".8rem}</style></head><body>\n";
  html += "<h1>" + escaped(title) + "</h1>\n";
  html += fmt::format("<p{}>Operator: {}</p>\n", results.scripted ? " class=\"scripted\"" : "",
                      escaped(operators_label(results)));
  html += "<table><tr><th></th><th>MT</th><th>SC</th></tr>\n";
  for (const ResultRow& row : result_rows(results)) {
    html += fmt::format("<tr><td>{}</td><td>{}</td><td>{}</td></tr>\n", escaped(row.name), escaped(row.values[0]),
                        escaped(row.values[1]));
  }
  html += "</table>\n<ul>\n";
  for (const std::string& line : paired_lines(results.paired)) html += "<li>" + escaped(line) + "</li>\n";
  for (const std::string& line : participant_lines(results)) html += "<li>" + escaped(line) + "</li>\n";
  html += "</ul>\n";
  if (results.paired.pairs > 0) html += "<table><tr><th>MT, s</th><th>SC, s</th><th>MT − SC, s</th></tr>\n";
  for (const auto& [manual_s, shared_s] : results.paired.completion_s) {
    html += fmt::format("<tr><td>{:.2f}</td><td>{:.2f}</td><td>{:+.2f}</td></tr>\n", manual_s, shared_s,
                        manual_s - shared_s);
  }
  if (results.paired.pairs > 0) html += "</table>\n";
  return html + "</body></html>\n";
}

}  // namespace trocar::workbench
