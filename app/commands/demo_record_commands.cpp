#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "app/commands/demo_commands.h"
#include "engine/core/file.h"
#include "engine/demonstration/edit_fields.h"
#include "engine/spatial/cell_text.h"
#include "engine/trial/key_script.h"
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
  // Of a take by keys.
  std::string script;
  std::string mode = "continuous";
  std::string left = "hand";
  std::string right;  ///< "": scripted, and in a part that is replaced it goes on as it is.
  std::string replay;
  double time_limit_s = 0.0;  ///< 0: as the operator has it.
  std::string from_cell;
  std::string from_segment = "A";
  int grid = 22;
  double from_s = -1.0;
  double to_s = -1.0;
};

const std::map<std::string, trial::HandMode> kModes{{"continuous", trial::HandMode::kContinuous},
                                                    {"step", trial::HandMode::kStep},
                                                    {"waypoint", trial::HandMode::kWaypoint}};
const std::map<std::string, trial::ArmSource> kSources{{"hand", trial::ArmSource::kHand},
                                                       {"scripted", trial::ArmSource::kScripted},
                                                       {"replay", trial::ArmSource::kReplay},
                                                       {"still", trial::ArmSource::kStill}};

void bind_keys(CLI::App& verb, RecordArguments& arguments) {
  verb.add_option(
      "--script", arguments.script,
      "The file of timed key presses, one a line: \"0.5 hold W 0.3\", \"1 down D\", \"1.4 up D\", \"2 tap C\", "
      "\"3 end\"; seconds first, Shift+W is finer; operator keys");
  verb.add_option("--mode", arguments.mode, "How keys move the tool: continuous, step or waypoint; operator keys")
      ->check(CLI::IsMember(kModes))
      ->capture_default_str();
  verb.add_option("--left", arguments.left, "Who drives the left arm: hand, scripted, replay or still; operator keys")
      ->check(CLI::IsMember(kSources))
      ->capture_default_str();
  verb.add_option("--right", arguments.right,
                  "Who drives the right arm, likewise: scripted if nobody says, and replay where a part is replaced")
      ->check(CLI::IsMember(kSources));
  verb.add_option("--replay", arguments.replay, "The demonstration whose arm is replayed, or part replaced");
  verb.add_option("--from-cell", arguments.from_cell,
                  "I,J,K: lead the left tool into this cell of the lattice before it begins; operator keys");
  verb.add_option("--grid", arguments.grid, "Cells a side of that lattice")
      ->check(CLI::Range(4, 176))
      ->capture_default_str();
  verb.add_option("--from-segment", arguments.from_segment,
                  "Whose beginning the world is at: in C a scripted expert has put the block into the left jaws")
      ->check(CLI::IsMember({"A", "C"}))
      ->capture_default_str();
  verb.add_option("--from", arguments.from_s, "Seconds: replace what is from here …; with --replay")
      ->check(CLI::NonNegativeNumber);
  verb.add_option("--to", arguments.to_s, "… to here by what is recorded")->check(CLI::NonNegativeNumber);
}

void bind_record(CLI::App& verb, RecordArguments& arguments) {
  verb.add_option("PROJECT", arguments.project, "The project file")->required();
  verb.add_option("--operator", arguments.operator_kind, "Who drives: scripted, or keys as in --script")
      ->check(CLI::IsMember({"scripted", "keys"}))
      ->capture_default_str();
  verb.add_option("--skill", arguments.skill, "expert, trained or novice")
      ->check(CLI::IsMember({"expert", "trained", "novice"}))
      ->capture_default_str();
  add_seed(verb, arguments.options.seed, "Seed of the blocks' yaw and of the operator's hand");
  verb.add_option("--block", arguments.options.block, "Block and start peg")
      ->check(CLI::Range(0, 5))
      ->capture_default_str();
  verb.add_option("--goal", arguments.options.goal, "Goal peg")->check(CLI::Range(0, 5))->capture_default_str();
  verb.add_option("--time-limit", arguments.time_limit_s,
                  "Seconds until the trial is stopped: 120 if nobody says, and with operator keys when the script ends")
      ->check(CLI::Range(1.0, 3600.0));
  verb.add_option("--name", arguments.name, "Name (else made from the skill)");
  bind_keys(verb, arguments);
}

