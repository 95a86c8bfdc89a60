#include "app/options.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "app/commands/trial_commands.h"
#include "app/usage.h"

namespace trocar::app {
namespace {

/// The parameters of the edit after `demo stack PROJECT DEMO EDIT change` look like options of the command itself. With
/// a blank in front they are words, and the command takes the blank off again.
std::vector<std::string> with_edit_words_kept(std::vector<std::string> words) {
  constexpr std::array<std::string_view, 2> kCommand{"demo", "stack"};
  constexpr std::array<std::string_view, 7> kOfAll{"--json", "-q", "--quiet", "-v", "--verbose", "-h", "--help"};
  const auto command = std::search(words.begin(), words.end(), kCommand.begin(), kCommand.end());
  auto word = std::find(command, words.end(), "change");
  for (; word != words.end(); ++word) {
    const bool of_all = std::find(kOfAll.begin(), kOfAll.end(), *word) != kOfAll.end();
    if (word->starts_with('-') && *word != "--" && !of_all) word->insert(0, " ");
  }
  return words;
}

}  // namespace

Options::Options() : root_("Teach a surgical robot by demonstration: record, edit, learn, look, film.", "trocar") {
  root_.formatter(std::make_shared<UsageFormatter>());
  root_.fallthrough();
  root_.require_subcommand(1);
  root_.set_help_flag("-h,--help", "Print this help and exit");
  root_.set_version_flag("--version", "trocar " TROCAR_VERSION);
  root_.add_flag("--json", json, "Print one JSON object on standard output");
  root_.add_flag("-q,--quiet", quiet, "Print errors only");
  root_.add_flag("-v,--verbose", verbose, "Log what is done");
  root_.footer("Exit codes: 0 done, 1 a check failed, 2 wrong usage, 3 the outside world (file, device, codec).");
  add_project_commands(root_, chosen_);
  add_demo_commands(root_, chosen_);
  add_model_commands(root_, chosen_);
  add_rollout_commands(root_, chosen_);
  add_field_commands(root_, chosen_);
  add_trial_commands(root_, chosen_);
  add_view_commands(root_, chosen_);
  add_video_commands(root_, chosen_);
  add_ui_commands(root_, chosen_);
  add_run_command(root_, chosen_);
  add_doctor_command(root_, chosen_);
}

Result<Action> Options::parse(const std::vector<std::string>& arguments) {
  chosen_ = nullptr;
  std::vector<std::string> words = arguments;
  if (!words.empty() && words.front() == "help") {
    words.erase(words.begin());
    words.emplace_back("--help");
  }
  try {
    const std::vector<std::string> kept = with_edit_words_kept(words);
    root_.parse(std::vector<std::string>(kept.rbegin(), kept.rend()));
  } catch (const CLI::CallForVersion&) {
    return Action([text = root_.version()](Console&) -> Result<Answer> {
      return Answer{{{"version", text}}, text, {}};
    });
  } catch (const CLI::Success&) {
    if (const std::string unknown = unknown_command(root_); !unknown.empty()) {
      return fail(ErrorCode::kInvalidArgument,
                  complaint(root_, CLI::ExtrasError(std::vector<std::string>{unknown}), words));
    }
    return Action([text = help_text(root_)](Console&) -> Result<Answer> { return Answer{{{"help", text}}, text, {}}; });
  } catch (const CLI::ParseError& error) {
    return fail(ErrorCode::kInvalidArgument, complaint(root_, error, words));
  }
  if (!chosen_) return fail(ErrorCode::kInvalidArgument, "no command given (see trocar --help)");
  return chosen_;
}

}  // namespace trocar::app
