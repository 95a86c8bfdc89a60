#include "app/options.h"

#include <algorithm>

namespace trocar::app {

Options::Options() : root_("Teach a surgical robot by demonstration: record, edit, learn, look, film.", "trocar") {
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
  add_view_commands(root_, chosen_);
  add_video_commands(root_, chosen_);
  add_ui_commands(root_, chosen_);
  add_run_command(root_, chosen_);
  add_doctor_command(root_, chosen_);
}

Result<Action> Options::parse(const std::vector<std::string>& arguments) {
  chosen_ = nullptr;
  std::vector<std::string> reversed(arguments.rbegin(), arguments.rend());
  try {
    root_.parse(std::move(reversed));
  } catch (const CLI::CallForVersion&) {
    return Action([text = root_.version()](Console&) -> Result<Answer> {
      return Answer{{{"version", text}}, text, {}};
    });
  } catch (const CLI::Success&) {
    return Action([text = root_.help()](Console&) -> Result<Answer> { return Answer{{{"help", text}}, text, {}}; });
  } catch (const CLI::ParseError& error) {
    const std::vector<std::string> unknown = root_.remaining(true);
    std::string sentence = unknown.empty() ? error.what() : unknown.front() + " is no command or option here";
    std::replace(sentence.begin(), sentence.end(), '\n', ' ');
    while (!sentence.empty() && (sentence.back() == '.' || sentence.back() == ' ')) sentence.pop_back();
    return fail(ErrorCode::kInvalidArgument, sentence + " (see --help)");
  }
  if (!chosen_) return fail(ErrorCode::kInvalidArgument, "no command given (see --help)");
  return chosen_;
}

}  // namespace trocar::app
