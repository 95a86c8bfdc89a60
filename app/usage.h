/// What help and complaints about a command line say.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace trocar::app {

/// Usage lines that name the arguments of every command on the way: `trocar demo edit PROJECT DEMO trim [OPTIONS]`.
class UsageFormatter final : public CLI::Formatter {
 public:
  std::string make_usage(const CLI::App* app, std::string name) const override;
};

/// Help for what was asked about, also where an argument was left out before a verb (`demo edit trim --help`).
std::string help_text(const CLI::App& root);

/// The word that stands where a command should but is none; empty if there is no such word. After parsing.
std::string unknown_command(const CLI::App& root);

/// One sentence, without a full stop, on why `words` are no command: what is wrong, and what may have been meant.
std::string complaint(const CLI::App& root, const CLI::ParseError& error, const std::vector<std::string>& words);

}  // namespace trocar::app
