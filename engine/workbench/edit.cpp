#include "engine/workbench/edit.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/demonstration/clip.h"
#include "engine/demonstration/edit_words.h"
#include "engine/demonstration/name.h"

namespace trocar::workbench {
namespace {

using demonstration::Demonstration;
using demonstration::EditStack;
using demonstration::StackEntry;
using DemonstrationEdit = demonstration::Edit;

tl::unexpected<Error> no_demonstration(DemonstrationId id) {
  return fail(ErrorCode::kNotFound, fmt::format("the project has no demonstration {}", id.value));
}

/// `stem`, or the first of "stem 2", "stem 3" … that no demonstration has.
std::string unused_name(const Project& project, const std::string& stem) {
  const auto taken = [&](const std::string& name) {
    return std::any_of(project.demonstrations.begin(), project.demonstrations.end(),
                       [&](const auto& each) { return each.second->name == name; });
  };
  std::string name = stem;
  for (int number = 2; taken(name); ++number) name = fmt::format("{} {}", stem, number);
  return name;
}

/// What adds takes its id from the journal's row, of which a batch has only one.
bool fits_batch(const Edit& edit) {
  return !std::holds_alternative<AddDemonstration>(edit) && !std::holds_alternative<CopyDemonstration>(edit) &&
         !std::holds_alternative<SplitDemonstration>(edit) && !std::holds_alternative<AddModel>(edit) &&
         !std::holds_alternative<CopyDemonstrations>(edit) && !std::holds_alternative<ImportDemonstrations>(edit) &&
         !std::holds_alternative<PunchIn>(edit) && !std::holds_alternative<AddTrial>(edit) &&
         !std::holds_alternative<Batch>(edit);
}

struct Application {
  const Project& project;
  std::int64_t new_id;
  const BlobSource& blobs;
  std::int64_t first_entry = new_id;  ///< The id of what the edit adds to a stack.

  Result<Project> operator()(const AddDemonstration& edit) const {
    const DemonstrationId id{new_id};
    return with(id, imported({edit.recording, edit.name, edit.edits}, id));
  }

  Result<Project> operator()(const PunchIn& edit) const {
    const auto found = project.demonstrations.find(edit.demonstration);
    if (found == project.demonstrations.end()) return no_demonstration(edit.demonstration);
    TROCAR_ASSIGN_OR_RETURN(Project edited, (*this)(edit.take));
    const Demonstration& take = *edited.demonstrations.at(DemonstrationId{new_id});
    demonstration::Overdub overdub = edit.overdub;
    overdub.source = new_id;
    overdub.as_of = new_id;
    TROCAR_ASSIGN_OR_RETURN(demonstration::Clip clip,
                            demonstration::clip_of(take, overdub.clip_from_s, overdub.clip_to_s));
    overdub.clip = std::make_shared<const demonstration::Clip>(std::move(clip));
    TROCAR_ASSIGN_OR_RETURN(Demonstration made, demonstration::apply(*found->second, overdub, new_id));
    edited.demonstrations[edit.demonstration] = std::make_shared<const Demonstration>(std::move(made));
    if (project.marks_of(edit.demonstration).verdict == Verdict::kNone) return edited;
    MarkChange unsaid;
    unsaid.verdict = Verdict::kNone;
    return Application{edited, new_id, blobs}(MarkDemonstration{edit.demonstration, unsaid});
  }

  Result<Demonstration> imported(const ImportDemonstrations::Part& part, DemonstrationId id) const {
    TROCAR_RETURN_IF_ERROR(demonstration::check_name(part.name));
    TROCAR_ASSIGN_OR_RETURN(auto recording, blobs.recording(part.recording));
    Demonstration made =
        demonstration::make_demonstration(id, part.name, std::move(recording.info), std::move(recording.samples));
    for (std::size_t i = 0; i < part.edits.size(); ++i) {
      TROCAR_ASSIGN_OR_RETURN(const DemonstrationEdit whole, resolved(part.edits[i], project, blobs, new_id));
      TROCAR_ASSIGN_OR_RETURN(made, demonstration::apply(made, whole, demonstration::entry_id(id.value, i)));
    }
    return made;
  }

  Result<Project> operator()(const ImportDemonstrations& edit) const {
    const std::int64_t first = new_id - ids_taken(edit) + 1;
    if (edit.parts.empty() || first < 1) {
      return fail(ErrorCode::kInvalidArgument, "an import must bring demonstrations, with a number for each");
    }
    Project edited = project;
    for (std::size_t i = 0; i < edit.parts.size(); ++i) {
      const DemonstrationId id{first + static_cast<std::int64_t>(i)};
      TROCAR_ASSIGN_OR_RETURN(Demonstration made, imported(edit.parts[i], id));
      const bool added =
          edited.demonstrations.emplace(id, std::make_shared<const Demonstration>(std::move(made))).second;
      if (!added) return fail(ErrorCode::kCorrupt, fmt::format("there is a demonstration {} already", id.value));
    }
    return edited;
  }

