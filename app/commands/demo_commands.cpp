#include "app/commands/demo_commands.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/demonstration/motion.h"
#include "engine/demonstration/sampling_rate.h"

namespace trocar::app {
namespace {

/// A block's or a peg's number; null if unknown.
Json place_json(int place) {
  return place == demonstration::kUnknownPlace ? Json() : Json(place);
}

Json provenance_json(const demonstration::Provenance& provenance) {
  return {{"operator", provenance.operator_kind},  {"skill", provenance.skill},
          {"device", provenance.device},           {"seed", provenance.seed},
          {"block", place_json(provenance.block)}, {"goal", place_json(provenance.goal)},
          {"scene_hash", provenance.scene_hash},   {"software", provenance.software},
          {"created", provenance.created}};
}

/// What is left of each span between the gates.
std::vector<demonstration::SegmentSpan> gated_segments(const demonstration::Demonstration& document) {
  std::vector<demonstration::SegmentSpan> spans;
  for (demonstration::SegmentSpan span : document.segments) {
    span.begin_s = std::max(span.begin_s, document.begin_s);
    span.end_s = std::min(span.end_s, document.end_s);
    if (span.begin_s + demonstration::kTimeTolerance_s < span.end_s) spans.push_back(span);
  }
  return spans;
}

struct ShowArguments {
  std::string project;
  std::string demonstration;
};

Result<Answer> run_show(const ShowArguments& arguments, Console& console) {
  TROCAR_ASSIGN_OR_RETURN(const workbench::ProjectFile file,
                          open_to_read(arguments.project, console, Models::kDescribed));
  TROCAR_ASSIGN_OR_RETURN(const auto demonstration, find_demonstration(*file.project(), arguments.demonstration));
  Answer answer;
  answer.json = demonstration_json(*demonstration);
  answer.summary = fmt::format("{}: {:.2f} s, {} samples", demonstration->name, demonstration->duration_s(),
                               demonstration->gated().size());
  for (const auto& [key, value] : answer.json.items()) {
    if (!value.is_structured()) answer.text += fmt::format("{:<16} {}\n", key, shown(value));
  }
  for (const auto& [key, value] : answer.json["provenance"].items()) {
    answer.text += fmt::format("{:<16} {}\n", key, shown(value));
  }
  for (const demonstration::SegmentSpan& span : gated_segments(*demonstration)) {
    answer.text += fmt::format("segment {}        {:.2f} … {:.2f} s\n", demonstration::letter(span.label), span.begin_s,
                               span.end_s);
  }
  answer.text.pop_back();
  return answer;
}

}  // namespace

Json demonstration_json(const demonstration::Demonstration& document) {
  const demonstration::RecordingInfo& recording = *document.recording;
  const std::size_t samples = document.gated().size();
  const double duration_s = document.duration_s();
  Json segments = Json::array();
  for (const demonstration::SegmentSpan& span : gated_segments(document)) {
    segments.push_back({{"label", std::string(1, demonstration::letter(span.label))},
                        {"begin_s", span.begin_s},
                        {"end_s", span.end_s}});
  }
  return {{"id", document.id.value},
          {"name", document.name},
          {"duration_s", duration_s},
          {"begin_s", document.begin_s},
          {"end_s", document.end_s},
          {"samples", samples},
          {"rate_hz", samples > 1 ? demonstration::usual_rate_hz(document.gated()) : 0.0},
          {"segments", segments},
          {"path_length_m", demonstration::path_length_m(document, 0)},
          {"outcome", demonstration::to_string(document.outcome())},
          {"placed", document.placed()},
          {"edited_since", document.motion_edited()},
          {"outcome_doubt", document.outcome_doubt()},
          {"recorded_outcome", demonstration::to_string(recording.outcome)},
          {"recovered", recording.recovered},
          {"hash", hash_text(document.hash())},
          {"provenance", provenance_json(recording.provenance)}};
}

void add_demo_commands(CLI::App& root, Action& chosen) {
  CLI::App& noun =
      *root.add_subcommand("demo", "Record, edit, check, replay and exchange demonstrations")->require_subcommand(1);
  add_demo_record_commands(noun, chosen);
  add_demo_library_commands(noun, chosen);
  add_verb<ShowArguments>(
      noun, chosen, "show", "Say everything about one demonstration",
      [](CLI::App& verb, ShowArguments& a) {
        verb.add_option("PROJECT", a.project, "The project file")->required();
        verb.add_option("DEMO", a.demonstration, "Its id or name")->required();
      },
      run_show);
  add_demo_edit_commands(noun, chosen);
  add_demo_stack_command(noun, chosen);
  add_demo_copy_commands(noun, chosen);
  add_demo_review_commands(noun, chosen);
  add_demo_diff_command(noun, chosen);
  add_demo_plot_command(noun, chosen);
  add_demo_exchange_commands(noun, chosen);
}

}  // namespace trocar::app
