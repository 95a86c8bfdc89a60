// Trials: blocks of a protocol, transfer after transfer, by a script or a person.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "engine/core/ending.h"
#include "engine/core/file.h"
#include "engine/workbench/take_plan.h"
#include "engine/workbench/trial_results.h"
#include "engine/workbench/workbench_impl.h"

namespace trocar::workbench {

std::string_view to_string(TrialsPhase phase) {
  constexpr std::array<std::string_view, 6> kNames{"ready", "running", "paused", "resting", "done", "waiting"};
  return kNames[static_cast<std::size_t>(phase)];
}

void Workbench::Impl::on(const StartTrials& command) {
  if (!can_record()) return;
  if (const std::string why = no_room(); !why.empty()) return log(Severity::kError, why);
  TrialsView trials;
  trials.request = command;
  if (command.space_mouse) on(FindDevices{});
  if (command.space_mouse && !space_mouse) {
    trials.request.space_mouse = false;
    log(Severity::kWarning, state.space_mouse_missing);
  }
  space_mouse_hand = {};
  if (command.from) {
    if (command.from->segment != demonstration::Segment::kA) {
      return log(Severity::kError, "A trial begins with segment A: a start of a model of C cannot be one");
    }
    const auto place = place_of(*command.from);
    if (!place) return log(Severity::kError, place.error().text());
    trials.request.plan.options.begin_p_W = *place;
  }
  if (command.protocol.empty()) {
    trial::ProtocolBlock block;
    block.name = command.plan.options.mode == trial::Mode::kShared ? "Shared control" : "Manual";
    block.mode = command.plan.options.mode;
    block.transfers = command.plan.transfers;
    block.delay = control::to_string(command.plan.options.delay);
    trials.blocks.push_back(std::move(block));
  } else {
    const Result<trial::Protocol> protocol = trial::find_protocol(command.protocol);
    if (!protocol) return log(Severity::kError, protocol.error().text());
    trials.protocol = protocol->name;
    trials.blocks = trial::order_for(*protocol, command.subject_number, command.plan.seed);
    trials.request.plan.options.time_limit_s = protocol->transfer_s;
  }
  // What cannot be run is said before anybody sits down.
  for (std::size_t i = 0; i < trials.blocks.size(); ++i) {
    TrialPlan plan = trials.request.plan;
    plan.options.mode = trials.blocks[i].mode;
    const int transfers = trials.blocks[i].transfers.value_or(peg_board::kBlockCount);
    if (const Status can = check_blocks(*state.project, plan, transfers); !can) {
      return log(Severity::kError, can.error().text());
    }
    if (const auto delay = control::delay_from(trials.blocks[i].delay); !delay) {
      return log(Severity::kError, delay.error().text());
    }
  }
  if (trials.request.plan.session.empty()) trials.request.plan.session = iso_time(options.clock->unix_s());
  hand_server.reset();
  if (command.console_port) {
    // Nobody is asked who they are: only this machine is heard, as on the command line. Others come through a tunnel.
    auto server = link::HandServer::listen({"127.0.0.1", *command.console_port});
    if (!server) return log(Severity::kError, server.error().text());
    hand_server = std::move(*server);
    trials.console = ConsoleView{};
    trials.console->port = hand_server->port();
  }
  trials_end_asked = false;
  state.trials = std::move(trials);
  state.play_speed = 0.0;
  dirty = true;
  on(StartBlock{});
}

void Workbench::Impl::on(const SetTrialStart& command) {
  state.trial_start = command.from;
  dirty = true;
}

/// A session that ends because the disk is full is a day lost.
std::string Workbench::Impl::no_room() const {
  constexpr std::uintmax_t kLeast_bytes = 1'000'000'000;
  std::error_code failed;
  const std::filesystem::space_info space = std::filesystem::space(file->path(), failed);
  if (failed || space.available >= kLeast_bytes) return "";
  return fmt::format("Trials need 1 GB of free disk, and there are {:.0f} MB",
                     1e-6 * static_cast<double>(space.available));
}

void Workbench::Impl::on(const StartBlock&) {
  if (!state.trials || recording) return;
  TrialsView& trials = *state.trials;
  trials.paused = false;
  if (trials.phase == TrialsPhase::kDone || trials.phase == TrialsPhase::kWaiting ||
      trials.block >= static_cast<int>(trials.blocks.size()))
    return;
  if (trials.phase != TrialsPhase::kPaused) {
    trials.transfer = trials.successes = trials.drops = 0;
    trials.block_s = 0.0;
  }
  begin_transfer();
}

void Workbench::Impl::begin_transfer() {
  if (!can_record()) {
    state.trials->phase = TrialsPhase::kPaused;
    return;
  }
  TrialsView& trials = *state.trials;
  if (hand_server && !hand_server->arrived()) {
    trials.phase = TrialsPhase::kWaiting;
    return;
  }
  TrialStart start;
  // The delays were looked at when the trials were prepared.
  start.plan = plan_of(trials.request.plan, trials.blocks, static_cast<std::size_t>(trials.block)).value();
  start.transfer = trials.transfer;
  start.person = trials.request.person;
  start.person_assists = trials.request.person_assists;
  if (hand_server) hand_server->begin_anew();
  start.console = hand_server.get();
  start.realtime = trials.request.realtime;
  auto started = LiveRecording::start(*file, start);
  if (!started) {
    trials.phase = TrialsPhase::kPaused;
    return log(Severity::kError, started.error().text());
  }
  recording = std::move(*started);
  trials.phase = TrialsPhase::kRunning;
  on(EndPreview{});
}

void Workbench::Impl::poll_rest() {
  if (!state.trials || state.trials->phase != TrialsPhase::kResting) return;
  const double left_s = std::max(0.0, state.trials->rest_s - (options.clock->now_s() - rest_begins_s));
  // Drawn anew once a second.
  if (std::ceil(left_s) == std::ceil(state.trials->rest_left_s)) return;
  state.trials->rest_left_s = left_s;
  dirty = true;
}

void Workbench::Impl::poll_console() {
  if (!hand_server) return;
  if (!state.trials) {
    if (!recording) hand_server.reset();
    return;
  }
  if (!recording) hand_server->pass_over();
  const link::HandServerStatus status = hand_server->status();
  // Who has been gone for so long does not come back: the transfer ends, and the block waits for somebody.
  constexpr double kGone_s = 10.0;
  const double now_s = options.clock->now_s();
  if (!recording || status.frames != state.trials->console->frames) console_heard_s = now_s;
  if (recording && now_s - console_heard_s > kGone_s) {
    console_heard_s = now_s;
    log(Severity::kWarning, "The console has been silent for 10 s: the transfer was stopped");
    on(StopTrial{});
  }
  ConsoleView console{state.trials->console->port, status.connected, status.peer,   status.scripted, status.one_clock,
                      status.delay_p95_s,          status.rtt_p95_s, status.frames, status.lost,     status.malformed};
  dirty = dirty || status.frames != state.trials->console->frames || status.connected != state.trials->console->there;
  state.trials->console = std::move(console);
  if (recording && state.live && state.live->trial) hand_server->tell(state.live->trial->state);
  if (state.trials->phase == TrialsPhase::kWaiting && !recording && !state.trials->paused && hand_server->arrived()) {
    begin_transfer();
  }
}

void Workbench::Impl::conclude_transfer(const LiveRecording::End& end) {
  TrialsView& trials = *state.trials;
  trials.phase = TrialsPhase::kPaused;
  if (!end.demonstration) {
    log(Severity::kError, end.demonstration.error().text());
    return;
  }
  tell(end.message);
  state.demonstration = *end.demonstration;
  state.playhead_s = 0.0;
  if (!end.trial) return;
  ++trials.transfer;
  trials.block_s += end.trial->duration_s;
  trials.successes += end.trial->outcome == demonstration::Outcome::kSuccess ? 1 : 0;
  trials.drops += end.trial->outcome == demonstration::Outcome::kDropped ? 1 : 0;
  if (trials_end_asked) {
    state.trials.reset();
    return;
  }
  go_on_with_trials();
}

void Workbench::Impl::go_on_with_trials() {
  TrialsView& trials = *state.trials;
  const trial::ProtocolBlock& block = trials.blocks[static_cast<std::size_t>(trials.block)];
  if (!trial::block_over(block, trials.transfer, trials.successes, trials.block_s)) {
    // Stopped or paused by somebody: it waits for them.
    if (!trials.paused) begin_transfer();
    return;
  }
  trials.rest_s = trials.rest_left_s = block.rest_s;
  rest_begins_s = options.clock->now_s();
  ++trials.block;
  const bool more = trials.block < static_cast<int>(trials.blocks.size());
  // Of the last block one still sees how it went.
  if (more) trials.transfer = trials.successes = trials.drops = 0;
  trials.phase = !more ? TrialsPhase::kDone : trials.rest_s > 0.0 ? TrialsPhase::kResting : TrialsPhase::kReady;
  log(Severity::kInfo, more ? "The block is over" : "All blocks are over");
}

void Workbench::Impl::on(const PauseTrials& command) {
  if (!state.trials) return;
  state.trials->paused = command.paused;
  dirty = true;
  const bool waits = state.trials->phase == TrialsPhase::kPaused || state.trials->phase == TrialsPhase::kWaiting;
  if (!command.paused && waits && !recording) begin_transfer();
}

void Workbench::Impl::on(const StopTrial&) {
  if (!state.trials) return;
  state.trials->paused = true;
  if (recording) recording->stop_trial();
  dirty = true;
}

void Workbench::Impl::on(const EndTrials&) {
  if (!state.trials) return;
  dirty = true;
  if (!recording) return state.trials.reset();
  trials_end_asked = true;
  recording->stop(true);
}

void Workbench::Impl::on(const MarkIncident& command) {
  if (!recording || !state.trials) return;
  recording->mark_incident(command.text.empty() ? "incident" : command.text);
  tell("Marked the instant");
}

void Workbench::Impl::on(const ExportTrials& command) {
  if (!project_open() || !is_output(command.path)) return;
  const auto work = [project = state.project, path = command.path](Progress&) -> Result<JobResult> {
    const Trials trials = counted_trials(*project, "");
    const std::string ending = ending_of(path);
    if (ending == ".png" || ending == ".svg" || ending == ".pdf") {
      TROCAR_RETURN_IF_ERROR(write_results_figure(trials, results_of(trials), "", path));
      return JobResult{fmt::format("{} trials drawn", trials.size()), {}};
    }
    const bool page = ending == ".html";
    const std::string text = page ? results_html(results_of(trials), "Trials") : trials_csv(*project, "");
    TROCAR_RETURN_IF_ERROR(write_file(path, text));
    return JobResult{fmt::format("{} trials written", page ? trials.size() : project->trials.size()), {}};
  };
  jobs.start("Export " + command.path.filename().string(), work);
}

}  // namespace trocar::workbench
