// The console's program: sends a hand controller's poses and pedals to a workbench, over a network with a delay if one
// is asked for.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <exception>
#include <functional>
#include <memory>
#include <optional>
#include <utility>

#include "app/console.h"
#include "app/crash_report.h"
#include "app/lookup.h"
#include "engine/core/file.h"
#include "engine/device/joystick.h"
#include "engine/link/delay_relay.h"
#include "engine/link/hand_console.h"
#include "engine/link/hand_script.h"
#include "engine/link/pad_hand.h"
#include "engine/link/replayed_hand.h"

namespace trocar::app {
namespace {

struct ConsoleArguments {
  std::string connect;
  std::string source = "still";
  std::vector<std::string> replay;
  std::string script;
  std::string device = "/dev/input/js0";
  double scale = 0.2;
  double rate_hz = 200.0;
  double seconds = 0.0;
  double patience_s = 5.0;
  std::string delay;
  std::uint16_t relay_port = 0;
  std::string relay_log;
};

void bind(CLI::App& root, ConsoleArguments& arguments, Console& console) {
  root.description(
      "Sends a hand controller's poses and pedals to `trocar trial run … --operator tcp --listen PORT`, or to a trial\n"
      "in the window. A gamepad has the tools at its sticks, the jaws at A, the clutch at B, the other arm at Y, "
      "small\n"
      "ways at the right bumper and the agent's pedal at the left one.");
  root.add_option("--connect", arguments.connect, "HOST:PORT of the workbench")->required();
  root.add_option("--source", arguments.source,
                  "gamepad: as a person moves its sticks; scripted: as --script says; replay: as a demonstration went; "
                  "still: a hand at rest")
      ->check(CLI::IsMember({"gamepad", "scripted", "replay", "still"}))
      ->capture_default_str();
  root.add_option("--script", arguments.script,
                  "Of scripted: a file with lines like \"0.5 agent down\", \"1.5 move 0.01 0 0 over 0.5\", "
                  "\"2 turn 0 0 30 over 0.5\", \"3 grip -20 over 0.3\", \"4 away\", \"5 end\" (s, m, degrees)");
  root.add_option("--replay", arguments.replay, "Of replay: PROJECT and the demonstration or trial")->expected(2);
  root.add_option("--device", arguments.device, "Of gamepad: where it is")->capture_default_str();
  root.add_option("--scale", arguments.scale, "Of replay and gamepad: from hand to tool, as the trial has it")
      ->check(CLI::Range(0.1, 0.5))
      ->capture_default_str();
  root.add_option("--rate", arguments.rate_hz, "Frames a second")
      ->check(CLI::Range(1.0, 2000.0))
      ->capture_default_str();
  root.add_option("--seconds", arguments.seconds,
                  "Ends after so long; else with what it plays, a still hand after 60 s, a gamepad with the connection")
      ->check(CLI::Range(0.001, 86400.0));
  root.add_option("--patience", arguments.patience_s, "Seconds that it tries to get a connection")
      ->check(CLI::Range(0.0, 3600.0))
      ->capture_default_str();
  CLI::Option* delay = root.add_option(
      "--delay", arguments.delay,
      "Of the network, in ms: 40, normal:20:5, lognormal:20:5, ar1:20:5, trace:FILE; then ,stall:0.01:200");
  root.add_option("--relay-port", arguments.relay_port, "Of the relay that makes the delay; else any that is free")
      ->needs(delay);
  root.add_option("--relay-log", arguments.relay_log, "The delay of each packet as CSV")->needs(delay);
  root.add_flag("--json", console.json, "One object instead of text");
  root.add_flag("--quiet", console.quiet, "No progress and no text");
}

/// What is sent, and how long it lasts; 0: it has no end.
struct Source {
  std::function<link::HandFrame(double)> hand;
  double end_s = 0.0;
};

/// A pad that was unplugged is one that nobody holds: the workbench then holds the arm.
Result<Source> gamepad_of(const ConsoleArguments& arguments, Console& console) {
  constexpr double kDay_s = 86400.0;
  TROCAR_ASSIGN_OR_RETURN(device::Joystick opened, device::Joystick::open(arguments.device));
  auto joystick = std::make_shared<device::Joystick>(std::move(opened));
  auto hand = std::make_shared<link::PadHand>(arguments.scale);
  const auto frame_at = [joystick, hand, &console, gone = false](double t_s) mutable {
    trial::GamepadLook pad;
    if (const auto look = gone ? Result<device::JoystickLook>(device::JoystickLook{}) : joystick->look()) {
      pad = {look->axes, look->buttons};
    } else {
      gone = true;
      console.diagnostics.warn(look.error().text());
    }
    link::HandFrame frame = hand->at(t_s, pad);
    frame.present = !gone;
    return frame;
  };
  return Source{frame_at, kDay_s};
}

Result<Source> source_of(const ConsoleArguments& arguments, Console& console) {
  if ((arguments.source == "scripted") == arguments.script.empty()) {
    return fail(ErrorCode::kInvalidArgument, "--source scripted and --script FILE belong together");
  }
  if ((arguments.source == "replay") == arguments.replay.empty()) {
    return fail(ErrorCode::kInvalidArgument, "--source replay and --replay PROJECT DEMO belong together");
  }
  if (arguments.source == "gamepad") return gamepad_of(arguments, console);
  if (arguments.source == "scripted") {
    TROCAR_ASSIGN_OR_RETURN(const std::string text, read_file(arguments.script));
    auto script = link::parse_hand_script(text);
    if (!script) return tl::unexpected(std::move(script).error().at(arguments.script));
    const double end_s = script->end_s();
    return Source{[script = std::move(*script)](double t_s) { return script.at(t_s); }, end_s};
  }
  if (arguments.source == "replay") {
    TROCAR_ASSIGN_OR_RETURN(const workbench::ProjectFile file,
                            open_to_read(arguments.replay[0], console, Models::kDescribed));
    TROCAR_ASSIGN_OR_RETURN(const auto shown, find_shown(*file.project(), arguments.replay[1]));
    TROCAR_ASSIGN_OR_RETURN(auto hand, link::ReplayedHand::create(shown, arguments.scale));
    const double end_s = hand.end_s();
    return Source{[hand = std::move(hand)](double t_s) { return hand.at(t_s); }, end_s};
  }
  return Source{[](double) { return link::HandFrame{}; }, 0.0};
}

Json json_of(const link::DelayFigures& figures) {
  if (figures.count() == 0) return nullptr;
  return {{"count", figures.count()},
          {"mean_ms", 1e3 * figures.mean_s()},
          {"p50_ms", 1e3 * figures.quantile_s(0.50)},
          {"p95_ms", 1e3 * figures.quantile_s(0.95)},
          {"worst_ms", 1e3 * figures.worst_s()}};
}

std::string line_of(const std::string& name, const link::DelayFigures& figures) {
  if (figures.count() == 0) return fmt::format("\n{:<16} –", name);
  return fmt::format("\n{:<16} mean {:.2f} ms, p50 {:.2f} ms, p95 {:.2f} ms, worst {:.2f} ms", name,
                     1e3 * figures.mean_s(), 1e3 * figures.quantile_s(0.50), 1e3 * figures.quantile_s(0.95),
                     1e3 * figures.worst_s());
}

Result<Answer> run_console(const ConsoleArguments& arguments, Console& console) {
  constexpr double kStill_s = 60.0;
  link::HandConsoleOptions options;
  TROCAR_ASSIGN_OR_RETURN(options.to, link::endpoint_from(arguments.connect));
  TROCAR_ASSIGN_OR_RETURN(Source source, source_of(arguments, console));
  std::unique_ptr<link::DelayRelay> relay;
  if (!arguments.delay.empty()) {
    link::DelayRelayOptions relayed;
    relayed.to = options.to;
    relayed.port = arguments.relay_port;
    TROCAR_ASSIGN_OR_RETURN(relayed.delay, control::delay_from(arguments.delay));
    TROCAR_ASSIGN_OR_RETURN(relay, link::DelayRelay::start(relayed));
    options.to = {"127.0.0.1", relay->port()};
  }
  options.name = "trocar-console " + arguments.source;
  options.scripted = arguments.source != "gamepad";
  options.rate_hz = arguments.rate_hz;
  options.seconds = arguments.seconds > 0.0 ? arguments.seconds : source.end_s > 0.0 ? source.end_s : kStill_s;
  options.patience_s = arguments.patience_s;
  options.hand = std::move(source.hand);
  TROCAR_ASSIGN_OR_RETURN(const link::HandConsoleReport report, link::run_hand_console(options, console.progress()));
  Answer answer;
  answer.json = {{"source", arguments.source},
                 {"seconds", report.seconds},
                 {"sent", report.sent},
                 {"answered", report.answered},
                 {"connections", report.connections},
                 {"round_trip", json_of(report.round_trips)},
                 {"delay", json_of(report.delays)},
                 {"authority", report.authority},
                 {"ended", report.ended}};
  answer.summary = fmt::format("{} frames sent in {:.1f} s, {} answered", report.sent, report.seconds, report.answered);
  answer.text = answer.summary + (report.ended.empty() ? "" : "; " + report.ended);
  answer.text += line_of("there and back", report.round_trips) + line_of("delay", report.delays);
  if (relay) {
    const link::DelayRelayStatus status = relay->status();
    answer.json["relay"] = {
        {"delay", arguments.delay}, {"relayed", status.relayed}, {"applied", json_of(status.applied)}};
    answer.text += line_of("applied by relay", status.applied);
    if (!arguments.relay_log.empty()) {
      TROCAR_RETURN_IF_ERROR(write_file(arguments.relay_log, link::to_csv(relay->log())));
    }
  }
  return answer;
}

int run(int argc, char** argv) {
  Console console;
  console.program = "trocar-console";
  ConsoleArguments arguments;
  CLI::App root;
  bind(root, arguments, console);
  try {
    root.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    fmt::print("{}", root.help());
    return kExitDone;
  } catch (const CLI::ParseError& error) {
    return console.give_up(Error(ErrorCode::kInvalidArgument, error.what()));
  }
  cancel_on_signals(console);
  const Result<Answer> answer = run_console(arguments, console);
  if (!answer) {
    console.print_warnings();
    return console.give_up(answer.error());
  }
  if (const Status printed = console.print(*answer); !printed) {
    console.print_error(printed.error());
    return exit_code(printed.error().code());
  }
  return kExitDone;
}

}  // namespace
}  // namespace trocar::app

int main(int argc, char** argv) {
  trocar::app::report_crashes("trocar-console");
  try {
    return trocar::app::run(argc, argv);
  } catch (const std::exception& exception) {
    fmt::print(stderr, "trocar-console: stopped by an unexpected error: {}\n", exception.what());
    return trocar::app::kExitWorld;
  }
}
