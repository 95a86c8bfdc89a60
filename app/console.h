/// What every command shares: how it answers, how far it has come, and how it is stopped.
#pragma once

#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "engine/core/clock.h"
#include "engine/core/diagnostics.h"
#include "engine/core/progress.h"
#include "engine/core/result.h"

namespace trocar::app {

using Json = nlohmann::ordered_json;

/// What a command found: the keys of `--json`, one line for a table of steps, and what a person reads.
struct Answer {
  Json json = Json::object();
  std::string summary;
  std::string text;    ///< Several lines; empty: the summary is all.
  bool passed = true;  ///< False: a check was run and did not hold (exit 1).
};

/// Exit codes of every command.
enum ExitCode { kExitDone = 0, kExitCheckFailed = 1, kExitUsage = 2, kExitWorld = 3 };
ExitCode exit_code(ErrorCode code);

/// One process's way to speak and to be interrupted. Threads: the main thread; the signal handler only cancels.
class Console {
 public:
  bool json = false;
  bool quiet = false;
  bool verbose = false;
  const char* program = "trocar";  ///< Errors begin with it.
  int script_depth = 0;            ///< Scripts that run each other.
  Diagnostics diagnostics;         ///< Printed after the command, each once.
  std::shared_ptr<const Clock> clock = std::make_shared<SystemClock>();

  Progress& progress() { return *progress_; }
  /// A new command begins: fraction 0. A cancel that has come in stays.
  void restart_progress();

  /// Before a command puts its result in place. Errors: kCancelled if somebody asked it to stop.
  Status check_not_cancelled() const;

  /// Prints the answer to standard output and the warnings to standard error.
  /// Errors: kIo if not all that was ever printed has arrived (full disk, closed pipe).
  Status print(const Answer& answer);
  void print_error(const Error& error) const;
  /// The error on standard error and, with `--json`, as an object on standard output too: `error`, `exit`.
  ExitCode give_up(const Error& error) const;
  void print_warnings();

 private:
  std::unique_ptr<Progress> progress_ = std::make_unique<Progress>();
  std::size_t printed_warnings_ = 0;
};

/// Ctrl-C and SIGTERM cancel the console's progress, a second one ends the process. Once in a process.
void cancel_on_signals(Console& console);

/// One value as a person reads it: numbers to six digits, the parts of an array or an object in a row, "–" for none.
std::string shown(const Json& value);

/// While it lives, tells on standard error how far it is: on a terminal a bar for what takes longer than a moment, else
/// a line now and then for what takes long.
class ProgressBar {
 public:
  explicit ProgressBar(Console& console);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace trocar::app
