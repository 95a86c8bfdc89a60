#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>

#include "app/commands/demo_commands.h"
#include "app/commands/edit_effect_answer.h"
#include "engine/demonstration/edit_fields.h"
#include "engine/demonstration/edit_words.h"
#include "engine/demonstration/edits.h"
#include "engine/demonstration/idle_cuts.h"
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

/// What became of the document, or would.
Answer changed(const demonstration::Edit& edit, const demonstration::Demonstration& before,
               const demonstration::Demonstration& after, bool in_detail) {
  Answer answer;
  answer.json = {{"name", demonstration::name_of(edit)},    {"demonstration", after.id.value},
                 {"hash_before", hash_text(before.hash())}, {"hash_after", hash_text(after.hash())},
                 {"hash", hash_text(after.hash())},         {"duration_s", after.duration_s()}};
  const std::vector<demonstration::Join> joins = demonstration::joins_of(edit, before, after);
  for (const demonstration::Join& join : joins) {
    answer.json["joins"].push_back(
        {{"at_s", join.at_s}, {"gap_s", join.gap_s}, {"moved_m", join.moved_m}, {"turned_rad", join.turned_rad}});
  }
  if (!joins.empty()) answer.text = demonstration::sentence_of(joins);
  add_edit_effect(edit, before, after, in_detail, answer);
  return answer;
}

struct Commitment {
  std::shared_ptr<const Target> target;
  Models models = Models::kDescribed;
  bool dry = false;  ///< It is only said what the edit would do.
};

