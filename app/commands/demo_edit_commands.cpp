#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <map>

#include "app/commands/demo_commands.h"
#include "engine/demonstration/edit_fields.h"
#include "engine/demonstration/edit_words.h"
#include "engine/demonstration/join.h"
#include "engine/demonstration/quality.h"
#include "engine/demonstration/snap_figures.h"

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

/// A name that two have cannot be asked for.
Status check_rename(const workbench::Project& project, demonstration::DemonstrationId id,
                    const demonstration::Edit& edit) {
  const auto* rename = std::get_if<demonstration::Rename>(&edit);
  if (rename == nullptr) return {};
  for (const auto& [other, document] : project.demonstrations) {
    if (other == id || document->name != rename->name) continue;
    return fail(ErrorCode::kInvalidArgument,
                fmt::format("demonstration {} is named {} already", other.value, rename->name));
  }
  return {};
}

Status tell_snap(const demonstration::Edit& edit, const demonstration::Demonstration& before, Answer& answer) {
  const auto* snap = std::get_if<demonstration::SnapToGrid>(&edit);
  if (snap == nullptr) return {};
  TROCAR_ASSIGN_OR_RETURN(const auto figures, demonstration::snap_figures(before, *snap));
  answer.json["snap"] = Json::array();
  for (const demonstration::SnapFigures& one : figures) {
    answer.json["snap"].push_back({{"arm", one.arm == 0 ? "left" : "right"},
                                   {"actions", one.actions},
                                   {"max_error_mm", 1e3 * one.max_error_m},
                                   {"mean_error_mm", 1e3 * one.mean_error_m},
                                   {"skipped_cells", one.skipped_cells},
                                   {"repeated_cells", one.repeated_cells}});
    answer.text += "\n  " + demonstration::sentence_of(one);
  }
  return {};
}

/// Nothing if there is nothing to change.
using EditMaker = std::function<Result<std::optional<demonstration::Edit>>(const demonstration::Demonstration&,
                                                                           const workbench::Project&)>;

Result<Answer> commit(const Target& target, Console& console, Models models, const EditMaker& edit_of) {
  TROCAR_ASSIGN_OR_RETURN(workbench::ProjectFile file, open_to_edit(target.project, console, models));
  TROCAR_ASSIGN_OR_RETURN(const auto before, find_demonstration(*file.project(), target.demonstration));
  TROCAR_ASSIGN_OR_RETURN(const std::optional<demonstration::Edit> edit, edit_of(*before, *file.project()));
  if (!edit) return unchanged(*before);
  TROCAR_RETURN_IF_ERROR(check_rename(*file.project(), before->id, *edit));
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
  const std::vector<demonstration::Join> joins = demonstration::joins_of(*edit, *before, *after);
  for (const demonstration::Join& join : joins) {
    answer.json["joins"].push_back(
        {{"at_s", join.at_s}, {"gap_s", join.gap_s}, {"moved_m", join.moved_m}, {"turned_rad", join.turned_rad}});
  }
  answer.summary = description;
  answer.text = fmt::format("Edit {}: {}", id, description);
  TROCAR_RETURN_IF_ERROR(tell_snap(*edit, *before, answer));
  if (!joins.empty()) answer.text += "; " + demonstration::sentence_of(joins);
  return answer;
}

/// The history says where the edit was made, so that times beyond the ends are the ends. What is no number stays one
/// that the edit refuses.
double within(const demonstration::Demonstration& document, double t_s) {
  return std::isfinite(t_s) ? std::clamp(t_s, 0.0, document.full_duration_s()) : t_s;
}

template <typename Edited>
concept HasSpan = requires(Edited& edit) {
  edit.from_s;
  edit.to_s;
};

demonstration::Edit kept_within(const demonstration::Demonstration& document, demonstration::Edit edit) {
  std::visit(
      [&]<typename Edited>(Edited& one) {
        if constexpr (HasSpan<Edited>) {
          one.from_s = within(document, one.from_s);
          one.to_s = within(document, one.to_s);
        }
      },
      edit);
  return edit;
}

/// The words of one edit as they were typed.
struct EditArguments {
  std::shared_ptr<const Target> target;
  std::string name;
  std::map<std::string, std::string> options;  ///< By name, without dashes; those not given are empty.
  std::vector<std::string> bare;
  bool idle = false;  ///< Of trim alone.
};

/// The source of a splice may be given by name, or left out if it is the document itself; so may its span.
Status find_source(EditArguments& arguments, const demonstration::Demonstration& document,
                   const workbench::Project& project) {
  const auto source = arguments.options.find("source");
  if (source == arguments.options.end()) return {};
  if (source->second.empty()) source->second = std::to_string(document.id.value);
  TROCAR_ASSIGN_OR_RETURN(const auto found, find_demonstration(project, source->second));
  source->second = std::to_string(found->id.value);
  std::string& from = arguments.options["clip-from"];
  std::string& to = arguments.options["clip-to"];
  if (from.empty()) from = fmt::format("{}", found->begin_s);
  if (to.empty()) to = fmt::format("{}", found->end_s);
  return {};
}

