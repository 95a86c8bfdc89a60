#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <exception>
#include <string>
#include <vector>

#include "app/console.h"
#include "app/crash_report.h"
#include "app/options.h"

namespace trocar::app {
namespace {

void log_to_standard_error(bool verbose) {
  spdlog::set_default_logger(spdlog::stderr_color_mt("trocar"));
  spdlog::set_level(verbose ? spdlog::level::debug : spdlog::level::warn);
  spdlog::set_pattern("%^%l%$: %v");
}

int run(const std::vector<std::string>& arguments) {
  Console console;
  Options options;
  const Result<Action> action = options.parse(arguments);
  console.json = options.json;
  console.quiet = options.quiet;
  console.verbose = options.verbose;
  if (!action) {
    // The parser may have given up before it came to the flag.
    console.json = std::find(arguments.begin(), arguments.end(), "--json") != arguments.end();
    return console.give_up(action.error());
  }
  log_to_standard_error(options.verbose);
  cancel_on_signals(console);
  Result<Answer> answer = [&] {
    const ProgressBar bar(console);
    return (*action)(console);
  }();
  if (!answer) {
    console.print_warnings();
    return console.give_up(answer.error());
  }
  if (const Status printed = console.print(*answer); !printed) {
    console.print_error(printed.error());
    return exit_code(printed.error().code());
  }
  return answer->passed ? kExitDone : kExitCheckFailed;
}

}  // namespace
}  // namespace trocar::app

int main(int argc, char** argv) {
  trocar::app::report_crashes("trocar");
  // Libraries may throw what no module caught (out of memory); it is said in one sentence like any other error.
  try {
    return trocar::app::run({argv + 1, argv + argc});
  } catch (const std::exception& exception) {
    std::fprintf(stderr, "trocar: stopped by an unexpected error: %s\n", exception.what());
    return trocar::app::kExitWorld;
  }
}
