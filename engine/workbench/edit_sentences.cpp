// What an edit is called in the history.
#include <fmt/format.h>

#include "engine/demonstration/edit_sentence.h"
#include "engine/demonstration/edit_words.h"
#include "engine/workbench/edit.h"

namespace trocar::workbench {
namespace {

struct Description {
  const Project& before;

  std::string name(DemonstrationId id) const {
    const auto found = before.demonstrations.find(id);
    return found == before.demonstrations.end() ? fmt::format("demonstration {}", id.value) : found->second->name;
  }
  std::string operator()(const AddDemonstration& edit) const { return fmt::format("Add {}", edit.name); }
  std::string operator()(const PunchIn& edit) const {
    const double from_s = edit.overdub.at_s;
    return fmt::format("Replace {:.2f}–{:.2f} s of {} by {}", from_s,
                       from_s + edit.overdub.clip_to_s - edit.overdub.clip_from_s, name(edit.demonstration),
                       edit.take.name);
  }
  std::string operator()(const CopyDemonstrations& edit) const {
    const DemonstrationId source = edit.copies.empty() ? DemonstrationId{} : edit.copies.front().demonstration;
    return fmt::format("Copy {} {} times", name(source), edit.copies.size());
  }
  std::string operator()(const ImportDemonstrations& edit) const {
    if (edit.parts.size() == 1) return fmt::format("Import {}", edit.parts.front().name);
    return fmt::format("Import {} demonstrations from {}", edit.parts.size(), edit.file);
  }
  std::string operator()(const RemoveDemonstration& edit) const {
    return fmt::format("Remove {}", name(edit.demonstration));
  }
  std::string operator()(const RestoreDemonstration& edit) const {
    const auto found = before.trash.find(edit.demonstration);
    return found == before.trash.end() ? fmt::format("Restore demonstration {}", edit.demonstration.value)
                                       : fmt::format("Restore {}", found->second->name);
  }
  std::string operator()(const MarkDemonstration& edit) const {
    return fmt::format("Mark {}: {}", name(edit.demonstration), to_words(edit.change));
  }
  std::string operator()(const SaveFilter& edit) const { return fmt::format("Save filter {}", edit.name); }
  std::string operator()(const RemoveFilter& edit) const { return fmt::format("Remove filter {}", edit.name); }
  std::string operator()(const Batch& edit) const {
    return edit.title.empty() ? fmt::format("{} edits at once", edit.edits.size()) : edit.title;
  }
  std::string operator()(const CopyDemonstration& edit) const {
    return edit.name.empty() ? fmt::format("Copy {}", name(edit.demonstration))
                             : fmt::format("Copy {} as {}", name(edit.demonstration), edit.name);
  }
  std::string operator()(const SplitDemonstration& edit) const {
    return fmt::format("Split {} at {:.2f} s", name(edit.demonstration), edit.at_s);
  }
  std::string operator()(const AddModel& edit) const { return fmt::format("Add model {}", edit.object); }
  std::string operator()(const AddTrial& edit) const { return fmt::format("Add trial {}", edit.name); }
  std::string operator()(const JudgeTrial& edit) const {
    const auto found = before.trials.find(edit.trial);
    const std::string name =
        found == before.trials.end() ? fmt::format("trial {}", edit.trial.value) : found->second->name;
    return edit.excluded ? fmt::format("Exclude {}: {}", name, edit.reason) : fmt::format("Include {}", name);
  }
  std::string operator()(const RemoveModel& edit) const {
    const auto found = before.models.find(edit.model);
    return found == before.models.end() ? fmt::format("Remove model {}", edit.model.value)
                                        : fmt::format("Remove {}", found->second->name);
  }
  /// What the user calls an edit of the stack.
  std::string entry(DemonstrationId id, std::int64_t entry) const {
    const auto found = before.demonstrations.find(id);
    if (found != before.demonstrations.end()) {
      for (const demonstration::StackEntry& each : *found->second->stack) {
        if (each.id == entry) return each.name.empty() ? std::string(name_of(*each.edit)) : each.name;
      }
    }
    return fmt::format("edit {}", entry);
  }
  std::string operator()(const MoveStackEntry& edit) const {
    return fmt::format("Move {} of {} to place {}", entry(edit.demonstration, edit.entry), name(edit.demonstration),
                       edit.place + 1);
  }
  std::string operator()(const EnableStackEntry& edit) const {
    return fmt::format("Switch {} of {} {}", entry(edit.demonstration, edit.entry), name(edit.demonstration),
                       edit.enabled ? "on" : "off");
  }
  std::string operator()(const ReplaceStackEntry& edit) const {
    return fmt::format("Change {} of {}", entry(edit.demonstration, edit.entry), name(edit.demonstration));
  }
  std::string operator()(const NameStackEntry& edit) const {
    return fmt::format("Name {} of {} {}", entry(edit.demonstration, edit.entry), name(edit.demonstration), edit.name);
  }
  std::string operator()(const RemoveStackEntry& edit) const {
    return fmt::format("Remove {} from {}", entry(edit.demonstration, edit.entry), name(edit.demonstration));
  }
  std::string operator()(const EditDemonstration& edit) const {
    const std::string subject = name(edit.demonstration);
    const auto* splice = std::get_if<demonstration::Splice>(&edit.edit);
    const auto* overdub = std::get_if<demonstration::Overdub>(&edit.edit);
    std::string source;
    if (splice != nullptr) source = name(DemonstrationId{splice->source});
    if (overdub != nullptr) source = name(DemonstrationId{overdub->source});
    return demonstration::sentence(edit.edit, subject, source);
  }
};

}  // namespace

std::string_view name_of(const Edit& edit) {
  return std::visit([](const auto& one) { return one.kName; }, edit);
}

std::string describe(const Edit& edit, const Project& before) {
  return std::visit(Description{before}, edit);
}

}  // namespace trocar::workbench
