#include "engine/workbench/jobs/report_job.h"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>
#include <utility>

#include "engine/core/ending.h"
#include "engine/core/file.h"
#include "engine/learning/rollout.h"
#include "engine/learning/rollout_spread.h"
#include "engine/learning/start_file.h"
#include "engine/peg_board/obstacles.h"
#include "engine/statistics/proportion.h"
#include "engine/workbench/jobs/plot_job.h"

namespace trocar::workbench {
namespace {

using Cells = std::vector<spatial::CellIndex>;

constexpr std::string_view kStyle =
    "body{font:15px/1.5 Inter,system-ui,sans-serif;color:#1c1e22;max-width:1040px;margin:2em auto;padding:0 1em}"
    "h1{font-size:1.5em;margin-bottom:0}h2{font-size:1.1em;margin-top:2em}p.quiet{color:#5a6069}"
    "table{border-collapse:collapse}th,td{padding:.25em .9em .25em 0;text-align:right;border-bottom:1px solid #dcdfe4}"
    "th:first-child,td:first-child{text-align:left}svg{max-width:100%;height:auto}code{font-size:.9em}";

std::string escaped(std::string_view text) {
  std::string safe;
  for (const char c : text) {
    if (c == '&') {
      safe += "&amp;";
    } else if (c == '<') {
      safe += "&lt;";
    } else if (c == '>') {
      safe += "&gt;";
    } else {
      safe += c;
    }
  }
  return safe;
}

/// One model over the starts.
struct Rolled {
  const ModelEntry* entry = nullptr;
  std::string letter;  ///< "A", "B"; "" for one alone.
  learning::Basin basin;
  learning::RolloutSummary chosen;
  learning::RolloutSpread spread;
};

Result<Rolled> rolled(const ModelEntry& entry, std::string letter, const Cells& starts, Progress& progress) {
  const learning::Model& model = *entry.model;
  const std::vector<std::uint8_t> policy = learning::greedy_policy(model);
  Rolled of{&entry, std::move(letter), learning::basin(model, policy), {}, {}};
  of.chosen = learning::summarise(of.basin, starts);
  TROCAR_ASSIGN_OR_RETURN(of.spread,
                          learning::spread_from(model, policy, starts, peg_board::clearances_m(model.grid), progress));
  return of;
}

std::string row(const std::vector<std::string>& cells, std::string_view tag = "td") {
  std::string html = "<tr>";
  for (const std::string& cell : cells) html += fmt::format("<{0}>{1}</{0}>", tag, escaped(cell));
  return html + "</tr>\n";
}

std::string name_of(const Rolled& of) {
  return of.letter.empty() ? of.entry->name : of.letter + ": " + of.entry->name;
}

std::string outcomes_table(const std::vector<Rolled>& models) {
  std::string html = "<h2>How they end</h2>\n<table>\n";
  html += row({"model", "starts", "arrive", "share", "loop", "dead end", "outside", "from above"}, "th");
  for (const Rolled& of : models) {
    const learning::RolloutSummary& s = of.chosen;
    html += row(
        {name_of(of), std::to_string(s.count), std::to_string(s.arrived),
         statistics::percent_text(s.arrived, s.count, 1), std::to_string(s.looped), std::to_string(s.dead_end),
         std::to_string(s.outside),
         of.entry->segment == demonstration::Segment::kA ? statistics::percent_text(s.from_above, s.arrived, 1) : "–"});
  }
  return html + "</table>\n";
}

std::string spread_table(const std::vector<Rolled>& models) {
  std::string html = "<h2>Measures</h2>\n<table>\n";
  html += row({"measure", "model", "end", "rollouts", "least", "quarter", "middle", "three quarters", "most"}, "th");
  for (const learning::RolloutMeasure measure : learning::spread_measures()) {
    const std::string title(learning::words_of(measure).title);
    for (const Rolled& of : models) {
      for (std::size_t e = 0; e < learning::kRolloutEnds; ++e) {
        const auto end = static_cast<learning::RolloutEnd>(e);
        const learning::Spread& s = of.spread.of(measure, end).spread;
        if (s.count == 0) continue;
        const auto text = [measure](double value) { return learning::measure_text(measure, value); };
        html += row({title, of.letter.empty() ? of.entry->name : of.letter, std::string(learning::to_string(end)),
                     std::to_string(s.count), text(s.least), text(s.low), text(s.median), text(s.high), text(s.most)});
      }
    }
  }
  return html + "</table>\n";
}

std::string pair_section(const std::vector<Rolled>& models, const Cells& starts) {
  const learning::PairedComparison paired = learning::compare(models[0].basin, models[1].basin, starts);
  const int all = paired.wins_a + paired.wins_b + paired.ties;
  const statistics::Interval interval = statistics::paired_difference_interval(paired.wins_a, paired.wins_b, all);
  const double share = all == 0 ? 0.0 : static_cast<double>(paired.wins_b - paired.wins_a) / all;
  return fmt::format(
      "<h2>A against B</h2>\n<p>From the same {} starts only A arrives {} times, only B {} times; from the others both "
      "do or neither. "
      "B − A: {} points, 95 % interval {} … {}. McNemar's exact p {}.</p>\n",
      all, paired.wins_a, paired.wins_b, statistics::points_text(share, 1), statistics::points_text(interval.low, 1),
      statistics::points_text(interval.high, 1),
      paired.mcnemar_p < 0.001 ? std::string("&lt; 0.001") : fmt::format("= {:.3f}", paired.mcnemar_p));
}

std::string ends_table(const std::vector<Rolled>& models, const Cells& starts) {
  const learning::OutcomeTable ends = learning::outcome_table(models[0].basin, models[1].basin, starts);
  std::string html = "<table>\n" + row({"A", "B", "starts"}, "th");
  for (std::size_t i = 0; i < ends.size(); ++i) {
    for (std::size_t j = 0; j < ends.size(); ++j) {
      if (ends[i][j] == 0) continue;
      html += row({std::string(learning::to_string(static_cast<learning::RolloutEnd>(i))),
                   std::string(learning::to_string(static_cast<learning::RolloutEnd>(j))), std::to_string(ends[i][j])});
    }
  }
  return html + "</table>\n";
}

/// A figure as the element of a page. Its names are its own, so that those of two drawings do not meet.
Result<std::string> drawn(const ReportRequest& request, PlotKind kind, std::string_view title, Progress& progress) {
  PlotExport plot;
  plot.models = request.models;
  plot.starts = request.starts;
  plot.settings.kind = kind;
  plot.path = temporary_beside(request.path).replace_extension(".svg");
  const Result<PlotReport> written = export_plot(plot, progress);
  auto svg = written ? read_file(plot.path) : Result<std::string>(tl::unexpected(written.error()));
  std::error_code ignored;
  std::filesystem::remove(plot.path, ignored);
  if (!svg) return tl::unexpected(svg.error());
  const std::size_t begin = svg->find("<svg");
  if (begin == std::string::npos) return fail(ErrorCode::kIo, "the figure could not be read again");
  std::string element = svg->substr(begin);
  const std::string own = std::string(to_string(kind)) + "-";
  for (const std::string_view before : {"id=\"", "href=\"#", "url(#"}) {
    for (std::size_t at = element.find(before); at != std::string::npos; at = element.find(before, at)) {
      at += before.size();
      element.insert(at, own);
    }
  }
  return fmt::format("<h2>{}</h2>\n{}\n", title, element);
}

std::string origin_table(const std::vector<Rolled>& models) {
  std::string html = "<h2>Whose they are</h2>\n<table>\n";
  html += row({"model", "id", "method", "segment", "lattice", "hash"}, "th");
  for (const Rolled& of : models) {
    const learning::Model& model = *of.entry->model;
    html +=
        row({name_of(of), std::to_string(of.entry->id.value), std::string(learning::to_string(model.options.method)),
             std::string(1, demonstration::letter(of.entry->segment)), fmt::format("{0} × {0} × {0}", model.grid.n),
             fmt::format("{:016x}", model.hash())});
  }
  return html + "</table>\n";
}

Status check(const ReportRequest& request) {
  if (ending_of(request.path) != ".html") {
    return tl::unexpected(Error(ErrorCode::kInvalidArgument, "a report is written as .html").at(request.path.string()));
  }
  if (request.models.empty() || request.models.size() > 2) {
    return fail(ErrorCode::kInvalidArgument, "a report is of one model, or of two");
  }
  if (request.models.front()->model->grid != request.models.back()->model->grid) {
    return fail(ErrorCode::kInvalidArgument, fmt::format("{} and {} have different lattices",
                                                         request.models.front()->name, request.models.back()->name));
  }
  return {};
}

}  // namespace

Status write_report(const ReportRequest& request, Progress& progress) {
  TROCAR_RETURN_IF_ERROR(check(request));
  TROCAR_ASSIGN_OR_RETURN(const Cells starts, learning::read_starts(request.starts, *request.models.front()->model));
  std::vector<Rolled> models;
  for (const auto& entry : request.models) {
    const std::string letter = request.models.size() < 2 ? "" : models.empty() ? "A" : "B";
    TROCAR_ASSIGN_OR_RETURN(Rolled of, rolled(*entry, letter, starts, progress));
    models.push_back(std::move(of));
  }
  std::string title = "Rollouts of " + models.front().entry->name;
  if (models.size() > 1) title += " and " + models.back().entry->name;
  std::string html = fmt::format(
      "<!doctype html>\n<html lang=\"en\">\n<head><meta charset=\"utf-8\"><title>{0}</title><style>{1}</style>"
      "</head>\n<body>\n<h1>{0}</h1>\n<p class=\"quiet\">from {2} starts ({3})</p>\n",
      escaped(title), kStyle, starts.size(), escaped(request.starts));
  html += outcomes_table(models);
  if (models.size() > 1) html += pair_section(models, starts) + ends_table(models, starts);
  const std::vector<std::pair<PlotKind, std::string_view>> figures{{PlotKind::kArrivals, "Arrivals"},
                                                                   {PlotKind::kBand, "Deviation from the expert"},
                                                                   {PlotKind::kBoxes, "Boxes"},
                                                                   {PlotKind::kMap, "Success map"}};
  for (const auto& [kind, words] : figures) {
    auto figure = drawn(request, kind, words, progress);
    if (figure) {
      html += *figure;
    } else if (figure.error().code() == ErrorCode::kInvalidArgument) {
      // Of a few starts, or none of some steps, there is no band.
      html +=
          fmt::format("<h2>{}</h2>\n<p class=\"quiet\">Not drawn: {}.</p>\n", words, escaped(figure.error().text()));
    } else {
      return tl::unexpected(figure.error());
    }
  }
  html += spread_table(models) + origin_table(models);
  return write_file(request.path, html + "</body>\n</html>\n");
}

}  // namespace trocar::workbench
