#include "engine/workbench/batch.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <type_traits>

#include "engine/demonstration/edit_words.h"
#include "engine/workbench/policy_bridge.h"

namespace trocar::workbench {
namespace {

using demonstration::Demonstration;

Result<BatchAct> mark_from(const std::string& verb, const std::string& word) {
  MarkChange change;
  if (verb == "flag") {
    TROCAR_ASSIGN_OR_RETURN(change.flag, flag_from(word));
  } else if (verb == "verdict") {
    TROCAR_ASSIGN_OR_RETURN(change.verdict, verdict_from(word));
  } else if (verb == "rate") {
    int rating = -1;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), rating);
    if (error != std::errc() || end != word.data() + word.size()) rating = -1;
    change.rating = rating;
    if (rating < 0 || rating > 5) {
      return fail(ErrorCode::kInvalidArgument, fmt::format("a rating is from 0 (none) to 5, not \"{}\"", word));
    }
  } else if (verb == "note") {
    change.note = word;
  } else {
    TROCAR_RETURN_IF_ERROR(check_tag(word));
    (verb == "tag" ? change.add : change.remove).push_back(word);
  }
  return change;
}

constexpr std::array<std::string_view, 6> kMarkVerbs{"flag", "tag", "untag", "rate", "verdict", "note"};

struct WordsOf {
  std::vector<std::string> operator()(const MarkChange& change) const {
    std::vector<std::string> words;
    if (change.flag) words = {"flag", std::string(to_string(*change.flag))};
    if (change.verdict) words = {"verdict", std::string(to_string(*change.verdict))};
    if (change.rating) words = {"rate", std::to_string(*change.rating)};
    if (change.note) words = {"note", *change.note};
    if (!change.add.empty()) words = {"tag", change.add.front()};
    if (!change.remove.empty()) words = {"untag", change.remove.front()};
    return words;
  }
  std::vector<std::string> operator()(const demonstration::Edit& edit) const { return demonstration::to_words(edit); }
  std::vector<std::string> operator()(const Removal&) const { return {"remove"}; }
};

std::string letters_of(const Demonstration& document) {
  std::string letters;
  for (const auto& span : document.segments) letters += demonstration::letter(span.label);
  return letters.empty() ? "no labels" : letters;
}

/// What an edit changed, in the words that matter most.
std::string change_of(const Demonstration& before, const Demonstration& after) {
  if (before.name != after.name) return fmt::format("→ {}", after.name);
  if (before.duration_s() != after.duration_s()) {
    return fmt::format("{:.2f} s → {:.2f} s", before.duration_s(), after.duration_s());
  }
  if (before.segments != after.segments) {
    const std::string old_letters = letters_of(before);
    const std::string letters = letters_of(after);
    return old_letters == letters ? letters + " moved" : fmt::format("{} → {}", old_letters, letters);
  }
  return "samples changed";
}

/// Of one demonstration: its line, and the edit if it is in the batch.
struct Planned {
  BatchLine line;
  std::optional<Edit> edit;
};

/// A span that is not given is all between the gates, as for `trocar demo edit`; a label has to say what it covers.
demonstration::Edit over_all(demonstration::Edit edit, const Demonstration& document) {
  std::visit(
      [&document]<typename Edited>(Edited& one) {
        if constexpr (!std::is_same_v<Edited, demonstration::LabelSegment> && requires {
                        one.from_s;
                        one.to_s;
                      }) {
          if (one.from_s != 0.0 || one.to_s != 0.0) return;
          one.from_s = document.begin_s;
          one.to_s = document.end_s;
        }
      },
      edit);
  return edit;
}

struct Planner {
  const Demonstration& document;
  const Marks& marks;
  const Project& project;

