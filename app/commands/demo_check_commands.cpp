#include <fmt/format.h>

#include "app/commands/demo_commands.h"
#include "engine/demonstration/diff.h"

namespace trocar::app {
namespace {

struct DiffArguments {
  std::string project;
  std::string demonstration;
  std::string against = "original";
};

void bind_diff(CLI::App& verb, DiffArguments& arguments) {
  verb.add_option("PROJECT", arguments.project, "The project file")->required();
  verb.add_option("DEMO", arguments.demonstration, "Its id or name")->required();
  verb.add_option("--against", arguments.against, "`original` (as it was recorded) or another demonstration")
      ->capture_default_str();
}

Result<Answer> run_diff(const DiffArguments& arguments, Console& console) {
  TROCAR_ASSIGN_OR_RETURN(const workbench::ProjectFile file,
                          open_to_read(arguments.project, console, Models::kDescribed));
  TROCAR_ASSIGN_OR_RETURN(const auto after, find_demonstration(*file.project(), arguments.demonstration));
  std::shared_ptr<const demonstration::Demonstration> before;
  if (arguments.against == "original") {
    before = std::make_shared<const demonstration::Demonstration>(demonstration::original_of(*after));
  } else {
    TROCAR_ASSIGN_OR_RETURN(before, find_demonstration(*file.project(), arguments.against));
  }
  const demonstration::Difference difference = demonstration::difference(*before, *after);
  std::vector<std::string> labels = demonstration::label_differences(*before, *after);
  if (before->name != after->name) labels.push_back(fmt::format("named {}, not {}", after->name, before->name));
  Answer answer;
  answer.json = {{"id", after->id.value},
                 {"against", arguments.against},
                 {"duration_change_s", difference.duration_change_s},
                 {"removed", difference.removed},
                 {"added", difference.added},
                 {"moved", difference.moved},
                 {"max_deviation_mm", 1e3 * difference.max_deviation_m},
                 {"rms_deviation_mm", 1e3 * difference.rms_deviation_m},
                 {"labels", labels}};
  answer.summary =
      fmt::format("{:+.2f} s, {} samples removed, {} added, {} moved (at most {:.2f} mm)", difference.duration_change_s,
                  difference.removed, difference.added, difference.moved, 1e3 * difference.max_deviation_m);
  answer.text = fmt::format("{} against {}: {}", after->name, arguments.against, answer.summary);
  for (const std::string& clause : labels) answer.text += "\n  " + clause;
  if (!labels.empty()) answer.summary += fmt::format(", {}", counted(labels.size(), "other change"));
  return answer;
}

}  // namespace

void add_demo_check_commands(CLI::App& noun, Action& chosen) {
  add_verb<DiffArguments>(noun, chosen, "diff", "Say what edits changed, or how two demonstrations differ", bind_diff,
                          run_diff);
}

}  // namespace trocar::app
