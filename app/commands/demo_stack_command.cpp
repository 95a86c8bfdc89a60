#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>

#include "app/commands/demo_commands.h"
#include "engine/demonstration/edit_stack.h"
#include "engine/demonstration/edit_words.h"

namespace trocar::app {
namespace {

/// Whose stack.
struct Stacked {
  std::string project;
  std::string demonstration;
};

struct StackArguments {
  Stacked target;
  std::string entry;  ///< "12", or "12.3" of a step that made several.
  std::string change;
  std::vector<std::string> words;
};

/// The edit as typed; of one of the same kind as the entry, what is not named keeps its present value.
Result<demonstration::Edit> changed_entry(const std::vector<std::string>& words, std::int64_t entry,
                                          const demonstration::Demonstration& document) {
  const auto found = std::find_if(document.stack->begin(), document.stack->end(),
                                  [&](const demonstration::StackEntry& each) { return each.id == entry; });
  if (found == document.stack->end() || words.empty() || words.front() != demonstration::name_of(*found->edit)) {
    return demonstration::edit_from_words(words);
  }
  return demonstration::edit_from_words(words, *found->edit);
}

Result<workbench::Edit> stack_edit(const StackArguments& arguments, const demonstration::Demonstration& document) {
  const demonstration::DemonstrationId id = document.id;
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
    TROCAR_ASSIGN_OR_RETURN(demonstration::Edit edit, changed_entry(arguments.words, entry, document));
    return workbench::ReplaceStackEntry{id, entry, std::move(edit)};
  }
  return fail(ErrorCode::kInvalidArgument,
              "the change of an edit is enable, disable, remove, name NAME, move PLACE or change EDIT PARAMETERS");
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

Result<Answer> run_stack(const StackArguments& typed, Console& console) {
  StackArguments arguments = typed;
  // See `with_edit_words_kept`.
  for (std::string& word : arguments.words) {
    if (word.starts_with(" -")) word.erase(0, 1);
  }
  const auto open = arguments.change.empty() ? open_to_read : open_to_edit;
  const bool policy = std::find(arguments.words.begin(), arguments.words.end(), "policy") != arguments.words.end();
  TROCAR_ASSIGN_OR_RETURN(workbench::ProjectFile file,
                          open(arguments.target.project, console, policy ? Models::kWhole : Models::kDescribed));
  TROCAR_ASSIGN_OR_RETURN(const auto before, find_demonstration(*file.project(), arguments.target.demonstration));
  Answer answer;
  if (!arguments.change.empty()) {
    TROCAR_ASSIGN_OR_RETURN(const workbench::Edit edit, stack_edit(arguments, *before));
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

}  // namespace

void add_demo_stack_command(CLI::App& noun, Action& chosen) {
  add_verb<StackArguments>(
      noun, chosen, "stack", "List the edits of a demonstration, or change one of them afterwards",
      [](CLI::App& verb, StackArguments& a) {
        verb.add_option("PROJECT", a.target.project, "The project file")->required();
        verb.add_option("DEMO", a.target.demonstration, "Its id or name")->required();
        verb.add_option("EDIT", a.entry, "The id of an edit, from the list");
        verb.add_option("CHANGE", a.change, "enable, disable, remove, name, move or change");
        verb.add_option("WORDS", a.words, "The name, the place, or the edit with the parameters that change");
      },
      run_stack);
}

}  // namespace trocar::app
