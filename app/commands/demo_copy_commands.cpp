#include <fmt/format.h>

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

void bind_target(CLI::App& verb, CopyArguments& arguments) {
  verb.add_option("PROJECT", arguments.project, "The project file")->required();
  verb.add_option("DEMO", arguments.demonstration, "Its id or name")->required();
}

void bind_split(CLI::App& verb, CopyArguments& arguments) {
  bind_target(verb, arguments);
  verb.add_option("--at", arguments.at_s, "Where the first ends and the second begins, s")->required();
  verb.add_option("--name", arguments.name, "Name of the second (else numbered)");
}

void bind_copy(CLI::App& verb, CopyArguments& arguments) {
  bind_target(verb, arguments);
  verb.add_option("--name", arguments.name, "Name (else numbered); several copies are numbered");
  verb.add_option("--copies", arguments.copies, "How many")->check(CLI::Range(1, 1000))->capture_default_str();
  verb.add_option("--perturb-mm", arguments.perturb_mm, "Smooth noise on each copy: standard deviation, mm")
      ->check(CLI::Range(0.0, 100.0));
  verb.add_option("--period", arguments.period_s, "Over which the noise changes, s")->capture_default_str();
  add_seed(verb, arguments.seed, "Of the first copy's noise; each further one has the next");
}

/// `wanted`, or "Expert 1 copy 2": the first that nothing has.
std::string free_name(const workbench::Project& project, const std::string& wanted, const std::string& of, int nth) {
  const auto taken = [&](const std::string& name) {
    for (const auto& [id, each] : project.demonstrations) {
      if (each->name == name) return true;
    }
    return false;
  };
  if (!wanted.empty() && nth == 0 && !taken(wanted)) return wanted;
  const std::string stem = wanted.empty() ? of : wanted;
  for (int number = 2;; ++number) {
    std::string name = fmt::format("{} ({})", stem, number);
    if (!taken(name)) return name;
  }
}

Json one_json(const demonstration::Demonstration& document) {
  return {{"id", document.id.value}, {"name", document.name}, {"hash", hash_text(document.hash())}};
}

Result<Answer> run_split(const CopyArguments& arguments, Console& console) {
  TROCAR_ASSIGN_OR_RETURN(workbench::ProjectFile file, open_to_edit(arguments.project, console, Models::kDescribed));
  TROCAR_ASSIGN_OR_RETURN(const auto before, find_demonstration(*file.project(), arguments.demonstration));
  const std::string name = free_name(*file.project(), arguments.name, before->name, 0);
  TROCAR_ASSIGN_OR_RETURN(const std::int64_t id,
                          file.commit(workbench::SplitDemonstration{before->id, arguments.at_s, name}));
  const auto& demonstrations = file.project()->demonstrations;
  Answer answer;
  answer.json = {{"id", id},
                 {"first", one_json(*demonstrations.at(before->id))},
                 {"second", one_json(*demonstrations.at(workbench::DemonstrationId{id}))}};
  answer.summary = fmt::format("split {} at {:.2f} s, the rest is {} ({})", before->name, arguments.at_s, name, id);
  return answer;
}

Result<Answer> run_copy(const CopyArguments& arguments, Console& console) {
  TROCAR_ASSIGN_OR_RETURN(workbench::ProjectFile file, open_to_edit(arguments.project, console, Models::kDescribed));
  TROCAR_ASSIGN_OR_RETURN(const auto source, find_demonstration(*file.project(), arguments.demonstration));
  Answer answer;
  answer.json["copies"] = Json::array();
  for (int nth = 0; nth < arguments.copies; ++nth) {
    TROCAR_RETURN_IF_ERROR(console.check_not_cancelled());
    workbench::CopyDemonstration copy{source->id, free_name(*file.project(), arguments.name, source->name, nth), {}};
    if (arguments.perturb_mm > 0.0) {
      copy.edits.emplace_back(demonstration::Perturb{1e-3 * arguments.perturb_mm, arguments.period_s,
                                                     arguments.seed + static_cast<std::uint64_t>(nth)});
    }
    TROCAR_ASSIGN_OR_RETURN(const std::int64_t id, file.commit(copy));
    answer.json["copies"].push_back(one_json(*file.project()->demonstrations.at(workbench::DemonstrationId{id})));
    answer.text += fmt::format("{}{:>4}  {}", nth == 0 ? "" : "\n", id, copy.name);
  }
  answer.summary =
      fmt::format("copied {} {}", source->name,
                  arguments.copies == 1 ? "once" : counted(static_cast<std::size_t>(arguments.copies), "time"));
  return answer;
}

}  // namespace

void add_demo_copy_commands(CLI::App& noun, Action& chosen) {
  add_verb<CopyArguments>(noun, chosen, "copy", "Copy a demonstration, with noise on the paths if asked", bind_copy,
                          run_copy);
  add_verb<CopyArguments>(noun, chosen, "split", "Make two demonstrations of one", bind_split, run_split);
}

}  // namespace trocar::app
