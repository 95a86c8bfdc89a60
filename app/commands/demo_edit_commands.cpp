#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/commands/demo_commands.h"
#include "engine/demonstration/quality.h"

namespace trocar::app {
namespace {

/// Where the edit goes; its own parameters are beside it.
struct Target {
  std::string project;
  std::string demonstration;
};

Answer unchanged(const demonstration::Demonstration& document) {
  Answer answer;
  answer.json = {{"id", nullptr},
                 {"demonstration", document.id.value},
                 {"hash_before", hash_text(document.hash())},
                 {"hash_after", hash_text(document.hash())},
                 {"hash", hash_text(document.hash())},
                 {"duration_s", document.duration_s()}};
  answer.summary = "nothing to change";
  return answer;
}

/// Nothing if there is nothing to change.
using EditMaker = std::function<Result<std::optional<demonstration::Edit>>(const demonstration::Demonstration&)>;

Result<Answer> commit(const Target& target, Console& console, const EditMaker& edit_of) {
  TROCAR_ASSIGN_OR_RETURN(workbench::ProjectFile file, open_to_edit(target.project, console, Models::kDescribed));
  TROCAR_ASSIGN_OR_RETURN(const auto before, find_demonstration(*file.project(), target.demonstration));
  TROCAR_ASSIGN_OR_RETURN(const std::optional<demonstration::Edit> edit, edit_of(*before));
  if (!edit) return unchanged(*before);
  const workbench::Edit whole = workbench::EditDemonstration{before->id, *edit};
  const std::string description = workbench::describe(whole, *file.project());
  TROCAR_ASSIGN_OR_RETURN(const std::int64_t id, file.commit(whole));
  const auto after = file.project()->demonstrations.at(before->id);
  Answer answer;
  answer.json = {{"id", id},
                 {"name", demonstration::name_of(*edit)},
                 {"description", description},
                 {"demonstration", after->id.value},
                 {"hash_before", hash_text(before->hash())},
                 {"hash_after", hash_text(after->hash())},
                 {"hash", hash_text(after->hash())},
                 {"duration_s", after->duration_s()}};
  answer.summary = description;
  answer.text = fmt::format("Edit {}: {}", id, description);
  return answer;
}

/// The history says where the edit was made, so that times beyond the ends are the ends. What is no number stays one
/// that the edit refuses.
double within(const demonstration::Demonstration& document, double t_s) {
  return std::isfinite(t_s) ? std::clamp(t_s, 0.0, document.full_duration_s()) : t_s;
}

struct TrimArguments {
  std::shared_ptr<const Target> target;
  std::optional<double> from_s;
  std::optional<double> to_s;
  bool idle = false;
};

Result<Answer> run_trim(const TrimArguments& arguments, Console& console) {
  if (arguments.idle == (arguments.from_s.has_value() || arguments.to_s.has_value())) {
    return fail(ErrorCode::kInvalidArgument, "trim needs --from, --to or both, or else --idle alone");
  }
  return commit(*arguments.target, console,
                [&](const demonstration::Demonstration& document) -> Result<std::optional<demonstration::Edit>> {
                  if (arguments.idle) return demonstration::idle_ends(document);
                  return demonstration::Trim{within(document, arguments.from_s.value_or(document.begin_s)),
                                             within(document, arguments.to_s.value_or(document.end_s))};
                });
}

struct RenameArguments {
  std::shared_ptr<const Target> target;
  std::string name;
};

Result<Answer> run_rename(const RenameArguments& arguments, Console& console) {
  return commit(*arguments.target, console,
                [&](const demonstration::Demonstration&) -> Result<std::optional<demonstration::Edit>> {
                  return demonstration::Rename{arguments.name};
                });
}

struct LabelArguments {
  std::shared_ptr<const Target> target;
  std::string segment;
  double from_s = 0.0;
  double to_s = 0.0;
};

Result<Answer> run_label(const LabelArguments& arguments, Console& console) {
  return commit(*arguments.target, console,
                [&](const demonstration::Demonstration& document) -> Result<std::optional<demonstration::Edit>> {
                  TROCAR_ASSIGN_OR_RETURN(const demonstration::Segment segment, segment_from(arguments.segment));
                  return demonstration::LabelSegment{segment, within(document, arguments.from_s),
                                                     within(document, arguments.to_s)};
                });
}

struct RemoveArguments {
  Target target;
};

Result<Answer> run_remove(const RemoveArguments& arguments, Console& console) {
  TROCAR_ASSIGN_OR_RETURN(workbench::ProjectFile file,
                          open_to_edit(arguments.target.project, console, Models::kDescribed));
  TROCAR_ASSIGN_OR_RETURN(const auto demonstration,
                          find_demonstration(*file.project(), arguments.target.demonstration));
  TROCAR_ASSIGN_OR_RETURN(const std::int64_t id, file.commit(workbench::RemoveDemonstration{demonstration->id}));
  Answer answer;
  answer.json = {{"id", id}, {"demonstration", demonstration->id.value}};
  answer.summary = fmt::format("removed {}; undo brings it back", demonstration->name);
  return answer;
}

void bind_target(CLI::App& verb, Target& target) {
  verb.add_option("PROJECT", target.project, "The project file")->required();
  verb.add_option("DEMO", target.demonstration, "Its id or name")->required();
}

}  // namespace

void add_demo_edit_commands(CLI::App& noun, Action& chosen) {
  CLI::App& edit = *noun.add_subcommand("edit", "Change a demonstration; every change can be undone");
  auto target = std::make_shared<Target>();
  bind_target(edit, *target);
  edit.require_subcommand(1);

  add_verb<TrimArguments>(
      edit, chosen, "trim", "Move the gates; the recording keeps everything",
      [target](CLI::App& verb, TrimArguments& a) {
        a.target = target;
        verb.add_option("--from", a.from_s, "New begin in seconds");
        verb.add_option("--to", a.to_s, "New end in seconds");
        verb.add_flag("--idle", a.idle, "Cut both ends where neither tool moves");
      },
      run_trim);
  add_verb<RenameArguments>(
      edit, chosen, "rename", "Give another name",
      [target](CLI::App& verb, RenameArguments& a) {
        a.target = target;
        verb.add_option("NAME", a.name, "The new name")->required();
      },
      run_rename);
  add_verb<LabelArguments>(
      edit, chosen, "label", "Say which segment a span is",
      [target](CLI::App& verb, LabelArguments& a) {
        a.target = target;
        verb.add_option("SEGMENT", a.segment, "A, B, C, D or E")->required();
        verb.add_option("--from", a.from_s, "Begin in seconds")->required();
        verb.add_option("--to", a.to_s, "End in seconds")->required();
      },
      run_label);
  add_verb<RemoveArguments>(
      noun, chosen, "remove", "Take a demonstration out of the project",
      [](CLI::App& verb, RemoveArguments& a) { bind_target(verb, a.target); }, run_remove);
}

}  // namespace trocar::app