/// A span that is not given is all between the gates; a label has to say what it covers.
std::vector<std::string> words_of(const EditArguments& arguments, const demonstration::Demonstration& document) {
  std::vector<std::string> words{arguments.name};
  words.insert(words.end(), arguments.bare.begin(), arguments.bare.end());
  for (const auto& [option, value] : arguments.options) {
    std::string given = value;
    if (given.empty() && option == "from") given = fmt::format("{}", document.begin_s);
    if (given.empty() && option == "to") given = fmt::format("{}", document.end_s);
    if (!given.empty()) words.push_back(fmt::format("--{}={}", option, given));
  }
  return words;
}

/// A model may be given by name. Errors: those of `find_model`.
Status find_named_model(EditArguments& arguments, const workbench::Project& project) {
  const auto model = arguments.options.find("model");
  if (model == arguments.options.end() || model->second.empty() || model->second == "0") return {};
  TROCAR_ASSIGN_OR_RETURN(const auto found, find_model(project, model->second));
  model->second = std::to_string(found->id.value);
  return {};
}

/// Models are large; only a bridge that goes as one of them would needs them.
bool needs_models(const EditArguments& arguments) {
  const auto shape = arguments.options.find("shape");
  return shape != arguments.options.end() && shape->second == "policy";
}

Result<Answer> run_edit(const EditArguments& arguments, Console& console) {
  const bool span_given = arguments.options.contains("from") &&
                          !(arguments.options.at("from").empty() && arguments.options.at("to").empty());
  if (arguments.name == demonstration::Trim::kName && arguments.idle == span_given) {
    return fail(ErrorCode::kInvalidArgument, "trim needs --from, --to or both, or else --idle alone");
  }
  return commit(*arguments.target, console, needs_models(arguments) ? Models::kWhole : Models::kDescribed,
                [&](const demonstration::Demonstration& document,
                    const workbench::Project& project) -> Result<std::optional<demonstration::Edit>> {
                  if (arguments.idle) return demonstration::idle_ends(document);
                  EditArguments found = arguments;
                  TROCAR_RETURN_IF_ERROR(find_source(found, document, project));
                  TROCAR_RETURN_IF_ERROR(find_named_model(found, project));
                  TROCAR_ASSIGN_OR_RETURN(demonstration::Edit edit,
                                          demonstration::edit_from_words(words_of(found, document)));
                  return kept_within(document, std::move(edit));
                });
}

/// Makes an option of the command line from each parameter of an edit.
struct OptionMaker {
  CLI::App& verb;
  EditArguments& arguments;
  bool whole = false;  ///< The span must be given.

  template <typename Value>
  void field(const demonstration::Field& field, const Value&) {
    const demonstration::TypedField how = demonstration::typed(field.key);
    if (field.positional) {
      std::string name = how.option;
      std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::toupper(c); });
      arguments.bare.emplace_back();
      verb.add_option_function<std::string>(
              name,
              [this_bare = arguments.bare.size() - 1, &list = arguments.bare](const std::string& text) {
                list[this_bare] = text;
              },
              field.help)
          ->required();
      return;
    }
    CLI::Option* option = verb.add_option("--" + how.option, arguments.options[how.option],
                                          how.unit.empty() ? field.help : fmt::format("{}, {}", field.help, how.unit));
    if (whole && (how.option == "from" || how.option == "to")) option->required();
  }
};

struct StackArguments {
  Target target;
  std::string entry;  ///< "12", or "12.3" of a step that made several.
  std::string change;
  std::vector<std::string> words;
};

Result<workbench::Edit> stack_edit(const StackArguments& arguments, demonstration::DemonstrationId id) {
  const std::optional<std::int64_t> named = demonstration::entry_from(arguments.entry);
  if (!named) {
    return fail(ErrorCode::kInvalidArgument, fmt::format("\"{}\" is no id of an edit", arguments.entry));
  }
  const std::int64_t entry = *named;
  const std::size_t words = arguments.words.size();
  if (arguments.change == "enable" && words == 0) return workbench::EnableStackEntry{id, entry, true};
  if (arguments.change == "disable" && words == 0) return workbench::EnableStackEntry{id, entry, false};
  if (arguments.change == "remove" && words == 0) return workbench::RemoveStackEntry{id, entry};
  if (arguments.change == "name" && words == 1) return workbench::NameStackEntry{id, entry, arguments.words.front()};
  if (arguments.change == "move" && words == 1) {
    int place = 0;
    const std::string& text = arguments.words.front();
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), place);
    if (error == std::errc() && end == text.data() + text.size() && place >= 1) {
      return workbench::MoveStackEntry{id, entry, place - 1};
    }
    return fail(ErrorCode::kInvalidArgument, fmt::format("a place is a whole number from 1, not {}", text));
  }
  if (arguments.change == "change") {
    TROCAR_ASSIGN_OR_RETURN(demonstration::Edit edit, demonstration::edit_from_words(arguments.words));
    return workbench::ReplaceStackEntry{id, entry, std::move(edit)};
  }
  return fail(ErrorCode::kInvalidArgument,
              "the change of an edit is enable, disable, remove, name NAME, move PLACE or change -- EDIT PARAMETERS");
}