  Result<Project> operator()(const RemoveDemonstration& edit) const {
    const auto found = project.demonstrations.find(edit.demonstration);
    if (found == project.demonstrations.end()) return no_demonstration(edit.demonstration);
    Project edited = project;
    edited.trash[edit.demonstration] = found->second;
    edited.demonstrations.erase(edit.demonstration);
    return edited;
  }

  Result<Project> operator()(const RestoreDemonstration& edit) const {
    const auto found = project.trash.find(edit.demonstration);
    if (found == project.trash.end()) {
      return fail(ErrorCode::kNotFound, fmt::format("the trash has no demonstration {}", edit.demonstration.value));
    }
    Project edited = project;
    edited.demonstrations[edit.demonstration] = found->second;
    edited.trash.erase(edit.demonstration);
    return edited;
  }

  Result<Project> operator()(const MarkDemonstration& edit) const {
    if (!project.demonstrations.contains(edit.demonstration)) return no_demonstration(edit.demonstration);
    TROCAR_ASSIGN_OR_RETURN(Marks marks, changed(project.marks_of(edit.demonstration), edit.change));
    Project edited = project;
    if (marks == Marks{}) {
      edited.marks.erase(edit.demonstration);
    } else {
      edited.marks[edit.demonstration] = std::make_shared<const Marks>(std::move(marks));
    }
    return edited;
  }

  Result<Project> operator()(const SaveFilter& edit) const {
    TROCAR_RETURN_IF_ERROR(demonstration::check_name(edit.name));
    Project edited = project;
    edited.filters[edit.name] = edit.query;
    return edited;
  }

  Result<Project> operator()(const RemoveFilter& edit) const {
    Project edited = project;
    if (edited.filters.erase(edit.name) == 0) {
      return fail(ErrorCode::kNotFound, fmt::format("the project has no filter named \"{}\"", edit.name));
    }
    return edited;
  }

  Result<Project> operator()(const Batch& edit) const {
    Project edited = project;
    for (std::size_t i = 0; i < edit.edits.size(); ++i) {
      const Edit& each = edit.edits[i];
      if (!fits_batch(each)) {
        return fail(ErrorCode::kInvalidArgument, fmt::format("a batch cannot hold the edit {}", name_of(each)));
      }
      // An edit of a stack gets an id of its own; what it takes from the past was there before the whole batch.
      const Application next{edited, new_id, blobs, entry_id(i)};
      TROCAR_ASSIGN_OR_RETURN(edited, std::visit(next, each));
    }
    return edited;
  }

  Result<Project> with(DemonstrationId id, Result<Demonstration> made) const {
    if (!made) return tl::unexpected(std::move(made).error());
    Project edited = project;
    edited.demonstrations[id] = std::make_shared<const Demonstration>(std::move(*made));
    return edited;
  }

  Result<Project> operator()(const EditDemonstration& edit) const {
    const auto found = project.demonstrations.find(edit.demonstration);
    if (found == project.demonstrations.end()) return no_demonstration(edit.demonstration);
    TROCAR_ASSIGN_OR_RETURN(const DemonstrationEdit whole, resolved(edit.edit, project, blobs, new_id));
    if (const auto known = blobs.prepared(found->second, whole)) {
      return with(edit.demonstration, demonstration::stacked(*found->second, *known, whole, first_entry));
    }
    return with(edit.demonstration, demonstration::apply(*found->second, whole, first_entry));
  }

  /// Entries of one journal row get ids that no other row's have.
  std::int64_t entry_id(std::size_t nth) const { return demonstration::entry_id(new_id, nth); }

  Result<Project> operator()(const CopyDemonstrations& edit) const {
    const std::int64_t first = new_id - ids_taken(edit) + 1;
    if (edit.copies.empty() || first < 1) {
      return fail(ErrorCode::kInvalidArgument, "there must be copies to make, with a number for each");
    }
    Project edited = project;
    for (std::size_t i = 0; i < edit.copies.size(); ++i) {
      const Application next{edited, first + static_cast<std::int64_t>(i), blobs};
      TROCAR_ASSIGN_OR_RETURN(edited, next(edit.copies[i]));
    }
    return edited;
  }

