#include <fmt/format.h>

#include <set>

#include "app/commands/demo_commands.h"
#include "engine/demonstration/edits.h"

namespace trocar::app {
namespace {

struct CopyArguments {
  std::string project;
  std::string demonstration;
  std::string name;
  double at_s = 0.0;        ///< Of split alone.
  int copies = 1;           ///< Of copy alone, as what follows.
  double perturb_mm = 0.0;  ///< 0: exact copies.
  double period_s = 1.0;
  std::uint64_t seed = 1;
};

void bind_copy_target(CLI::App& verb, CopyArguments& arguments) {
  verb.add_option("PROJECT", arguments.project, "The project file")->required();
  verb.add_option("DEMO", arguments.demonstration, "Its id or name")->required();
}

void bind_split(CLI::App& verb, CopyArguments& arguments) {
  bind_copy_target(verb, arguments);
  verb.add_option("--at", arguments.at_s, "Where the first ends and the second begins, s")->required();
  verb.add_option("--name", arguments.name, "Name of the second (else numbered)");
}

void bind_copy(CLI::App& verb, CopyArguments& arguments) {
  bind_copy_target(verb, arguments);
  verb.add_option("--name", arguments.name, "Name (else numbered); several copies are numbered");
  verb.add_option("--copies", arguments.copies, "How many")->check(CLI::Range(1, 1000))->capture_default_str();
  verb.add_option("--perturb-mm", arguments.perturb_mm, "Smooth noise on each copy: standard deviation, mm")
      ->check(CLI::Range(0.0, 100.0));
  verb.add_option("--period", arguments.period_s, "Over which the noise changes, s")->capture_default_str();
  add_seed(verb, arguments.seed, "Of the first copy's noise; each further one has the next");
}

Json one_json(const demonstration::Demonstration& document) {
  return {{"id", document.id.value}, {"name", document.name}, {"hash", hash_text(document.hash())}};
}

Result<Answer> run_split(const CopyArguments& arguments, Console& console) {
  TROCAR_ASSIGN_OR_RETURN(workbench::ProjectFile file, open_to_edit(arguments.project, console, Models::kDescribed));
  TROCAR_ASSIGN_OR_RETURN(const auto before, find_demonstration(*file.project(), arguments.demonstration));
  const std::string name =
      arguments.name.empty() ? "" : free_demonstration_name(*file.project(), arguments.name, console);
  TROCAR_ASSIGN_OR_RETURN(const std::int64_t id,
                          file.commit(workbench::SplitDemonstration{before->id, arguments.at_s, name}));
  const auto& demonstrations = file.project()->demonstrations;
  Answer answer;
  answer.json = {{"id", id},
                 {"first", one_json(*demonstrations.at(before->id))},
                 {"second", one_json(*demonstrations.at(workbench::DemonstrationId{id}))}};
  answer.summary = fmt::format("split {} at {:.2f} s; from there on it is {} ({})", before->name, arguments.at_s,
                               demonstrations.at(workbench::DemonstrationId{id})->name, id);
  return answer;
}

/// "Careful", "Careful 2" …, or the first like it that neither the project nor another copy has; "" if none was given.
std::string name_of_copy(const workbench::Project& project, const std::string& stem, int nth,
                         std::set<std::string>& taken, Console& console) {
  if (stem.empty()) return "";
  for (int number = nth + 1;; ++number) {
    std::string name =
        free_demonstration_name(project, number == 1 ? stem : fmt::format("{} {}", stem, number), console);
    if (taken.insert(name).second) return name;
  }
}

Result<Answer> run_copy(const CopyArguments& arguments, Console& console) {
  TROCAR_ASSIGN_OR_RETURN(workbench::ProjectFile file, open_to_edit(arguments.project, console, Models::kDescribed));
  TROCAR_ASSIGN_OR_RETURN(const auto source, find_demonstration(*file.project(), arguments.demonstration));
  workbench::CopyDemonstrations several;
  std::set<std::string> names;
  for (int nth = 0; nth < arguments.copies; ++nth) {
    workbench::CopyDemonstration copy{
        source->id, name_of_copy(*file.project(), arguments.name, nth, names, console), {}};
    if (arguments.perturb_mm > 0.0) {
      copy.edits.emplace_back(demonstration::Perturb{1e-3 * arguments.perturb_mm, arguments.period_s,
                                                     arguments.seed + static_cast<std::uint64_t>(nth)});
    }
    several.copies.push_back(std::move(copy));
  }
  TROCAR_RETURN_IF_ERROR(console.check_not_cancelled());
  // One step of the history, however many.
  const workbench::Edit edit =
      arguments.copies == 1 ? workbench::Edit(several.copies.front()) : workbench::Edit(std::move(several));
  TROCAR_ASSIGN_OR_RETURN(const std::int64_t last, file.commit(edit));
  Answer answer;
  answer.json["copies"] = Json::array();
  for (std::int64_t id = last - arguments.copies + 1; id <= last; ++id) {
    const auto made = file.project()->demonstrations.at(workbench::DemonstrationId{id});
    answer.json["copies"].push_back(one_json(*made));
    answer.text += fmt::format("{}{:>4}  {}", answer.text.empty() ? "" : "\n", id, made->name);
  }
  answer.summary = fmt::format(
      "{} of {}", arguments.copies == 1 ? "1 copy" : fmt::format("{} copies", arguments.copies), source->name);
  return answer;
}

}  // namespace

void add_demo_copy_commands(CLI::App& noun, Action& chosen) {
  add_verb<CopyArguments>(noun, chosen, "copy", "Copy a demonstration, with noise on the paths if asked", bind_copy,
                          run_copy);
  add_verb<CopyArguments>(noun, chosen, "split", "Make two demonstrations of one", bind_split, run_split);
}

}  // namespace trocar::app
