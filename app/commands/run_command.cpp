#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "app/options.h"
#include "app/script.h"
#include "engine/core/file.h"

namespace trocar::app {
namespace {

struct ScriptArguments {
  std::string script;
  std::string out = "out";
  std::vector<std::string> settings;
};

void bind_script(CLI::App& verb, ScriptArguments& arguments) {
  verb.add_option("SCRIPT", arguments.script, "A text file of trocar commands, one a line")->required();
  verb.add_option("--out", arguments.out, "The folder that ${out} stands for; made if missing")->capture_default_str();
  verb.footer(
      "A line of a script is a command as it is typed, without `trocar`. `default NAME VALUE` gives a variable its "
      "value\n"
      "where --set does not, ${NAME} stands for it; ${out} and ${here} (the script's folder) are always there. `## "
      "Title`\n"
      "names the next step, # begins a comment.");
  verb.add_option("--set", arguments.settings, "NAME=VALUE: a variable of the script");
}

Result<Variables> variables_of(const ScriptArguments& arguments) {
  Variables variables = {{"out", arguments.out},
                         {"here", std::filesystem::path(arguments.script).parent_path().string()}};
  for (const std::string& setting : arguments.settings) {
    const std::size_t equals = setting.find('=');
    if (equals == std::string::npos || equals == 0) {
      return fail(ErrorCode::kInvalidArgument, fmt::format("{} is not of the form NAME=VALUE", setting));
    }
    variables[setting.substr(0, equals)] = setting.substr(equals + 1);
  }
  return variables;
}

std::set<std::string> names_of(const std::vector<std::string>& settings) {
  std::set<std::string> names;
  for (const std::string& setting : settings) names.insert(setting.substr(0, setting.find('=')));
  return names;
}

Status make_folder(const std::string& path) {
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (error) {
    return tl::unexpected(Error(ErrorCode::kIo, "cannot make the folder: " + error.message()).at(path));
  }
  return {};
}

/// Bytes that are not the first of a UTF-8 character take no room.
std::size_t shown_width(std::string_view text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

std::string padded(const std::string& text, std::size_t width) {
  return text + std::string(width - std::min(width, shown_width(text)), ' ');
}

/// Rows appear as steps end, so that one sees where a long script is; together they are the table.
class Table {
 public:
  Table(const std::vector<ScriptStep>& steps, bool shown) : shown_(shown) {
    for (const ScriptStep& step : steps) width_ = std::max(width_, std::min<std::size_t>(shown_width(step.title), 64));
    row("step", "     s", "what it found");
  }
  void row(const std::string& step, const std::string& seconds, const std::string& found) const {
    if (!shown_) return;
    if (isatty(STDERR_FILENO) != 0) fmt::print(stderr, "\r\033[K");  // over the progress bar
    // What does not arrive is told when the answer is printed.
    const std::string line = fmt::format("{}  {}  {}\n", padded(step, width_), seconds, found);
    std::fwrite(line.data(), 1, line.size(), stdout);
    std::fflush(stdout);
  }

 private:
  bool shown_;
  std::size_t width_ = 4;
};

Result<Answer> run_step(const ScriptStep& step, Console& console) {
  if (console.progress().cancelled()) return fail(ErrorCode::kCancelled, "stopped by the user");
  Options options;
  console.restart_progress();
  TROCAR_ASSIGN_OR_RETURN(const Action action, options.parse(step.arguments));
  return action(console);
}

/// Counts the scripts that run each other.
class Nesting {
 public:
  explicit Nesting(Console& console) : depth_(console.script_depth) { ++depth_; }
  ~Nesting() { --depth_; }
  Nesting(const Nesting&) = delete;
  Nesting& operator=(const Nesting&) = delete;
  bool too_deep() const { return depth_ > kDeepest; }

 private:
  static constexpr int kDeepest = 8;
  int& depth_;
};

Result<Answer> run_script(const ScriptArguments& arguments, Console& console) {
  const Nesting nesting(console);
  if (nesting.too_deep()) {
    return tl::unexpected(
        Error(ErrorCode::kInvalidArgument, "the script runs itself, or scripts are too deep in each other")
            .at(arguments.script));
  }
  TROCAR_ASSIGN_OR_RETURN(const Variables variables, variables_of(arguments));
  TROCAR_ASSIGN_OR_RETURN(const std::string text, read_file(arguments.script));
  Result<std::vector<ScriptStep>> steps = parse_script(text, variables, names_of(arguments.settings));
  if (!steps) return tl::unexpected(std::move(steps).error().at(arguments.script));
  TROCAR_RETURN_IF_ERROR(make_folder(arguments.out));

  const Table table(*steps, !console.json && !console.quiet);
  const double begin_s = console.clock->now_s();
  Answer all;
  all.json = {{"steps", Json::array()}};
  for (const ScriptStep& step : *steps) {
    const double step_begin_s = console.clock->now_s();
    Result<Answer> answer = run_step(step, console);
    const double seconds = console.clock->now_s() - step_begin_s;
    const std::string found = answer ? answer->summary : answer.error().text();
    table.row(step.title, fmt::format("{:6.2f}", seconds), found);
    const int code = answer ? (answer->passed ? kExitDone : kExitCheckFailed) : exit_code(answer.error().code());
    all.json["steps"].push_back({{"line", step.line},
                                 {"command", step.title},
                                 {"found", found},
                                 {"exit", code},
                                 {"seconds", seconds},
                                 {"answer", answer ? answer->json : Json()}});
    if (!answer) {
      return tl::unexpected(
          std::move(answer).error().in(fmt::format("do line {} ({})", step.line, step.title)).at(arguments.script));
    }
    all.passed = answer->passed;
    if (!all.passed) break;
  }
  const double seconds = console.clock->now_s() - begin_s;
  all.json["seconds"] = seconds;
  all.json["out"] = arguments.out;
  all.summary = all.passed
                    ? fmt::format("{} steps in {:.1f} s; everything is in {}", steps->size(), seconds, arguments.out)
                    : fmt::format("a check did not hold in line {}", (*steps)[all.json["steps"].size() - 1].line);
  return all;
}

}  // namespace

void add_run_command(CLI::App& root, Action& chosen) {
  add_verb<ScriptArguments>(root, chosen, "run", "Run a script of trocar commands; stops at the first failure",
                            bind_script, run_script);
}

}  // namespace trocar::app