  Result<Project> operator()(const CopyDemonstration& edit) const {
    if (!edit.name.empty()) TROCAR_RETURN_IF_ERROR(demonstration::check_name(edit.name));
    const auto found = project.demonstrations.find(edit.demonstration);
    if (found == project.demonstrations.end()) return no_demonstration(edit.demonstration);
    Demonstration copy = *found->second;
    copy.id = DemonstrationId{new_id};
    copy.name = edit.name.empty() ? unused_name(project, copy.name + " copy") : edit.name;
    for (std::size_t i = 0; i < edit.edits.size(); ++i) {
      TROCAR_ASSIGN_OR_RETURN(const DemonstrationEdit whole, resolved(edit.edits[i], project, blobs, new_id));
      TROCAR_ASSIGN_OR_RETURN(copy, demonstration::apply(copy, whole, entry_id(i)));
    }
    return with(copy.id, std::move(copy));
  }

  Result<Project> operator()(const SplitDemonstration& edit) const {
    const auto found = project.demonstrations.find(edit.demonstration);
    if (found == project.demonstrations.end()) return no_demonstration(edit.demonstration);
    const Demonstration& whole = *found->second;
    if (!(edit.at_s > whole.begin_s && edit.at_s < whole.end_s)) {
      return fail(ErrorCode::kInvalidArgument, fmt::format("{} can only be split between {:.2f} and {:.2f} s",
                                                           whole.name, whole.begin_s, whole.end_s));
    }
    const std::string rest = edit.name.empty() ? unused_name(project, whole.name + " rest") : edit.name;
    const CopyDemonstration second{edit.demonstration, rest, {demonstration::Trim{edit.at_s, whole.end_s}}};
    TROCAR_ASSIGN_OR_RETURN(Project edited, (*this)(second));
    TROCAR_ASSIGN_OR_RETURN(Demonstration first,
                            demonstration::apply(whole, demonstration::Trim{whole.begin_s, edit.at_s}, entry_id(1)));
    edited.demonstrations[edit.demonstration] = std::make_shared<const Demonstration>(std::move(first));
    return edited;
  }

  /// `change` makes another stack of the demonstration's.
  template <typename Change>
  Result<Project> restacked(DemonstrationId id, Change change) const {
    const auto found = project.demonstrations.find(id);
    if (found == project.demonstrations.end()) return no_demonstration(id);
    TROCAR_ASSIGN_OR_RETURN(EditStack stack, change(*found->second->stack));
    return with(id, demonstration::with_stack(*found->second, std::move(stack)));
  }
  Result<Project> operator()(const MoveStackEntry& edit) const {
    return restacked(edit.demonstration,
                     [&](const EditStack& stack) { return entry_moved(stack, edit.entry, edit.place); });
  }
  Result<Project> operator()(const EnableStackEntry& edit) const {
    return restacked(edit.demonstration,
                     [&](const EditStack& stack) { return entry_enabled(stack, edit.entry, edit.enabled); });
  }
  Result<Project> operator()(const ReplaceStackEntry& edit) const {
    TROCAR_ASSIGN_OR_RETURN(const DemonstrationEdit whole, resolved(edit.edit, project, blobs, new_id));
    TROCAR_ASSIGN_OR_RETURN(Project edited, restacked(edit.demonstration, [&](const EditStack& stack) {
                              return entry_replaced(stack, edit.entry, whole);
                            }));
    // What somebody asks for now and cannot be had is refused; a conflict is what comes of other changes.
    for (const StackEntry& entry : *edited.demonstrations.at(edit.demonstration)->stack) {
      if (entry.id == edit.entry && !entry.conflict.empty()) {
        return fail(ErrorCode::kInvalidArgument, entry.conflict);
      }
    }
    return edited;
  }
  Result<Project> operator()(const NameStackEntry& edit) const {
    if (!edit.name.empty()) TROCAR_RETURN_IF_ERROR(demonstration::check_name(edit.name));
    return restacked(edit.demonstration,
                     [&](const EditStack& stack) { return entry_named(stack, edit.entry, edit.name); });
  }
  Result<Project> operator()(const RemoveStackEntry& edit) const {
    return restacked(edit.demonstration, [&](const EditStack& stack) { return entry_removed(stack, edit.entry); });
  }

  Result<Project> operator()(const AddModel& edit) const {
    TROCAR_ASSIGN_OR_RETURN(ModelEntry entry, blobs.model(edit.object));
    const ModelId id{new_id};
    entry.id = id;
    Project edited = project;
    edited.models[id] = std::make_shared<const ModelEntry>(std::move(entry));
    return edited;
  }