Result<Answer> commit(const Commitment& how, Console& console, const EditMaker& edit_of) {
  const auto open = how.dry ? open_to_read : open_to_edit;
  TROCAR_ASSIGN_OR_RETURN(workbench::ProjectFile file, open(how.target->project, console, how.models));
  TROCAR_ASSIGN_OR_RETURN(const auto before, find_demonstration(*file.project(), how.target->demonstration));
  TROCAR_ASSIGN_OR_RETURN(const std::optional<demonstration::Edit> edit, edit_of(*before, *file.project()));
  if (!edit) return unchanged(*before);
  TROCAR_RETURN_IF_ERROR(check_rename(*file.project(), before->id, *edit));
  const workbench::Edit whole = workbench::EditDemonstration{before->id, *edit};
  const std::string description = workbench::describe(whole, *file.project());
  Answer answer;
  if (how.dry) {
    TROCAR_ASSIGN_OR_RETURN(const demonstration::Edit found, file.resolved(*edit, before->id));
    TROCAR_ASSIGN_OR_RETURN(const demonstration::Demonstration after, demonstration::apply(*before, found));
    answer = changed(found, *before, after, true);
    answer.json["id"] = nullptr;
  } else {
    TROCAR_ASSIGN_OR_RETURN(const std::int64_t id, file.commit(whole));
    answer = changed(*edit, *before, *file.project()->demonstrations.at(before->id), false);
    answer.json["id"] = id;
  }
  answer.json["dry_run"] = how.dry;
  answer.json["description"] = description;
  answer.summary = description;
  const std::string head = how.dry ? fmt::format("Would be: {}", description)
                                   : fmt::format("Edit {}: {}", answer.json["id"].get<std::int64_t>(), description);
  answer.text = answer.text.empty() ? head : fmt::format("{}; {}", head, answer.text);
  TROCAR_RETURN_IF_ERROR(tell_snap(*edit, *before, answer));
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

/// Errors: kInvalidArgument for a span or an instant that lies behind the end, where nothing is.
Result<demonstration::Edit> kept_within(const demonstration::Demonstration& document, demonstration::Edit edit) {
  const double end_s = document.full_duration_s();
  std::optional<double> beyond_s;
  std::visit(
      [&]<typename Edited>(Edited& one) {
        if constexpr (HasSpan<Edited>) {
          // A note, and the span of a label, may stand at the very end.
          if (one.from_s > end_s + demonstration::kTimeTolerance_s) beyond_s = one.from_s;
          one.from_s = within(document, one.from_s);
          one.to_s = within(document, one.to_s);
        } else if constexpr (requires { one.radius_s; }) {
          if (one.at_s > end_s + demonstration::kTimeTolerance_s) beyond_s = one.at_s;
        }
      },
      edit);
  if (!beyond_s) return edit;
  return fail(ErrorCode::kInvalidArgument,
              fmt::format("there is nothing at {:g} s: {} ends at {:.3f} s, give a time before", *beyond_s,
                          document.name, end_s));
}

/// The words of one edit as they were typed.
struct EditArguments {
  std::shared_ptr<const Target> target;
  std::string name;
  std::map<std::string, std::string> options;  ///< By name, without dashes; those not given are empty.
  std::vector<std::string> bare;
  bool idle = false;            ///< Of trim alone.
  bool dry = false;             ///< Nothing is changed.
  std::vector<int> keep_spans;  ///< Of trim-idle alone: the numbers of what stays, from 1.
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

/// What was said to stay by its number is said by its time.
Status keep_spans(EditArguments& arguments, const demonstration::Demonstration& document) {
  if (arguments.keep_spans.empty()) return {};
  TROCAR_ASSIGN_OR_RETURN(const demonstration::Edit edit,
                          demonstration::edit_from_words(words_of(arguments, document)));
  TROCAR_ASSIGN_OR_RETURN(const auto cuts, demonstration::idle_cuts(document, std::get<demonstration::TrimIdle>(edit)));
  std::string& stay = arguments.options["stay"];
  for (const int number : arguments.keep_spans) {
    if (number < 1 || number > std::ssize(cuts)) {
      return fail(ErrorCode::kInvalidArgument,
                  fmt::format("there is no idle span {}, but {}; --dry-run lists them", number, cuts.size()));
    }
    stay += fmt::format("{}{:.3f}", stay.empty() ? "" : ",", cuts[static_cast<std::size_t>(number) - 1].middle_s());
  }
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
  const Commitment how{arguments.target, needs_models(arguments) ? Models::kWhole : Models::kDescribed, arguments.dry};
  return commit(how, console,
                [&](const demonstration::Demonstration& document,
                    const workbench::Project& project) -> Result<std::optional<demonstration::Edit>> {
                  if (arguments.idle) return demonstration::idle_ends(document);
                  EditArguments found = arguments;
                  TROCAR_RETURN_IF_ERROR(find_source(found, document, project));
                  TROCAR_RETURN_IF_ERROR(find_named_model(found, project));
                  TROCAR_RETURN_IF_ERROR(keep_spans(found, document));
                  TROCAR_ASSIGN_OR_RETURN(demonstration::Edit edit,
                                          demonstration::edit_from_words(words_of(found, document)));
                  TROCAR_ASSIGN_OR_RETURN(edit, kept_within(document, std::move(edit)));
                  return edit;
                });
}

/// "NUMBER, mm", "yes|no", "left|right|both".
std::string kind_of(const demonstration::EditOption& row) {
  if (row.flag) return "yes|no";
  if (!row.choices.empty()) return fmt::format("{}", fmt::join(row.choices, "|"));
  const std::string word = row.number ? "NUMBER" : row.unit.empty() ? "TEXT" : "NUMBERS";
  return row.unit.empty() ? word : fmt::format("{}, {}", word, row.unit);
}

/// What it means and what it is if nobody says so. Times that are not given are the gates; a label has no such span.
std::string help_of(const demonstration::EditOption& row, bool whole) {
  const bool source = row.option == "clip-from" || row.option == "clip-to";
  if (!whole && row.option == "from") return row.help + " (else the begin gate)";
  if (!whole && row.option == "to") return row.help + " (else the end gate)";
  if (source) return row.help + " (else the gate there)";
  if (row.option == "source") return row.help + ", id or name (else itself)";
  if (whole && (row.option == "from" || row.option == "to")) return row.help;
  return row.text.empty() ? row.help : fmt::format("{} (else {})", row.help, row.text);
}

/// Makes an option of the command line from each parameter of an edit. `whole`: the span must be given.
void bind_parameters(CLI::App& verb, EditArguments& arguments, const demonstration::Edit& defaults, bool whole) {
  const std::vector<demonstration::EditOption> rows = demonstration::options_of(defaults);
  arguments.bare.resize(static_cast<std::size_t>(
      std::count_if(rows.begin(), rows.end(), [](const demonstration::EditOption& row) { return row.positional; })));
  std::size_t next_bare = 0;
  for (const demonstration::EditOption& row : rows) {
    if (row.positional) {
      std::string name = row.option;
      std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::toupper(c); });
      CLI::Option* bare = verb.add_option(name, arguments.bare[next_bare++], row.help)->required();
      if (!row.choices.empty()) bare->type_name(kind_of(row));
      continue;
    }
    CLI::Option* option = verb.add_option("--" + row.option, arguments.options[row.option], help_of(row, whole));
    option->type_name(kind_of(row));
    if (whole && (row.option == "from" || row.option == "to")) option->required();
  }
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
          bind_parameters(verb, a, Edited{}, std::is_same_v<Edited, demonstration::LabelSegment>);
          if (std::is_same_v<Edited, demonstration::Trim>) {
            verb.add_flag("--idle", a.idle, "Cut both ends where neither tool moves");
          }
          if (std::is_same_v<Edited, demonstration::TrimIdle>) {
            verb.add_option("--keep-span", a.keep_spans, "Leave these as they are, by their numbers in --dry-run")
                ->delimiter(',')
                ->take_all();
          }
          verb.add_flag("--dry-run", a.dry, "Say what it would do, and change nothing");
        },
        run_edit);
  });
  // As the key of the window does: a move by nothing, to be filled in.
  add_verb<EditArguments>(
      edit, chosen, "waypoint", "Keep an instant to displace a tool at: a move, by nothing unless said",
      [target](CLI::App& verb, EditArguments& a) {
        a.target = target;
        a.name = demonstration::MoveTool::kName;
        bind_parameters(verb, a, demonstration::MoveTool{}, false);
        verb.get_option("--at")->required();
        verb.add_flag("--dry-run", a.dry, "Say what it would do, and change nothing");
      },
      run_edit);
  add_verb<RemoveArguments>(
      noun, chosen, "remove", "Put a demonstration into the trash",
      [](CLI::App& verb, RemoveArguments& a) { bind_target(verb, a.target); }, run_remove);
}

}  // namespace trocar::app
