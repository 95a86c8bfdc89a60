#include <fmt/format.h>

#include <algorithm>

#include "app/commands/demo_commands.h"
#include "engine/demonstration/diff.h"
#include "engine/demonstration/edit_sentence.h"
#include "engine/review/fixes.h"
#include "engine/review/resimulation.h"
#include "engine/review/review.h"
#include "engine/workbench/batch.h"
#include "engine/workbench/review_goals.h"

namespace trocar::app {
namespace {

using demonstration::Problem;
using demonstration::Severity;

struct CheckArguments {
  std::string project;
  std::string demonstration;
  std::string fix;
  std::string model;
  double clearance_mm = 1e3 * review::ReviewOptions{}.clearance_m;
  bool simulate = false;
};

void bind_check(CLI::App& verb, CheckArguments& arguments) {
  verb.add_option("PROJECT", arguments.project, "The project file")->required();
  verb.add_option("DEMO", arguments.demonstration, "Its id or name")->required();
  verb.add_option("--fix", arguments.fix, "Make the quick fix of a problem, by its id, or `all`; one step to undo");
  verb.add_option("--model", arguments.model, "Hold it to the safe set and the goal of this model too");
  verb.add_option("--clearance-mm", arguments.clearance_mm, "Passing nearer than this is a warning")
      ->check(CLI::Range(0.0, 20.0))
      ->capture_default_str();
  verb.add_flag("--simulate", arguments.simulate, "Drive the simulator with it: is the block still transferred?");
}

Json problem_json(const Problem& problem) {
  return {{"id", problem.id},
          {"kind", demonstration::to_string(problem.kind)},
          {"severity", demonstration::to_string(problem.severity)},
          {"arm", problem.arm == 0   ? Json("left")
                  : problem.arm == 1 ? Json("right")
                                     : Json(nullptr)},
          {"begin_s", problem.begin_s},
          {"end_s", problem.end_s},
          {"message", problem.message},
          {"fix", problem.fix}};
}

void list_problems(const std::vector<Problem>& problems, Answer& answer) {
  answer.json["problems"] = Json::array();
  for (const Problem& problem : problems) {
    answer.json["problems"].push_back(problem_json(problem));
    answer.text += fmt::format("{:<8} {:<14} {:6.2f} … {:6.2f} s  {}\n", demonstration::to_string(problem.severity),
                               problem.id, problem.begin_s, problem.end_s, problem.message);
    if (!problem.fix.empty()) answer.text += fmt::format("{:<24}fix: {}\n", "", problem.fix);
  }
  answer.summary = fmt::format("{}, {}, {}", counted(review::count_of(problems, Severity::kError), "error"),
                               counted(review::count_of(problems, Severity::kWarning), "warning"),
                               counted(review::count_of(problems, Severity::kInfo), "note"));
}

Result<std::vector<demonstration::Edit>> chosen_fixes(const demonstration::Demonstration& document,
                                                      const std::string& fix, const review::ReviewOptions& options) {
  if (fix == "all") return review::fixes_of_all(document, options);
  const std::vector<Problem> problems = review::Reviewer().make(document, options).problems;
  const auto found =
      std::find_if(problems.begin(), problems.end(), [&](const Problem& problem) { return problem.id == fix; });
  if (found == problems.end()) {
    return fail(ErrorCode::kNotFound, fmt::format("there is no problem {}; `demo check` lists their ids", fix));
  }
  TROCAR_ASSIGN_OR_RETURN(demonstration::Edit edit, review::edit_of_fix(*found));
  return std::vector<demonstration::Edit>{std::move(edit)};
}

/// One step of the history, of which each fix is an entry of the stack.
Status make_fixes(workbench::ProjectFile& file, demonstration::DemonstrationId id, const std::string& fix,
                  const review::ReviewOptions& options, Answer& answer) {
  const auto before = file.project()->demonstrations.at(id);
  TROCAR_ASSIGN_OR_RETURN(const auto edits, chosen_fixes(*before, fix, options));
  answer.json["fixed"] = Json::array();
  if (edits.empty()) {
    const std::size_t left = review::Reviewer().make(*before, options).problems.size();
    answer.text += left == 0 ? "There is nothing to fix: no problem was found\n"
                             : fmt::format("No quick fix helps; {} to be mended by hand\n",
                                           left == 1 ? "one problem is" : fmt::format("{} problems are", left));
    return {};
  }
  const workbench::Edit whole =
      fix == "all" ? workbench::Edit(workbench::mending(*before, edits)) : workbench::EditDemonstration{id, edits[0]};
  const std::string step = workbench::describe(whole, *file.project());
  TROCAR_ASSIGN_OR_RETURN(const std::int64_t node, file.commit(whole));
  answer.json["step"] = node;
  for (std::size_t i = 0; i < edits.size(); ++i) {
    const std::int64_t entry = demonstration::entry_id(node, i);
    const std::string description = demonstration::sentence(edits[i], before->name);
    answer.json["fixed"].push_back(
        {{"id", entry}, {"description", description}, {"fix", review::words_of_fix(edits[i])}});
    answer.text += fmt::format("Edit {}: {}\n", demonstration::entry_words(entry), description);
  }
  if (fix == "all") answer.text += fmt::format("Step {} of the history: {}\n", node, step);
  // What mending costs: a fix may reach far to both sides of its problem.
  const demonstration::Difference cost = demonstration::difference(*before, *file.project()->demonstrations.at(id));
  answer.json["cost"] = {{"moved_samples", cost.moved},
                         {"max_deviation_m", cost.max_deviation_m},
                         {"longer_by_s", cost.duration_change_s}};
  answer.text += fmt::format("Moved {} of {} samples, by {:.2f} mm at most; {:+.2f} s\n", cost.moved,
                             before->samples.size(), 1e3 * cost.max_deviation_m, cost.duration_change_s);
  return {};
}

/// A transfer that fails must not be learned from, whatever samples and labels look like.
Problem not_transferred(const demonstration::Demonstration& document, const review::Resimulation& found) {
  const double at_s = found.decided_at_s.value_or(document.end_s);
  Problem problem;
  problem.kind = demonstration::ProblemKind::kEnds;
  problem.severity = Severity::kError;
  problem.begin_s = at_s;
  problem.end_s = at_s;
  problem.message = "simulated, " + found.sentence;
  problem.id = "simulation-1";
  return problem;
}

/// A failure is one more of `problems`.
Status simulate(const demonstration::Demonstration& document, Console& console, std::vector<Problem>& problems,
                Answer& answer) {
  TROCAR_ASSIGN_OR_RETURN(const review::Resimulation found, review::resimulate(document, console.progress()));
  answer.json["simulation"] = {{"outcome", demonstration::to_string(found.outcome)},
                               {"placed", found.placed},
                               {"transferred", found.transferred()},
                               {"decided_at_s", found.decided_at_s ? Json(*found.decided_at_s) : Json(nullptr)},
                               {"last_touch_s", found.last_touch_s},
                               {"last_p_WK_m", {found.last_p_WK.x(), found.last_p_WK.y(), found.last_p_WK.z()}},
                               {"refused", found.refused},
                               {"sentence", found.sentence}};
  if (found.transferred()) {
    answer.text += fmt::format("simulated: {}\n", found.sentence);
    return {};
  }
  problems.push_back(not_transferred(document, found));
  return {};
}

Result<Answer> run_check(const CheckArguments& arguments, Console& console) {
  const auto open = arguments.fix.empty() ? open_to_read : open_to_edit;
  const Models models = arguments.model.empty() ? Models::kDescribed : Models::kWhole;
  TROCAR_ASSIGN_OR_RETURN(workbench::ProjectFile file, open(arguments.project, console, models));
  TROCAR_ASSIGN_OR_RETURN(const auto before, find_demonstration(*file.project(), arguments.demonstration));
  review::ReviewOptions options;
  options.clearance_m = 1e-3 * arguments.clearance_mm;
  if (!arguments.model.empty()) {
    TROCAR_ASSIGN_OR_RETURN(const auto entry, find_model(*file.project(), arguments.model));
    options.goals = workbench::goals_of(entry.get());
  }
  Answer answer;
  answer.json = {{"id", before->id.value}};
  if (!arguments.fix.empty()) TROCAR_RETURN_IF_ERROR(make_fixes(file, before->id, arguments.fix, options, answer));
  const auto document = file.project()->demonstrations.at(before->id);
  std::vector<Problem> problems = review::Reviewer().make(*document, options).problems;
  if (arguments.simulate) TROCAR_RETURN_IF_ERROR(simulate(*document, console, problems, answer));
  list_problems(problems, answer);
  answer.passed = review::count_of(problems, Severity::kError) == 0;
  answer.text += fmt::format("{}: {}", document->name, answer.summary);
  return answer;
}

}  // namespace

void add_demo_review_commands(CLI::App& noun, Action& chosen) {
  add_verb<CheckArguments>(noun, chosen, "check", "List what is wrong or odd, or mend it; exit 1 if an error stays",
                           bind_check, run_check);
}

}  // namespace trocar::app