  Planned operator()(const Removal&) const {
    return {{document.id, document.name, "to the trash", ""}, RemoveDemonstration{document.id}};
  }
  Planned operator()(const MarkChange& change) const {
    Planned planned{{document.id, document.name, to_words(change), ""}, {}};
    const Result<Marks> after = changed(marks, change);
    if (!after) {
      planned.line.problem = after.error().text();
    } else if (*after == marks) {
      planned.line.problem = "it is so already";
    } else {
      planned.edit = MarkDemonstration{document.id, change};
    }
    return planned;
  }
  Planned operator()(const demonstration::Edit& given) const {
    Planned planned{{document.id, document.name, "", ""}, {}};
    // Each has its own way by a policy, which the step of the history then holds.
    const Result<demonstration::Edit> whole = with_ways(over_all(given, document), document.id, 0, project);
    if (!whole) {
      planned.line.problem = whole.error().text();
      return planned;
    }
    const demonstration::Edit& edit = *whole;
    const Result<Demonstration> after = demonstration::apply(document, edit, 0);
    if (!after) {
      planned.line.problem = after.error().text();
    } else if (after->hash() == document.hash() && after->name == document.name &&
               after->notes.size() == document.notes.size()) {
      planned.line.problem = "it changes nothing";
    } else {
      planned.line.change = change_of(document, *after);
      const bool gates_alone = after->samples.hash() == document.samples.hash() &&
                               after->segments == document.segments && after->name == document.name &&
                               after->notes.size() == document.notes.size();
      const demonstration::Trim trim{after->begin_s, after->end_s};
      planned.edit = EditDemonstration{document.id, gates_alone ? demonstration::Edit(trim) : edit};
    }
    return planned;
  }
};

std::string title_of(const std::vector<std::string>& words, std::size_t count) {
  std::string act;
  for (const std::string& word : words) act += act.empty() ? word : " " + word;
  if (!act.empty() && act.front() >= 'a' && act.front() <= 'z')
    act.front() = static_cast<char>(act.front() - 'a' + 'A');
  return fmt::format("{}: {} demonstration{}", act, count, count == 1 ? "" : "s");
}

}  // namespace

Result<BatchAct> act_from_words(const std::vector<std::string>& words) {
  if (words.empty()) return fail(ErrorCode::kInvalidArgument, "say what to do to them");
  if (words.front() == "remove") {
    if (words.size() == 1) return Removal{};
    return fail(ErrorCode::kInvalidArgument, "remove takes no parameter");
  }
  if (std::find(kMarkVerbs.begin(), kMarkVerbs.end(), words.front()) != kMarkVerbs.end()) {
    if (words.size() == 2) return mark_from(words[0], words[1]);
    return fail(ErrorCode::kInvalidArgument, fmt::format("{} takes one word", words.front()));
  }
  TROCAR_ASSIGN_OR_RETURN(demonstration::Edit edit, demonstration::edit_from_words(words));
  if (std::holds_alternative<demonstration::Rename>(edit)) {
    return fail(ErrorCode::kInvalidArgument, "several demonstrations cannot be given one name");
  }
  if (std::holds_alternative<demonstration::Splice>(edit) || std::holds_alternative<demonstration::Overdub>(edit)) {
    return fail(ErrorCode::kInvalidArgument,
                fmt::format("{} is made one demonstration at a time", demonstration::name_of(edit)));
  }
  return edit;
}

std::vector<std::string> to_words(const BatchAct& act) {
  return std::visit(WordsOf{}, act);
}

Batch mending(const Demonstration& shown, const std::vector<demonstration::Edit>& fixes) {
  Batch batch{fmt::format("Fix {} problem{} of {}", fixes.size(), fixes.size() == 1 ? "" : "s", shown.name), {}};
  for (const demonstration::Edit& fix : fixes) batch.edits.emplace_back(EditDemonstration{shown.id, fix});
  return batch;
}

std::shared_ptr<const BatchPlan> plan_batch(const BatchRequest& request, Progress& progress) {
  if (!request.project) return nullptr;
  auto plan = std::make_shared<BatchPlan>();
  plan->of = request;
  const Result<BatchAct> act = act_from_words(request.words);
  if (!act) plan->error = act.error().text();
  if (act && request.demonstrations.empty()) plan->error = "no demonstration is chosen";
  if (!plan->error.empty()) return plan;
  const double count = static_cast<double>(request.demonstrations.size());
  for (const DemonstrationId id : request.demonstrations) {
    if (progress.cancelled()) {
      plan->error = "stopped by the user";
      return plan;
    }
    const auto found = request.project->demonstrations.find(id);
    if (found == request.project->demonstrations.end()) {
      plan->lines.push_back({id, fmt::format("demonstration {}", id.value), "", "it is not in the project"});
      continue;
    }
    Planned planned = std::visit(Planner{*found->second, request.project->marks_of(id), *request.project}, *act);
    if (planned.edit) plan->edit.edits.push_back(std::move(*planned.edit));
    plan->lines.push_back(std::move(planned.line));
    progress.set(static_cast<double>(plan->lines.size()) / count);
  }
  plan->edit.title = title_of(request.words, plan->edit.edits.size());
  return plan;
}

}  // namespace trocar::workbench
