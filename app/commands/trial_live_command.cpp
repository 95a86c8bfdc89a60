#include "app/commands/trial_live_command.h"

#include <fmt/format.h>

#include <chrono>
#include <cstdio>
#include <thread>

#include "engine/link/hand_client.h"
#include "engine/link/hand_server.h"
#include "engine/link/tick_pacer.h"

namespace trocar::app {
namespace {

constexpr double kUsualWait_s = 60.0;
/// A console that has been gone for so long does not come back: the trial ends as interrupted.
constexpr double kGone_s = 10.0;
/// Samples are taken out so often that the session's list of them never grows long: no tick waits for it to be moved.
constexpr std::int64_t kTakeEvery_ticks = 100;
constexpr std::int64_t kTellEvery_ticks = 20;

Result<link::HandServerOptions> server_options(const LiveTrialArguments& arguments) {
  const bool with_address = arguments.listen.find(':') != std::string::npos;
  TROCAR_ASSIGN_OR_RETURN(const link::Endpoint place,
                          link::endpoint_from(with_address ? arguments.listen : "127.0.0.1:" + arguments.listen));
  return link::HandServerOptions{place.host, place.port};
}

Status wait_for_console(link::HandServer& server, double patience_s, Console& console) {
  if (!console.quiet) fmt::print(stderr, "waiting for a console at port {}\n", server.port());
  const double until_s = console.clock->now_s() + patience_s;
  while (!server.arrived()) {
    TROCAR_RETURN_IF_ERROR(console.check_not_cancelled());
    if (console.clock->now_s() >= until_s) {
      return fail(ErrorCode::kIo, fmt::format("no console came within {:g} s", patience_s));
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return {};
}

struct LiveRun {
  workbench::RanTrial ran;
  bool interrupted = false;
  link::LatenessHistogram lateness;
  int given_up = 0;
  link::HandServerStatus link;
};

LiveRun run_at_1_kHz(trial::SharedControlSession& session, link::HandServer& server, Console& console) {
  LiveRun run;
  std::vector<std::vector<demonstration::Sample>> pieces;
  link::TickPacer pacer;
  while (!session.done()) {
    pacer.wait();
    const std::int64_t tick = session.state().tick.count;
    if (tick % kTellEvery_ticks == 0) {
      server.tell(session.trial_status()->state);
      console.progress().set(session.state().tick.seconds() / session.options().time_limit_s);
      const bool ends = !console.check_not_cancelled() || server.silent_s() > kGone_s;
      if (ends && !run.interrupted) session.stop();
      run.interrupted = run.interrupted || ends;
    }
    session.step();
    if (tick % kTakeEvery_ticks == 0) pieces.push_back(session.take_samples());
  }
  pieces.push_back(session.take_samples());
  run.lateness = pacer.lateness();
  run.given_up = pacer.given_up();
  run.link = server.status();
  demonstration::Recording& recording = run.ran.recording;
  for (const auto& piece : pieces) recording.samples.insert(recording.samples.end(), piece.begin(), piece.end());
  recording.provenance = session.provenance();
  recording.initial_world = session.take_initial_world().value_or("");
  recording.hashes = session.take_marks();
  recording.outcome = session.outcome();
  recording.placed = session.placed();
  return run;
}

Json json_of_link(const link::HandServerStatus& link) {
  const auto ms = [](double seconds) { return 1e3 * seconds; };
  return {{"peer", link.peer},
          {"scripted", link.scripted},
          {"connections", link.connections},
          {"refused", link.refused},
          {"frames", link.frames},
          {"malformed", link.malformed},
          {"dropped", link.dropped},
          {"lost", link.lost},
          {"unseen_presses", link.unseen_presses},
          {"delay_p50_ms", link.one_clock ? Json(ms(link.delay_p50_s)) : Json(nullptr)},
          {"delay_p95_ms", link.one_clock ? Json(ms(link.delay_p95_s)) : Json(nullptr)},
          {"delay_worst_ms", link.one_clock ? Json(ms(link.delay_worst_s)) : Json(nullptr)},
          {"rtt_p50_ms", ms(link.rtt_p50_s)},
          {"rtt_p95_ms", ms(link.rtt_p95_s)}};
}

Json json_of_ticks(const LiveRun& run) {
  Json classes = Json::array();
  for (std::size_t i = 0; i < run.lateness.counts().size(); ++i) {
    const bool last = i == link::LatenessHistogram::kUpTo_us.size();
    classes.push_back({{"up_to_us", last ? Json(nullptr) : Json(link::LatenessHistogram::kUpTo_us[i])},
                       {"ticks", run.lateness.counts()[i]}});
  }
  return {{"ticks", run.lateness.ticks()},
          {"missed", run.lateness.missed()},
          {"given_up", run.given_up},
          {"worst_ms", 1e-6 * static_cast<double>(run.lateness.worst_ns())},
          {"classes", classes}};
}

std::string text_of_link(const link::HandServerStatus& link) {
  std::string text = fmt::format(
      "{}: {} frames, {} malformed, {} dropped, {} lost; there and back p50 {:.2f} ms, p95 {:.2f} ms", link.peer,
      link.frames, link.malformed, link.dropped, link.lost, 1e3 * link.rtt_p50_s, 1e3 * link.rtt_p95_s);
  if (!link.one_clock) return text;
  return text + fmt::format("; delay p50 {:.2f} ms, p95 {:.2f} ms, worst {:.2f} ms", 1e3 * link.delay_p50_s,
                            1e3 * link.delay_p95_s, 1e3 * link.delay_worst_s);
}

}  // namespace

void bind_live(CLI::App& verb, LiveTrialArguments& arguments) {
  verb.add_option("--listen", arguments.listen,
                  "Of --operator tcp: the port, or ADDRESS:PORT; without an address only this machine is heard");
  verb.add_option("--wait", arguments.wait_s, "Of --operator tcp: so many seconds for a console to come (60)")
      ->check(CLI::Range(0.0, 86400.0));
  verb.add_flag("--assist", arguments.assists,
                "Of --operator tcp: the console's right hand has the right arm; else a scripted expert");
  verb.add_flag("--realtime", arguments.real_time,
                "Of --operator tcp: ask the system for a real-time scheduler for the 1 kHz loop");
}

Result<Answer> run_live_command(workbench::ProjectFile& file, const workbench::TrialPlan& plan,
                                const LiveTrialArguments& arguments, Console& console) {
  if (arguments.listen.empty()) return fail(ErrorCode::kInvalidArgument, "say --listen PORT for --operator tcp");
  if (plan.transfers != 1) {
    return fail(ErrorCode::kInvalidArgument, "one transfer at a time is run by a person: leave out --transfers");
  }
  TROCAR_ASSIGN_OR_RETURN(const link::HandServerOptions place, server_options(arguments));
  TROCAR_ASSIGN_OR_RETURN(const auto server, link::HandServer::listen(place));
  TROCAR_ASSIGN_OR_RETURN(const trial::TrialOptions options, workbench::options_of(*file.project(), plan, 0));
  TROCAR_ASSIGN_OR_RETURN(
      const auto session,
      trial::SharedControlSession::create(options, {server.get(), arguments.assists ? &server->assistant() : nullptr}));
  TROCAR_RETURN_IF_ERROR(wait_for_console(*server, arguments.wait_s < 0.0 ? kUsualWait_s : arguments.wait_s, console));
  const bool granted = arguments.real_time && link::ask_for_real_time();
  if (arguments.real_time && !granted) {
    console.diagnostics.warn("the system grants no real-time scheduler; the loop runs as any program does");
  }
  LiveRun run = run_at_1_kHz(*session, *server, console);
  run.ran.record = workbench::record_of(*session, plan, 0, run.ran.recording.samples, session->take_events());
  run.ran.record.interrupted = run.interrupted;
  workbench::add_link(run.link, run.ran.record);
  run.ran.recording.provenance.operator_kind = run.ran.record.operator_kind;

  TROCAR_ASSIGN_OR_RETURN(const demonstration::RecordingId recording, file.store_recording(run.ran.recording));
  const std::string name = workbench::trial_name(*file.project(), plan.options.mode);
  TROCAR_ASSIGN_OR_RETURN(const std::int64_t id, file.commit(workbench::AddTrial{recording, name, run.ran.record}));
  const auto& entry = file.project()->trials.at(workbench::TrialId{id});
  Answer answer;
  answer.json["trials"] = Json::array({json_of(*entry)});
  answer.json["interrupted"] = run.interrupted;
  answer.json["link"] = json_of_link(run.link);
  answer.json["loop"] = json_of_ticks(run);
  answer.json["real_time"] = granted;
  answer.summary = fmt::format("{}: {} after {:.1f} s{}", name, demonstration::to_string(run.ran.record.outcome),
                               run.ran.record.duration_s, run.interrupted ? ", interrupted" : "");
  answer.text = fmt::format("{}\n{}\n{} ticks, {} a whole period late or more, worst {:.2f} ms; began late by\n{}{}",
                            row_of(*entry), text_of_link(run.link), run.lateness.ticks(), run.lateness.missed(),
                            1e-6 * static_cast<double>(run.lateness.worst_ns()), run.lateness.text(), answer.summary);
  return answer;
}

}  // namespace trocar::app
