#include "app/usage.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "app/suggestion.h"

namespace trocar::app {
namespace {

/// The command that was reached before the words stopped making sense.
const CLI::App& reached(const CLI::App& root) {
  const CLI::App* at = &root;
  while (!at->get_subcommands().empty()) at = at->get_subcommands().back();
  return *at;
}

std::vector<const CLI::App*> commands_of(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App*) { return true; });
}

std::vector<Known> known_commands(const CLI::App& app) {
  std::vector<Known> known;
  for (const CLI::App* command : commands_of(app)) known.push_back({command->get_name(), ""});
  return known;
}

/// The commands of the commands, each shown whole: "demo replay".
std::vector<Known> known_below(const CLI::App& app) {
  std::vector<Known> known;
  for (const CLI::App* noun : commands_of(app)) {
    for (const CLI::App* verb : commands_of(*noun)) {
      known.push_back({verb->get_name(), noun->get_name() + " " + verb->get_name()});
    }
  }
  return known;
}

/// Of the command and all that it is part of, which take theirs too.
std::vector<Known> known_options(const CLI::App& app) {
  std::vector<Known> known;
  for (const CLI::App* at = &app; at != nullptr; at = at->get_parent()) {
    for (const CLI::Option* option : at->get_options()) {
      for (const std::string& name : option->get_lnames()) known.push_back({name, "--" + name});
    }
  }
  return known;
}

std::vector<const CLI::Option*> arguments_of(const CLI::App& app) {
  return app.get_options([](const CLI::Option* option) { return option->get_positional(); });
}

/// "trocar demo edit PROJECT DEMO trim".
std::string path_of(const CLI::App& app) {
  if (app.get_parent() == nullptr) return app.get_name();
  std::string path = path_of(*app.get_parent());
  for (const CLI::Option* argument : arguments_of(*app.get_parent())) path += " " + argument->get_name(true);
  return path + " " + app.get_name();
}

/// A verb that was taken for an argument, since one before it was left out.
const CLI::App* misplaced_verb(const CLI::App& app) {
  for (const CLI::Option* argument : arguments_of(app)) {
    for (const std::string& word : argument->results()) {
      for (const CLI::App* command : commands_of(app)) {
        if (command->get_name() == word) return command;
      }
    }
  }
  return nullptr;
}

std::string usage_of(const CLI::App& app) {
  std::string usage = path_of(app);
  for (const CLI::Option* argument : arguments_of(app)) usage += " " + argument->get_name(true);
  return usage;
}

/// Of a word that is too many after all arguments are there.
std::string one_too_many(const std::string& word, const std::vector<std::string>& words) {
  const auto at = std::find(words.begin(), words.end(), word);
  if (at == words.begin() || at == words.end() || (at - 1)->starts_with("-"))
    return word + " is one word too many here";
  return fmt::format("{} is one word too many here; if it is part of a name, quote the name: \"{} {}\"", word,
                     *(at - 1), word);
}

std::string on_unknown(const CLI::App& at, const std::string& word, const std::vector<std::string>& words) {
  if (word.starts_with("-") && word.size() > 1) {
    const std::string name = word.substr(0, word.find('='));
    return fmt::format("{} is no option of {}{}", name, path_of(at), did_you_mean(name, known_options(at)));
  }
  if (commands_of(at).empty()) return one_too_many(word, words);
  std::string meant = did_you_mean(word, known_commands(at));
  if (meant.empty()) meant = did_you_mean(word, known_below(at));
  return fmt::format("{} is no command{}", word, meant.empty() ? there_are(known_commands(at)) : meant);
}

std::string tidied(std::string sentence) {
  std::replace(sentence.begin(), sentence.end(), '\n', ' ');
  while (!sentence.empty() && (sentence.back() == '.' || sentence.back() == ' ')) sentence.pop_back();
  return sentence;
}

/// Some errors leave words behind that came after what is really wrong.
bool is_about_words(const CLI::ParseError& error) {
  const auto code = static_cast<CLI::ExitCodes>(error.get_exit_code());
  return code == CLI::ExitCodes::ExtrasError || code == CLI::ExitCodes::RequiredError;
}

}  // namespace

std::string UsageFormatter::make_usage(const CLI::App* app, std::string /*name*/) const {
  return CLI::Formatter::make_usage(app, path_of(*app));
}

std::string help_text(const CLI::App& root) {
  const CLI::App& at = reached(root);
  const CLI::App* verb = misplaced_verb(at);
  return verb == nullptr ? root.help() : verb->help();
}

std::string unknown_command(const CLI::App& root) {
  if (commands_of(reached(root)).empty()) return "";
  const std::vector<std::string> unknown = root.remaining(true);
  const auto word = std::find_if(unknown.begin(), unknown.end(), [](const auto& w) { return !w.starts_with("-"); });
  return word == unknown.end() ? "" : *word;
}

std::string complaint(const CLI::App& root, const CLI::ParseError& error, const std::vector<std::string>& words) {
  const CLI::App& at = reached(root);
  const std::vector<std::string> unknown = root.remaining(true);
  const std::string help = fmt::format(" (see {} --help)", path_of(at));
  if (!is_about_words(error)) return tidied(error.what()) + help;
  if (const CLI::App* verb = misplaced_verb(at)) {
    return fmt::format("an argument is missing before {}; write {}", verb->get_name(), usage_of(*verb)) + help;
  }
  if (!unknown.empty()) return on_unknown(at, unknown.front(), words) + help;
  const std::string sentence = tidied(error.what());
  if (sentence.find("subcommand is required") == std::string::npos) return sentence + help;
  return fmt::format("{} needs a command{}", path_of(at), there_are(known_commands(at))) + help;
}

}  // namespace trocar::app
