/// The command line's grammar: which commands there are, and the one that was asked for.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "app/console.h"

namespace trocar::app {

using Action = std::function<Result<Answer>(Console&)>;

/// Parses one command line. The commands put what they will do into `chosen`; nothing runs while parsing.
class Options {
 public:
  Options();

  /// Errors: kInvalidArgument with the parser's sentence. Help and version are answers, found in `chosen`.
  Result<Action> parse(const std::vector<std::string>& arguments);

  bool json = false;
  bool quiet = false;
  bool verbose = false;

 private:
  CLI::App root_;
  Action chosen_;
};

/// Makes a verb whose arguments live in a struct of its own: `setup` binds them to options, `run` gets them.
template <typename Arguments>
CLI::App* add_verb(CLI::App& noun, Action& chosen, const std::string& name, const std::string& help,
                   const std::function<void(CLI::App&, Arguments&)>& setup,
                   Result<Answer> (*run)(const Arguments&, Console&)) {
  CLI::App* verb = noun.add_subcommand(name, help);
  auto arguments = std::make_shared<Arguments>();
  setup(*verb, *arguments);
  verb->callback(
      [arguments, run, &chosen] { chosen = [arguments, run](Console& console) { return run(*arguments, console); }; });
  return verb;
}

// One for each noun, in app/commands.
void add_project_commands(CLI::App& root, Action& chosen);  ///< new, info, history, undo, redo
void add_demo_commands(CLI::App& root, Action& chosen);
void add_model_commands(CLI::App& root, Action& chosen);
void add_rollout_commands(CLI::App& root, Action& chosen);
void add_field_commands(CLI::App& root, Action& chosen);
void add_view_commands(CLI::App& root, Action& chosen);
void add_video_commands(CLI::App& root, Action& chosen);
void add_ui_commands(CLI::App& root, Action& chosen);
void add_doctor_command(CLI::App& root, Action& chosen);
void add_run_command(CLI::App& root, Action& chosen);

}  // namespace trocar::app
