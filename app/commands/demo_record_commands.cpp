#include <fmt/format.h>

#include "app/commands/demo_commands.h"
#include "engine/trial/transfer_session.h"
#include "engine/workbench/jobs/record_job.h"

namespace trocar::app {
namespace {

struct RecordArguments {
  std::string project;
  std::string operator_kind = "scripted";
  std::string skill = "expert";
  trial::TransferOptions options;
  std::string name;
};

void bind_record(CLI::App& verb, RecordArguments& arguments) {
  verb.add_option("PROJECT", arguments.project, "The project file")->required();
  verb.add_option("--operator", arguments.operator_kind, "Who drives: scripted")
      ->check(CLI::IsMember({"scripted"}))
      ->capture_default_str();
  verb.add_option("--skill", arguments.skill, "expert, trained or novice")
      ->check(CLI::IsMember({"expert", "trained", "novice"}))
      ->capture_default_str();
  add_seed(verb, arguments.options.seed, "Seed of the blocks' yaw and of the operator's hand");
  verb.add_option("--block", arguments.options.block, "Block and start peg")
      ->check(CLI::Range(0, 5))
      ->capture_default_str();
  verb.add_option("--goal", arguments.options.goal, "Goal peg")->check(CLI::Range(0, 5))->capture_default_str();
  verb.add_option("--time-limit", arguments.options.time_limit_s, "Seconds until the trial is stopped")
      ->check(CLI::Range(1.0, 3600.0))
      ->capture_default_str();
  verb.add_option("--name", arguments.name, "Name (else made from the skill)");
}

Result<Answer> run_record(const RecordArguments& arguments, Console& console) {
  trial::TransferOptions options = arguments.options;
  TROCAR_ASSIGN_OR_RETURN(options.skill, trial::skill_from(arguments.skill));
  TROCAR_ASSIGN_OR_RETURN(workbench::ProjectFile file, open_to_edit(arguments.project, console, Models::kDescribed));
  const std::string name = arguments.name.empty() ? workbench::demonstration_name(*file.project(), options.skill)
                                                  : free_demonstration_name(*file.project(), arguments.name, console);
  const double begin_s = console.clock->now_s();
  TROCAR_ASSIGN_OR_RETURN(const workbench::RecordReport report,
                          workbench::record_transfer(file, options, name, console.progress()));
  const double seconds = console.clock->now_s() - begin_s;
  Answer answer;
  answer.json = demonstration_json(*file.project()->demonstrations.at(report.id));
  answer.json["outcome"] = demonstration::to_string(report.outcome);
  answer.json["duration_s"] = report.duration_s;
  answer.json["samples"] = report.samples;
  answer.json["placed"] = report.placed;
  answer.json["seconds"] = seconds;
  answer.json["realtime_factor"] = seconds > 0.0 ? report.duration_s / seconds : 0.0;
  answer.summary = fmt::format("{}, {}, {:.2f} s, {} samples, {:.0f} × real time",
                               demonstration::to_string(report.outcome), report.placed ? "placed" : "not placed",
                               report.duration_s, report.samples, report.duration_s / std::max(seconds, 1e-9));
  answer.text = fmt::format("Demonstration {} ({}): {}", report.id.value, name, answer.summary);
  return answer;
}

struct ReplayArguments {
  std::string project;
  std::string demonstration;
  bool verify = false;
};

void bind_replay(CLI::App& verb, ReplayArguments& arguments) {
  verb.add_option("PROJECT", arguments.project, "The project file")->required();
  verb.add_option("DEMO", arguments.demonstration, "Its id or name")->required();
  verb.add_flag("--verify", arguments.verify, "Compare the state hashes on the way; exit 1 where they differ");
}

/// The library shows it. Where nothing can be written the answer alone tells.
void keep_found(const std::string& project, demonstration::RecordingId recording, const trial::ReplayResult& result,
                Console& console) {
  Result<workbench::ProjectFile> file =
      open_project(project, console, workbench::ProjectFile::Purpose::kMove, Models::kDescribed);
  const Status kept = file ? file->keep_replay(recording, workbench::found_of(result))
                           : Status(tl::unexpected(std::move(file).error()));
  if (!kept) console.diagnostics.warn("what the replay found is not kept: " + kept.error().text());
}

Result<Answer> run_replay(const ReplayArguments& arguments, Console& console) {
  TROCAR_ASSIGN_OR_RETURN(const workbench::ProjectFile file,
                          open_to_read(arguments.project, console, Models::kDescribed));
  TROCAR_ASSIGN_OR_RETURN(const auto demonstration, find_demonstration(*file.project(), arguments.demonstration));
  TROCAR_ASSIGN_OR_RETURN(const trial::ReplayResult result,
                          trial::replay(*demonstration->recording, console.progress()));
  if (arguments.verify) keep_found(arguments.project, demonstration->recording->id, result, console);
  Answer answer;
  answer.json = {{"id", demonstration->id.value},
                 {"verified", result.verified},
                 {"diverged_at_s", result.diverged_at_s ? Json(*result.diverged_at_s) : Json()},
                 {"placed", result.placed}};
  answer.summary = result.verified ? "the same states, bit for bit"
                                   : fmt::format("diverged at {:.3f} s", result.diverged_at_s.value_or(0.0));
  answer.text = fmt::format("{}: {}", demonstration->name, answer.summary);
  answer.passed = result.verified || !arguments.verify;
  return answer;
}

}  // namespace

void add_demo_record_commands(CLI::App& noun, Action& chosen) {
  add_verb<RecordArguments>(noun, chosen, "record", "Record a bimanual transfer in the simulator", bind_record,
                            run_record);
  add_verb<ReplayArguments>(noun, chosen, "replay", "Re-simulate the recorded input", bind_replay, run_replay);
}

}  // namespace trocar::app