Json take_json(const workbench::RecordReport& report) {
  return {{"id", report.take.value},         {"name", report.name},
          {"duration_s", report.duration_s}, {"samples", report.samples},
          {"placed", report.placed},         {"outcome", demonstration::to_string(report.outcome)}};
}

/// What a take replaced of another demonstration: that is what is told of, and the take beside it.
void tell_replaced(const workbench::RecordReport& report, const demonstration::Demonstration& into, Answer& answer) {
  const workbench::TakeTarget& target = *report.replaced;
  const auto arms = demonstration::words_of<demonstration::Arms>()[static_cast<std::size_t>(target.arms)];
  const double from_s = target.span.begin_s;
  answer.json["replaced"] = {
      {"from_s", from_s}, {"to_s", from_s + report.duration_s}, {"wanted_to_s", target.span.end_s}, {"arms", arms}};
  answer.summary =
      fmt::format("{:.2f}–{:.2f} s of {} replaced by \"{}\" ({})", from_s, from_s + report.duration_s,
                  target.arms == demonstration::Arms::kBoth ? "both tools" : fmt::format("the {} tool", arms),
                  report.name, report.take.value);
  if (from_s + report.duration_s < target.span.end_s - demonstration::kTicksPerSample * 2e-3) {
    answer.summary += fmt::format("; it ended before {:.2f} s, and what was there goes on", target.span.end_s);
  }
  answer.summary += fmt::format("; {:.2f} s long as before, how it ends now is {}", into.duration_s(),
                                demonstration::to_string(into.outcome()));
}

Answer answer_of(const workbench::ProjectFile& file, const workbench::RecordReport& report, double seconds) {
  const demonstration::Demonstration& shown = *file.project()->demonstrations.at(report.id);
  Answer answer;
  answer.json = demonstration_json(shown);
  answer.json["take"] = take_json(report);
  answer.json["seconds"] = seconds;
  answer.json["realtime_factor"] = seconds > 0.0 ? report.duration_s / seconds : 0.0;
  if (report.replaced) {
    tell_replaced(report, shown, answer);
  } else {
    answer.json["duration_s"] = report.duration_s;
    answer.json["samples"] = report.samples;
    answer.summary = fmt::format("{}, {}, {:.2f} s, {} samples, {:.0f} × real time",
                                 demonstration::to_string(report.outcome), report.placed ? "placed" : "not placed",
                                 report.duration_s, report.samples, report.duration_s / std::max(seconds, 1e-9));
  }
  answer.text = fmt::format("Demonstration {} ({}): {}", report.id.value, shown.name, answer.summary);
  return answer;
}

Result<workbench::RecordByHand> take_of(const RecordArguments& arguments, const workbench::Project& project) {
  workbench::RecordByHand request;
  const bool punches = arguments.from_s >= 0.0 || arguments.to_s >= 0.0;
  const std::string right = !arguments.right.empty() ? arguments.right : punches ? "replay" : "scripted";
  request.options.sources = {kSources.at(arguments.left), kSources.at(right)};
  request.options.mode = kModes.at(arguments.mode);
  TROCAR_ASSIGN_OR_RETURN(request.options.skill, trial::skill_from(arguments.skill));
  request.options.seed = arguments.options.seed;
  request.options.block = arguments.options.block;
  request.options.goal = arguments.options.goal;
  constexpr double kLongest_s = 3600.0;  // the script has an end
  request.options.time_limit_s = arguments.time_limit_s > 0.0 ? arguments.time_limit_s : kLongest_s;
  request.options.countdown_s = 0.0;
  if (punches && (arguments.from_s < 0.0 || arguments.to_s <= arguments.from_s || arguments.replay.empty())) {
    return fail(ErrorCode::kInvalidArgument, "to replace a part, say which: --replay DEMO --from S --to S");
  }
  const demonstration::Segment segment =
      arguments.from_segment == "C" ? demonstration::Segment::kC : demonstration::Segment::kA;
  if (arguments.from_cell.empty() && segment != demonstration::Segment::kA) {
    return fail(ErrorCode::kInvalidArgument, "--from-segment goes with --from-cell");
  }
  if (!arguments.from_cell.empty()) {
    TROCAR_ASSIGN_OR_RETURN(const spatial::CellCoordinates cell, spatial::coordinates_from(arguments.from_cell));
    request.from = workbench::FromCell{cell, arguments.grid, segment};
  }
  if (punches) request.punch = workbench::TimeSpan{arguments.from_s, arguments.to_s};
  if (arguments.replay.empty()) return request;
  TROCAR_ASSIGN_OR_RETURN(const auto replayed, find_demonstration(project, arguments.replay));
  request.replayed = replayed->id;
  return request;
}