Json stack_json(const demonstration::Demonstration& document) {
  Json list = Json::array();
  for (const demonstration::StackEntry& entry : *document.stack) {
    list.push_back({{"id", entry.id},
                    {"entry", demonstration::entry_words(entry.id)},
                    {"edit", std::string(demonstration::name_of(*entry.edit))},
                    {"words", demonstration::to_words(*entry.edit)},
                    {"enabled", entry.enabled},
                    {"conflict", entry.conflict.empty() ? Json() : Json(entry.conflict)},
                    {"name", entry.name}});
  }
  return list;
}

std::string stack_text(const demonstration::Demonstration& document) {
  std::string text;
  for (const demonstration::StackEntry& entry : *document.stack) {
    const char* applied = !entry.enabled ? "off" : entry.conflict.empty() ? "on" : "conflict";
    text +=
        fmt::format("{}{:>6}  {:<8} {}{}", text.empty() ? "" : "\n", demonstration::entry_words(entry.id), applied,
                    entry.name.empty() ? "" : entry.name + ": ", fmt::join(demonstration::to_words(*entry.edit), " "));
    if (!entry.conflict.empty()) text += fmt::format("\n{:16}passed over: {}", "", entry.conflict);
  }
  return text.empty() ? "no edits" : text;
}

Result<Answer> run_stack(const StackArguments& arguments, Console& console) {
  const auto open = arguments.change.empty() ? open_to_read : open_to_edit;
  const bool policy = std::find(arguments.words.begin(), arguments.words.end(), "policy") != arguments.words.end();
  TROCAR_ASSIGN_OR_RETURN(workbench::ProjectFile file,
                          open(arguments.target.project, console, policy ? Models::kWhole : Models::kDescribed));
  TROCAR_ASSIGN_OR_RETURN(const auto before, find_demonstration(*file.project(), arguments.target.demonstration));
  Answer answer;
  if (!arguments.change.empty()) {
    TROCAR_ASSIGN_OR_RETURN(const workbench::Edit edit, stack_edit(arguments, before->id));
    answer.summary = workbench::describe(edit, *file.project());
    TROCAR_ASSIGN_OR_RETURN(const std::int64_t id, file.commit(edit));
    answer.json["id"] = id;
  }
  const auto after = file.project()->demonstrations.at(before->id);
  answer.json["demonstration"] = after->id.value;
  answer.json["hash_before"] = hash_text(before->hash());
  answer.json["hash"] = hash_text(after->hash());
  answer.json["stack"] = stack_json(*after);
  answer.text = stack_text(*after);
  if (answer.summary.empty()) answer.summary = fmt::format("{} edits", after->stack->size());
  const auto conflicts = std::count_if(after->stack->begin(), after->stack->end(),
                                       [](const auto& entry) { return !entry.conflict.empty(); });
  answer.json["conflicts"] = conflicts;
  if (conflicts > 0) answer.summary += fmt::format("; {} passed over", counted(conflicts, "conflict"));
  return answer;
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
  answer.summary = fmt::format("removed {}; undo or restore brings it back", demonstration->name);
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

  demonstration::for_each_edit([&]<typename Edited>(const Edited*) {
    add_verb<EditArguments>(
        edit, chosen, std::string(Edited::kName), std::string(Edited::kHelp),
        [target](CLI::App& verb, EditArguments& a) {
          a.target = target;
          a.name = Edited::kName;
          OptionMaker maker{verb, a, std::is_same_v<Edited, demonstration::LabelSegment>};
          const Edited defaults;
          demonstration::visit_fields(maker, defaults);
          if (std::is_same_v<Edited, demonstration::Trim>) {
            verb.add_flag("--idle", a.idle, "Cut both ends where neither tool moves");
          }
        },
        run_edit);
  });
  add_verb<StackArguments>(
      noun, chosen, "stack", "List the edits of a demonstration, or change one of them afterwards",
      [](CLI::App& verb, StackArguments& a) {
        bind_target(verb, a.target);
        verb.add_option("EDIT", a.entry, "The id of an edit, from the list");
        verb.add_option("CHANGE", a.change, "enable, disable, remove, name, move or change");
        verb.add_option("WORDS", a.words, "The name, the place, or behind -- the edit with all its parameters");
        verb.prefix_command();
      },
      run_stack);
  add_verb<RemoveArguments>(
      noun, chosen, "remove", "Put a demonstration into the trash",
      [](CLI::App& verb, RemoveArguments& a) { bind_target(verb, a.target); }, run_remove);
}

}  // namespace trocar::app
