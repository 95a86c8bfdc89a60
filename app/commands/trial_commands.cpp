#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "app/commands/trial_commands.h"
#include "app/commands/trial_live_command.h"
#include "app/lookup.h"
#include "app/options.h"
#include "engine/spatial/cell_text.h"
#include "engine/workbench/jobs/trial_job.h"
#include "engine/workbench/take_plan.h"

namespace trocar::app {
namespace {

struct RunTrialArguments {
  std::string project;
  std::string mode;
  std::string protocol;
  int subject_number = 0;
  std::vector<std::string> model_a;
  std::vector<std::string> model_c;
  std::string operator_kind = "scripted";
  std::string skill = "expert";
  std::string delay = "0";
  std::string anchor = "board";
  int block = -1;
  std::string from_cell;
  int grid = 22;
  LiveTrialArguments live;
  workbench::TrialPlan plan;
};

const std::map<std::string, trial::Anchor> kAnchors = {{"board", trial::Anchor::kBoard},
                                                       {"target", trial::Anchor::kTarget}};

void bind_trial_run(CLI::App& verb, RunTrialArguments& arguments) {
  workbench::TrialPlan& plan = arguments.plan;
  verb.add_option("PROJECT", arguments.project, "The project file")->required();
  verb.add_option("--mode", arguments.mode, "MT: the operator does A to D; SC: the agent moves in A and C")
      ->check(CLI::IsMember({"MT", "SC"}));
  CLI::Option* protocol =
      verb.add_option("--protocol", arguments.protocol,
                      "Whole blocks instead: sim or dvrk, the paper's two, or F.json; their order is the subject's");
  verb.add_option("--subject-number", arguments.subject_number, "From 0: which order of blocks; and the seed draws")
      ->check(CLI::Range(0, 9999));
  verb.add_option("--model-a", arguments.model_a,
                  "Model of segment A; several: the one of the block's own demonstration serves")
      ->take_all();
  verb.add_option("--model-c", arguments.model_c, "Model of segment C; without either, those that the project has")
      ->take_all();
  verb.add_option("--operator", arguments.operator_kind,
                  "scripted: everything it makes is marked so; tcp: a hand controller's console, in real time")
      ->check(CLI::IsMember({"scripted", "tcp"}))
      ->capture_default_str();
  bind_live(verb, arguments.live);
  verb.add_option("--skill", arguments.skill, "expert, trained or novice")
      ->check(CLI::IsMember({"expert", "trained", "novice"}))
      ->capture_default_str();
  verb.add_option("--delay-ms,--delay", arguments.delay,
                  "From hand to arm: 40, normal:20:5, lognormal:20:5, ar1:20:5, trace:FILE; then ,stall:0.01:200")
      ->capture_default_str();
  verb.add_option("--anchor", arguments.anchor, "The lattice lies on the board, or with its goal at the block")
      ->check(CLI::IsMember(kAnchors))
      ->capture_default_str();
  CLI::Option* transfers =
      verb.add_option("--transfers", plan.transfers, "So many, one after the other, with the blocks in turn")
          ->check(CLI::Range(1, 1000))
          ->capture_default_str();
  verb.add_option("--block", arguments.block, "Each transfer takes this block")->check(CLI::Range(0, 5));
  verb.add_option("--first-block", plan.first_block, "The first transfer takes this one, the next ones those after it")
      ->check(CLI::Range(0, 5));
  CLI::Option* from = verb.add_option("--from-cell", arguments.from_cell,
                                      "I,J,K: the left tool begins in the middle of this cell, not where it is ready");
  verb.add_option("--grid", arguments.grid, "Cells a side of the lattice that --from-cell counts in")
      ->check(CLI::Range(1, 176))
      ->capture_default_str()
      ->needs(from);
  add_seed(verb, plan.seed, "Of the first transfer; the next ones count up. The same for both modes: the same scenes");
  verb.add_option("--agent-rate", plan.options.agent_rate_hz, "Cells a second")
      ->check(CLI::Range(1.0, 40.0))
      ->capture_default_str();
  verb.add_option("--scale", plan.options.scale, "From hand to tool")
      ->check(CLI::Range(0.1, 0.5))
      ->capture_default_str();
  CLI::Option* limit = verb.add_option("--time-limit", plan.options.time_limit_s, "Seconds for each transfer")
                           ->check(CLI::Range(1.0, 3600.0))
                           ->capture_default_str();
  // A protocol says these itself.
  for (CLI::Option* of_one_block : {transfers, limit}) of_one_block->excludes(protocol);
  verb.add_option("--session", plan.session, "What belongs together has the same");
  verb.add_option("--subject", plan.subject, "An id, never a name");
  verb.add_option("--block-number", plan.block_number, "Of the protocol")->check(CLI::Range(0, 999));
  verb.add_option("--threads", plan.threads, "The result does not depend on it")
      ->check(CLI::Range(1, 64))
      ->capture_default_str();
}

}  // namespace

Json json_of(const workbench::TrialEntry& trial) {
  const trial::TrialRecord& record = trial.record;
  Json segments = Json::object();
  for (int i = 0; i < demonstration::kSegmentCount; ++i) {
    const auto segment = static_cast<demonstration::Segment>(i);
    segments[std::string(1, demonstration::letter(segment))] = record.counts.segment_s[static_cast<std::size_t>(i)];
  }
  Json json = {{"id", trial.id.value},
               {"name", trial.name},
               {"mode", std::string(trial::to_string(record.mode))},
               {"operator", record.operator_kind},
               {"assistant", record.assistant},
               {"skill", record.skill},
               {"seed", record.seed},
               {"block", record.block},
               {"goal", record.goal},
               {"outcome", std::string(demonstration::to_string(record.outcome))},
               {"placed", record.placed},
               {"completion_s", record.completion_s ? Json(*record.completion_s) : Json(nullptr)},
               {"segments_s", segments},
               {"agent_share", record.metrics.agent_share},
               {"attempts", record.counts.attempts},
               {"misses", record.counts.misses},
               {"clutches", record.counts.clutches},
               {"hand_overs", record.counts.hand_overs},
               {"path_length_m", record.metrics.path_length_m},
               {"economy", record.metrics.economy},
               {"smoothness", record.metrics.smoothness},
               {"delay_mean_s", record.counts.delay_mean_s},
               {"delay_worst_s", record.counts.delay_worst_s},
               {"session", record.session},
               {"subject", record.subject},
               {"excluded", trial.excluded}};
  if (record.begin_p_W) {
    json["begin_m"] = {record.begin_p_W->x(), record.begin_p_W->y(), record.begin_p_W->z()};
  }
  return json;
}

namespace {

/// Of a trial that began elsewhere than where the tool is ready.
std::string begin_words(const trial::TrialRecord& record) {
  if (!record.begin_p_W) return "";
  const Eigen::Vector3d mm = 1e3 * *record.begin_p_W;
  return fmt::format("  from {:.1f}, {:.1f}, {:.1f} mm", mm.x(), mm.y(), mm.z());
}

/// Shared control in which nobody was helped tells nothing of shared control.
void warn_if_idle(const workbench::TrialEntry& trial, Console& console) {
  const trial::TrialRecord& record = trial.record;
  if (record.mode != trial::Mode::kShared || record.metrics.agent_share > 0.0) return;
  const bool has_a = std::any_of(record.models.begin(), record.models.end(),
                                 [](const auto& model) { return model.segment == demonstration::Segment::kA; });
  console.diagnostics.warn(fmt::format("the agent moved nothing in {}{}", trial.name,
                                       has_a ? "" : fmt::format(": no model of A serves block {}", record.block)));
}

}  // namespace

std::string row_of(const workbench::TrialEntry& trial) {
  const trial::TrialRecord& record = trial.record;
  const std::string time = record.completion_s ? fmt::format("{:.2f} s", *record.completion_s) : "–";
  return fmt::format("{:>4}  {:<10} {:<9} block {}  {:<11} {:>9}  agent {:>3.0f} %  {}{}{}", trial.id.value, trial.name,
                     record.operator_kind + (record.skill.empty() ? "" : " " + record.skill), record.block,
                     demonstration::to_string(record.outcome), time, 100.0 * record.metrics.agent_share,
                     record.placed ? "placed" : "not placed", begin_words(record),
                     trial.excluded ? "  excluded: " + trial.reason : "");
}

namespace {

Result<std::vector<workbench::RanTrial>> run_protocol(const workbench::Project& project, workbench::TrialPlan plan,
                                                      const RunTrialArguments& arguments, Console& console) {
  TROCAR_ASSIGN_OR_RETURN(const trial::Protocol protocol, trial::find_protocol(arguments.protocol));
  plan.options.time_limit_s = protocol.transfer_s;
  const std::vector<trial::ProtocolBlock> blocks = order_for(protocol, arguments.subject_number, plan.seed);
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    TROCAR_ASSIGN_OR_RETURN(const workbench::TrialPlan of_block, workbench::plan_of(plan, blocks, i));
    const int transfers = blocks[i].transfers.value_or(peg_board::kBlockCount);
    if (Status can = workbench::check_blocks(project, of_block, transfers); !can) return tl::unexpected(can.error());
  }
  std::vector<workbench::RanTrial> all;
  for (std::size_t i = 0; i < blocks.size() && !console.progress().cancelled(); ++i) {
    TROCAR_ASSIGN_OR_RETURN(const workbench::TrialPlan of_block, workbench::plan_of(plan, blocks, i));
    TROCAR_ASSIGN_OR_RETURN(std::vector<workbench::RanTrial> ran,
                            workbench::run_block(project, of_block, blocks[i], console.progress()));
    std::move(ran.begin(), ran.end(), std::back_inserter(all));
    console.progress().set((static_cast<double>(i) + 1.0) / static_cast<double>(blocks.size()));
  }
  return all;
}

Result<Answer> run_trials_command(const RunTrialArguments& arguments, Console& console) {
  TROCAR_ASSIGN_OR_RETURN(workbench::ProjectFile file, open_to_edit(arguments.project, console, Models::kWhole));
  workbench::TrialPlan plan = arguments.plan;
  if (arguments.mode.empty() == arguments.protocol.empty()) {
    return fail(ErrorCode::kInvalidArgument, "say --mode MT or --mode SC, or a --protocol with its blocks");
  }
  if (!arguments.protocol.empty() && arguments.operator_kind == "tcp") {
    return fail(ErrorCode::kInvalidArgument,
                "a console runs one transfer here: --mode, not --protocol; a protocol by a "
                "console is for the window, workspace Trials");
  }
  if (!arguments.protocol.empty() && arguments.delay != "0") {
    return fail(ErrorCode::kInvalidArgument, "a protocol says the delay of each block: no --delay-ms with --protocol");
  }
  if (!arguments.protocol.empty() && plan.subject.empty())
    plan.subject = fmt::format("S{}", arguments.subject_number + 1);
  if (!arguments.mode.empty()) {
    TROCAR_ASSIGN_OR_RETURN(plan.options.mode, trial::mode_from(arguments.mode));
  }
  TROCAR_ASSIGN_OR_RETURN(plan.options.skill, trial::skill_from(arguments.skill));
  TROCAR_ASSIGN_OR_RETURN(plan.options.delay, control::delay_from(arguments.delay));
  plan.options.anchor = kAnchors.at(arguments.anchor);
  if (arguments.block >= 0) {
    plan.first_block = arguments.block;
    plan.same_block = true;
  }
  for (const auto& [names, segment] : {std::pair{&arguments.model_a, demonstration::Segment::kA},
                                       std::pair{&arguments.model_c, demonstration::Segment::kC}}) {
    for (const std::string& name : *names) {
      TROCAR_ASSIGN_OR_RETURN(const auto entry, find_model(*file.project(), name));
      if (entry->segment != segment) {
        return fail(ErrorCode::kInvalidArgument,
                    fmt::format("{} is a model of segment {}, not {}", entry->name,
                                demonstration::letter(entry->segment), demonstration::letter(segment)));
      }
      warn_if_stale(*file.project(), *entry, console);
      plan.models.push_back(entry->id);
    }
  }
  if (!arguments.from_cell.empty()) {
    TROCAR_ASSIGN_OR_RETURN(const spatial::CellCoordinates cell, spatial::coordinates_from(arguments.from_cell));
    TROCAR_ASSIGN_OR_RETURN(plan.options.begin_p_W, workbench::place_of({cell, arguments.grid}));
  }
  if (arguments.operator_kind == "tcp") return run_live_command(file, plan, arguments.live, console);
  if (arguments.live.given()) {
    return fail(ErrorCode::kInvalidArgument, "--listen, --wait, --assist and --realtime are for --operator tcp");
  }
  const double begin_s = console.clock->now_s();
  std::vector<workbench::RanTrial> ran;
  if (arguments.protocol.empty()) {
    TROCAR_ASSIGN_OR_RETURN(ran, workbench::run_trials(*file.project(), plan, console.progress()));
  } else {
    TROCAR_ASSIGN_OR_RETURN(ran, run_protocol(*file.project(), plan, arguments, console));
  }
  const double wall_s = console.clock->now_s() - begin_s;
  Answer answer;
  answer.json["trials"] = Json::array();
  int succeeded = 0;
  double simulated_s = 0.0;
  for (const workbench::RanTrial& each : ran) {
    TROCAR_ASSIGN_OR_RETURN(const demonstration::RecordingId recording, file.store_recording(each.recording));
    const std::string name = workbench::trial_name(*file.project(), each.record.mode);
    TROCAR_ASSIGN_OR_RETURN(const std::int64_t id, file.commit(workbench::AddTrial{recording, name, each.record}));
    const auto& entry = file.project()->trials.at(workbench::TrialId{id});
    answer.json["trials"].push_back(json_of(*entry));
    answer.text += row_of(*entry) + "\n";
    warn_if_idle(*entry, console);
    succeeded += each.record.outcome == demonstration::Outcome::kSuccess ? 1 : 0;
    simulated_s += each.record.duration_s;
  }
  if (console.progress().cancelled()) {
    return fail(ErrorCode::kCancelled, fmt::format("stopped by the user; {} begun so far {} kept, those that were "
                                                   "under way as aborted",
                                                   counted(ran.size(), "transfer"), ran.size() == 1 ? "is" : "are"));
  }
  answer.json["seconds"] = wall_s;
  answer.json["simulated_s"] = simulated_s;
  answer.summary = fmt::format("{} of {} transfers succeed; {:.0f} s simulated in {:.1f} s", succeeded, ran.size(),
                               simulated_s, wall_s);
  answer.text += answer.summary;
  return answer;
}

struct ListTrialsArguments {
  std::string project;
};

Result<Answer> list_trials(const ListTrialsArguments& arguments, Console& console) {
  TROCAR_ASSIGN_OR_RETURN(const workbench::ProjectFile file,
                          open_to_read(arguments.project, console, Models::kDescribed));
  Answer answer;
  answer.json["trials"] = Json::array();
  for (const auto& [id, trial] : file.project()->trials) {
    answer.json["trials"].push_back(json_of(*trial));
    answer.text += (answer.text.empty() ? "" : "\n") + row_of(*trial);
  }
  answer.summary = counted(file.project()->trials.size(), "trial");
  if (answer.text.empty()) answer.text = answer.summary;
  return answer;
}

struct TrialArguments {
  std::string project;
  std::string trial;
  bool verify = false;
  std::string exclude;
  bool include = false;
};

void bind_trial(CLI::App& verb, TrialArguments& arguments) {
  verb.add_option("PROJECT", arguments.project, "The project file")->required();
  verb.add_option("TRIAL", arguments.trial, "Id or name")->required();
}

Result<Answer> show_trial(const TrialArguments& arguments, Console& console) {
  TROCAR_ASSIGN_OR_RETURN(const workbench::ProjectFile file,
                          open_to_read(arguments.project, console, Models::kDescribed));
  TROCAR_ASSIGN_OR_RETURN(const auto trial, find_trial(*file.project(), arguments.trial));
  Answer answer;
  answer.json = json_of(*trial);
  answer.json["anchor"] = std::string(trial::to_string(trial->record.anchor));
  answer.json["delay"] = trial->record.delay;
  answer.json["hash"] = hash_text(trial->shown->hash());
  answer.json["scene_hash"] = trial->shown->recording->provenance.scene_hash;
  answer.json["models"] = Json::array();
  for (const auto& model : trial->record.models) {
    answer.json["models"].push_back({{"name", model.name},
                                     {"segment", std::string(1, demonstration::letter(model.segment))},
                                     {"hash", hash_text(model.hash)}});
  }
  answer.json["events"] = Json::array();
  answer.text = row_of(*trial);
  for (const trial::TrialEvent& event : trial->record.events) {
    const std::string kind(trial::to_string(event.kind));
    answer.json["events"].push_back({{"t_s", Tick{event.tick}.seconds()}, {"kind", kind}, {"text", event.text}});
    answer.text += fmt::format("\n{:9.3f}  {:<8} {}", Tick{event.tick}.seconds(), kind, event.text);
  }
  answer.summary = row_of(*trial);
  return answer;
}

void bind_trial_replay(CLI::App& verb, TrialArguments& arguments) {
  bind_trial(verb, arguments);
  verb.add_flag("--verify", arguments.verify, "Compare every state hash; that is what a replay is for");
}

Result<Answer> replay_trial(const TrialArguments& arguments, Console& console) {
  TROCAR_ASSIGN_OR_RETURN(const workbench::ProjectFile file,
                          open_to_read(arguments.project, console, Models::kDescribed));
  TROCAR_ASSIGN_OR_RETURN(const auto trial, find_trial(*file.project(), arguments.trial));
  TROCAR_ASSIGN_OR_RETURN(const trial::ReplayResult replayed,
                          trial::replay(*trial->shown->recording, trial->shown->recorded, console.progress()));
  Answer answer;
  answer.json = {{"verified", replayed.verified},
                 {"diverged_at_s", replayed.diverged_at_s ? Json(*replayed.diverged_at_s) : Json(nullptr)},
                 {"placed", replayed.placed}};
  answer.passed = replayed.verified;
  answer.summary = replayed.verified ? fmt::format("{}: verified, every state hash is the same", trial->name)
                                     : fmt::format("{}: the replay diverged at {:.2f} s", trial->name,
                                                   replayed.diverged_at_s.value_or(0.0));
  return answer;
}

void bind_judge(CLI::App& verb, TrialArguments& arguments) {
  bind_trial(verb, arguments);
  CLI::Option* exclude = verb.add_option("--exclude", arguments.exclude, "Leave it out of the results, and why");
  verb.add_flag("--include", arguments.include, "Take it in again")->excludes(exclude);
}

Result<Answer> judge_trial(const TrialArguments& arguments, Console& console) {
  if (arguments.exclude.empty() != arguments.include) {
    return fail(ErrorCode::kInvalidArgument, "say --exclude with a reason, or --include");
  }
  TROCAR_ASSIGN_OR_RETURN(workbench::ProjectFile file, open_to_edit(arguments.project, console, Models::kDescribed));
  TROCAR_ASSIGN_OR_RETURN(const auto trial, find_trial(*file.project(), arguments.trial));
  TROCAR_RETURN_IF_ERROR(
      file.commit(workbench::JudgeTrial{trial->id, !arguments.include, arguments.exclude}).map([](auto) {}));
  Answer answer;
  answer.json = {{"id", trial->id.value}, {"excluded", !arguments.include}};
  answer.summary = arguments.include ? trial->name + " counts again"
                                     : fmt::format("{} is left out: {}", trial->name, arguments.exclude);
  return answer;
}

}  // namespace

void add_trial_commands(CLI::App& root, Action& chosen) {
  CLI::App& noun = *root.add_subcommand("trial", "Manual and shared-control trials")->require_subcommand(1);
  add_verb<RunTrialArguments>(noun, chosen, "run",
                              "Run transfers by scripted operators faster than real time, or one by a person's console",
                              bind_trial_run, run_trials_command);
  const auto bind_list = [](CLI::App& verb, ListTrialsArguments& arguments) {
    verb.add_option("PROJECT", arguments.project, "The project file")->required();
  };
  add_verb<ListTrialsArguments>(noun, chosen, "list", "One line for each trial", bind_list, list_trials);
  add_verb<TrialArguments>(noun, chosen, "show", "One trial with every event of its record", bind_trial, show_trial);
  add_verb<TrialArguments>(noun, chosen, "replay", "Simulate its setpoints again and compare the hashes",
                           bind_trial_replay, replay_trial);
  add_verb<TrialArguments>(noun, chosen, "judge", "Exclude a trial from the results, or include it again", bind_judge,
                           judge_trial);
  add_trial_results_command(noun, chosen);
}

}  // namespace trocar::app
