#include <fmt/format.h>

#include <optional>

#include "app/commands/demo_commands.h"
#include "engine/spatial/units.h"
#include "engine/workbench/comparing.h"

namespace trocar::app {
namespace {

using demonstration::Comparison;
using spatial::to_mm;

struct DiffArguments {
  std::string project;
  std::string demonstration;
  std::string against = "original";
  std::string align = "time";
  std::string format = "text";
};

void bind_diff(CLI::App& verb, DiffArguments& arguments) {
  verb.add_option("PROJECT", arguments.project, "The project file")->required();
  verb.add_option("DEMO", arguments.demonstration, "Its id or name")->required();
  verb.add_option("--against", arguments.against,
                  "`original` (as it was recorded), `history:N` (as it was at that point), or another demonstration")
      ->capture_default_str();
  verb.add_option("--align", arguments.align,
                  "Which instants answer to each other: by time, share of the path (arc), dynamic time warping (dtw), "
                  "or share of the segment")
      ->check(CLI::IsMember({"time", "arc", "dtw", "segment"}))
      ->capture_default_str();
  verb.add_option("--format", arguments.format, "text, or md: a table for a code review")
      ->check(CLI::IsMember({"text", "md"}))
      ->capture_default_str();
}

Result<workbench::Against> against_from(const std::string& text, const workbench::Project& project) {
  workbench::Against against;
  if (text == "original") return against;
  TROCAR_ASSIGN_OR_RETURN(const std::optional<std::int64_t> node, workbench::history_point_from(text));
  if (node) {
    against.kind = workbench::Against::Kind::kHistory;
    against.node = *node;
    return against;
  }
  TROCAR_ASSIGN_OR_RETURN(const auto other, find_demonstration(project, text));
  against.kind = workbench::Against::Kind::kDemonstration;
  against.demonstration = other->id;
  return against;
}

Json deviation_json(const demonstration::Deviation& deviation) {
  return {{"max_mm", to_mm(deviation.max_m)},
          {"mean_mm", to_mm(deviation.mean_m)},
          {"share_95_mm", to_mm(deviation.share_95_m)}};
}

using MeanJerks = std::array<std::optional<double>, 2>;

Json side_json(double duration_s, const std::array<double, 2>& path_m, const MeanJerks& jerk_m_s3) {
  Json jerks = Json::array();
  for (const std::optional<double>& jerk : jerk_m_s3) jerks.push_back(jerk ? Json(*jerk) : Json());
  return {{"duration_s", duration_s}, {"path_length_m", path_m}, {"mean_raw_jerk_m_s3", std::move(jerks)}};
}

Json comparison_json(const Comparison& comparison, const DiffArguments& arguments, std::int64_t id) {
  const demonstration::Difference& difference = comparison.difference;
  return {{"id", id},
          {"against", arguments.against},
          {"align", arguments.align},
          {"duration_change_s", difference.duration_change_s},
          {"removed", difference.removed},
          {"added", difference.added},
          {"moved", difference.moved},
          {"max_deviation_mm", to_mm(difference.max_deviation_m)},
          {"rms_deviation_mm", to_mm(difference.rms_deviation_m)},
          {"mean_deviation_mm", to_mm(comparison.both.mean_m)},
          {"share_95_deviation_mm", to_mm(comparison.both.share_95_m)},
          {"left", deviation_json(comparison.deviation[0])},
          {"right", deviation_json(comparison.deviation[1])},
          {"before", side_json(comparison.before_s, comparison.path_before_m, comparison.jerk_before_m_s3)},
          {"after", side_json(comparison.after_s, comparison.path_after_m, comparison.jerk_after_m_s3)},
          {"cells_lost", comparison.cells_lost},
          {"cells_gained", comparison.cells_gained},
          {"labels", comparison.labels}};
}

std::string jerk_words(const std::optional<double>& jerk_m_s3) {
  return jerk_m_s3 ? fmt::format("{:.2f} m/s³", *jerk_m_s3) : "unknown";
}

std::string details(const Comparison& comparison) {
  std::string text;
  constexpr std::array<const char*, 2> kArms{"left", "right"};
  for (std::size_t arm = 0; arm < 2; ++arm) {
    const demonstration::Deviation& deviation = comparison.deviation[arm];
    text += fmt::format(
        "\n  {:<5} deviates by at most {:.2f} mm, {:.2f} mm on average, 95 % by less than {:.2f} mm; its path was "
        "{:.1f} mm, is {:.1f} mm; its mean raw jerk (tremor included) was {}, is {}",
        kArms[arm], to_mm(deviation.max_m), to_mm(deviation.mean_m), to_mm(deviation.share_95_m),
        to_mm(comparison.path_before_m[arm]), to_mm(comparison.path_after_m[arm]),
        jerk_words(comparison.jerk_before_m_s3[arm]), jerk_words(comparison.jerk_after_m_s3[arm]));
  }
  text += fmt::format("\n  cells of the lattice: {} lost, {} gained", comparison.cells_lost, comparison.cells_gained);
  for (const std::string& clause : comparison.labels) text += "\n  " + clause;
  return text;
}

Result<Answer> run_diff(const DiffArguments& arguments, Console& console) {
  TROCAR_ASSIGN_OR_RETURN(const demonstration::Alignment alignment, demonstration::alignment_from(arguments.align));
  TROCAR_ASSIGN_OR_RETURN(const workbench::ProjectFile file,
                          open_to_read(arguments.project, console, Models::kDescribed));
  TROCAR_ASSIGN_OR_RETURN(const auto after, find_demonstration(*file.project(), arguments.demonstration));
  TROCAR_ASSIGN_OR_RETURN(const workbench::Against against, against_from(arguments.against, *file.project()));
  const auto project_at = [&file](std::int64_t node) { return file.project_at(node); };
  TROCAR_ASSIGN_OR_RETURN(const auto before, workbench::counterpart(*after, against, *file.project(), project_at));
  TROCAR_ASSIGN_OR_RETURN(Comparison comparison, demonstration::compare(*before, *after, alignment, spatial::Grid{}));
  if (before->name != after->name) {
    comparison.labels.push_back(fmt::format("named {}, not {}", after->name, before->name));
  }
  const demonstration::Difference& difference = comparison.difference;
  Answer answer;
  answer.json = comparison_json(comparison, arguments, after->id.value);
  answer.summary =
      fmt::format("{:+.2f} s, {} samples removed, {} added, {} moved (at most {:.2f} mm)", difference.duration_change_s,
                  difference.removed, difference.added, difference.moved, to_mm(difference.max_deviation_m));
  const std::string title = fmt::format("{} against {}", after->name, workbench::described(against, *before));
  if (arguments.format == "md") {
    answer.text = demonstration::to_markdown(comparison, title);
    answer.text.pop_back();
    answer.json["markdown"] = answer.text;
  } else {
    answer.text = fmt::format("{}: {}{}", title, answer.summary, details(comparison));
  }
  if (!comparison.labels.empty()) {
    answer.summary += fmt::format(", {}", counted(comparison.labels.size(), "other change"));
  }
  return answer;
}

}  // namespace

void add_demo_diff_command(CLI::App& noun, Action& chosen) {
  add_verb<DiffArguments>(noun, chosen, "diff", "Say what edits changed, or how two demonstrations differ", bind_diff,
                          run_diff);
}

}  // namespace trocar::app