Result<Answer> run_keys(const RecordArguments& arguments, Console& console) {
  if (arguments.script.empty())
    return fail(ErrorCode::kInvalidArgument, "operator keys needs a --script of key presses");
  TROCAR_ASSIGN_OR_RETURN(const std::string text, read_file(arguments.script));
  const auto strokes = trial::parse_key_script(text);
  if (!strokes) return tl::unexpected(Error(strokes.error()).at(arguments.script));
  TROCAR_ASSIGN_OR_RETURN(workbench::ProjectFile file, open_to_edit(arguments.project, console, Models::kDescribed));
  TROCAR_ASSIGN_OR_RETURN(workbench::RecordByHand request, take_of(arguments, *file.project()));
  if (!arguments.name.empty()) request.name = free_demonstration_name(*file.project(), arguments.name, console);
  const double begin_s = console.clock->now_s();
  TROCAR_ASSIGN_OR_RETURN(const workbench::RecordReport report,
                          workbench::record_keys(file, request, *strokes, console.progress()));
  Answer answer = answer_of(file, report, console.clock->now_s() - begin_s);
  answer.json["limited_samples"] = report.limited;
  answer.json["unreachable_samples"] = report.refused;
  if (report.limited > 0) answer.text += fmt::format("; at a limit in {} samples", report.limited);
  if (report.refused > 0) answer.text += fmt::format("; out of reach in {} samples", report.refused);
  return answer;
}

Result<Answer> run_record(const RecordArguments& arguments, Console& console) {
  if (arguments.operator_kind == "keys") return run_keys(arguments, console);
  if (!arguments.script.empty()) return fail(ErrorCode::kInvalidArgument, "a --script is played by operator keys");
  const RecordArguments untouched;
  if (arguments.mode != untouched.mode || arguments.left != untouched.left || arguments.right != untouched.right ||
      !arguments.replay.empty() || !arguments.from_cell.empty()) {
    return fail(ErrorCode::kInvalidArgument,
                "--mode, --left, --right, --replay and --from-cell go with --operator keys");
  }
  trial::TransferOptions options = arguments.options;
  if (arguments.time_limit_s > 0.0) options.time_limit_s = arguments.time_limit_s;
  TROCAR_ASSIGN_OR_RETURN(options.skill, trial::skill_from(arguments.skill));
  TROCAR_ASSIGN_OR_RETURN(workbench::ProjectFile file, open_to_edit(arguments.project, console, Models::kDescribed));
  const std::string name = arguments.name.empty() ? workbench::demonstration_name(*file.project(), options.skill)
                                                  : free_demonstration_name(*file.project(), arguments.name, console);
  const double begin_s = console.clock->now_s();
  TROCAR_ASSIGN_OR_RETURN(const workbench::RecordReport report,
                          workbench::record_transfer(file, options, name, console.progress()));
  return answer_of(file, report, console.clock->now_s() - begin_s);
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
                          trial::replay(*demonstration->recording, demonstration->recorded, console.progress()));
  if (arguments.verify) keep_found(arguments.project, demonstration->recording->id, result, console);
  Answer answer;
  answer.json = {{"id", demonstration->id.value},
                 {"verified", result.verified},
                 {"diverged_at_s", result.diverged_at_s ? Json(*result.diverged_at_s) : Json()},
                 {"placed", result.placed}};
  answer.summary = result.verified ? "the same states, bit for bit"
                                   : fmt::format("diverged at {:.3f} s", result.diverged_at_s.value_or(0.0));
  if (!demonstration->stack->empty()) answer.summary += "; of the recording, without its edits";
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