  Result<Project> operator()(const AddTrial& edit) const {
    TROCAR_RETURN_IF_ERROR(demonstration::check_name(edit.name));
    TROCAR_ASSIGN_OR_RETURN(auto recording, blobs.recording(edit.recording));
    TrialEntry entry{TrialId{new_id}, edit.name, nullptr, edit.record, false, ""};
    entry.shown = std::make_shared<const Demonstration>(demonstration::make_demonstration(
        DemonstrationId{new_id}, edit.name, std::move(recording.info), std::move(recording.samples)));
    Project edited = project;
    edited.trials[entry.id] = std::make_shared<const TrialEntry>(std::move(entry));
    return edited;
  }

  Result<Project> operator()(const JudgeTrial& edit) const {
    const auto found = project.trials.find(edit.trial);
    if (found == project.trials.end()) {
      return fail(ErrorCode::kNotFound, fmt::format("the project has no trial {}", edit.trial.value));
    }
    if (edit.excluded) TROCAR_RETURN_IF_ERROR(demonstration::check_name(edit.reason));
    TrialEntry entry = *found->second;
    entry.excluded = edit.excluded;
    entry.reason = edit.excluded ? edit.reason : "";
    Project edited = project;
    edited.trials[edit.trial] = std::make_shared<const TrialEntry>(std::move(entry));
    return edited;
  }

  Result<Project> operator()(const RemoveModel& edit) const {
    Project edited = project;
    if (edited.models.erase(edit.model) == 0) {
      return fail(ErrorCode::kNotFound, fmt::format("the project has no model {}", edit.model.value));
    }
    return edited;
  }
};

}  // namespace

Result<std::shared_ptr<const Project>> apply(const Project& project, const Edit& edit, std::int64_t new_id,
                                             const BlobSource& blobs) {
  TROCAR_ASSIGN_OR_RETURN(Project edited, std::visit(Application{project, new_id, blobs}, edit));
  return std::make_shared<const Project>(std::move(edited));
}

namespace {

/// Finds the clip that `taking`, a splice or an overdub, takes from another demonstration.
template <typename Taking>
Status find_clip(Taking& taking, const Project& before, const BlobSource& blobs, std::int64_t new_id) {
  const DemonstrationId source{taking.source};
  const auto clip_from = [&](const Project& project) -> Status {
    const auto found = project.demonstrations.find(source);
    if (found == project.demonstrations.end()) return no_demonstration(source);
    TROCAR_ASSIGN_OR_RETURN(demonstration::Clip clip,
                            demonstration::clip_of(*found->second, taking.clip_from_s, taking.clip_to_s));
    taking.clip = std::make_shared<const demonstration::Clip>(std::move(clip));
    return {};
  };
  if (taking.as_of == 0) return clip_from(before);
  if (taking.as_of < 0 || taking.as_of >= new_id) {
    return fail(ErrorCode::kNotFound, fmt::format("the history has no point {} before this one", taking.as_of));
  }
  TROCAR_ASSIGN_OR_RETURN(const std::shared_ptr<const Project> then, blobs.project_at(taking.as_of));
  return clip_from(*then);
}

}  // namespace

Result<DemonstrationEdit> resolved(DemonstrationEdit edit, const Project& before, const BlobSource& blobs,
                                   std::int64_t new_id) {
  if (auto* splice = std::get_if<demonstration::Splice>(&edit)) {
    TROCAR_RETURN_IF_ERROR(find_clip(*splice, before, blobs, new_id));
  } else if (auto* overdub = std::get_if<demonstration::Overdub>(&edit)) {
    TROCAR_RETURN_IF_ERROR(find_clip(*overdub, before, blobs, new_id));
  }
  return edit;
}

std::int64_t ids_taken(const Edit& edit) {
  std::size_t count = 1;
  if (const auto* import = std::get_if<ImportDemonstrations>(&edit)) count = import->parts.size();
  if (const auto* copies = std::get_if<CopyDemonstrations>(&edit)) count = copies->copies.size();
  return std::max<std::int64_t>(static_cast<std::int64_t>(count), 1);
}

Edit as_typed(Edit edit) {
  const auto each = [](std::vector<demonstration::Edit>& edits) {
    for (demonstration::Edit& one : edits) one = demonstration::as_typed(one);
  };
  if (auto* change = std::get_if<EditDemonstration>(&edit)) change->edit = demonstration::as_typed(change->edit);
  if (auto* change = std::get_if<ReplaceStackEntry>(&edit)) change->edit = demonstration::as_typed(change->edit);
  if (auto* copy = std::get_if<CopyDemonstration>(&edit)) each(copy->edits);
  if (auto* copies = std::get_if<CopyDemonstrations>(&edit)) {
    for (CopyDemonstration& copy : copies->copies) each(copy.edits);
  }
  if (auto* batch = std::get_if<Batch>(&edit)) {
    for (Edit& one : batch->edits) one = as_typed(std::move(one));
  }
  return edit;
}

}  // namespace trocar::workbench
