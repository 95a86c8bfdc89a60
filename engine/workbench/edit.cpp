#include "engine/workbench/edit.h"

#include <fmt/format.h>

#include "engine/demonstration/name.h"

namespace trocar::workbench {
namespace {

using demonstration::Demonstration;
using DemonstrationEdit = demonstration::Edit;

tl::unexpected<Error> no_demonstration(DemonstrationId id) {
  return fail(ErrorCode::kNotFound, fmt::format("the project has no demonstration {}", id.value));
}

struct Application {
  const Project& project;
  std::int64_t new_id;
  const BlobSource& blobs;

  Result<Project> operator()(const AddDemonstration& edit) const {
    TROCAR_RETURN_IF_ERROR(demonstration::check_name(edit.name));
    TROCAR_ASSIGN_OR_RETURN(auto recording, blobs.recording(edit.recording));
    const DemonstrationId id{new_id};
    TROCAR_ASSIGN_OR_RETURN(Demonstration made, demonstration::make_demonstration(id, edit.name, std::move(recording)));
    Project edited = project;
    edited.demonstrations[id] = std::make_shared<const Demonstration>(std::move(made));
    return edited;
  }

  Result<Project> operator()(const RemoveDemonstration& edit) const {
    Project edited = project;
    if (edited.demonstrations.erase(edit.demonstration) == 0) return no_demonstration(edit.demonstration);
    return edited;
  }

  Result<Project> operator()(const EditDemonstration& edit) const {
    const auto found = project.demonstrations.find(edit.demonstration);
    if (found == project.demonstrations.end()) return no_demonstration(edit.demonstration);
    TROCAR_ASSIGN_OR_RETURN(Demonstration made, demonstration::apply(*found->second, edit.edit));
    Project edited = project;
    edited.demonstrations[edit.demonstration] = std::make_shared<const Demonstration>(std::move(made));
    return edited;
  }

  Result<Project> operator()(const AddModel& edit) const {
    TROCAR_ASSIGN_OR_RETURN(ModelEntry entry, blobs.model(edit.object));
    entry.id = ModelId{new_id};
    Project edited = project;
    edited.models[entry.id] = std::make_shared<const ModelEntry>(std::move(entry));
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

struct Description {
  const Project& before;

  std::string name(DemonstrationId id) const {
    const auto found = before.demonstrations.find(id);
    return found == before.demonstrations.end() ? fmt::format("demonstration {}", id.value) : found->second->name;
  }
  std::string operator()(const AddDemonstration& edit) const { return fmt::format("Add {}", edit.name); }
  std::string operator()(const RemoveDemonstration& edit) const {
    return fmt::format("Remove {}", name(edit.demonstration));
  }
  std::string operator()(const AddModel& edit) const { return fmt::format("Add model {}", edit.object); }
  std::string operator()(const RemoveModel& edit) const {
    const auto found = before.models.find(edit.model);
    return found == before.models.end() ? fmt::format("Remove model {}", edit.model.value)
                                        : fmt::format("Remove {}", found->second->name);
  }
  std::string operator()(const EditDemonstration& edit) const {
    const std::string subject = name(edit.demonstration);
    if (const auto* trim = std::get_if<demonstration::Trim>(&edit.edit)) {
      return fmt::format("Trim {} to {:.2f}–{:.2f} s", subject, trim->from_s, trim->to_s);
    }
    if (const auto* label = std::get_if<demonstration::LabelSegment>(&edit.edit)) {
      return fmt::format("Label {:.2f}–{:.2f} s of {} as {}", label->from_s, label->to_s, subject,
                         demonstration::letter(label->label));
    }
    return fmt::format("Rename {} to {}", subject, std::get<demonstration::Rename>(edit.edit).name);
  }
};

}  // namespace

Result<std::shared_ptr<const Project>> apply(const Project& project, const Edit& edit, std::int64_t new_id,
                                             const BlobSource& blobs) {
  TROCAR_ASSIGN_OR_RETURN(Project edited, std::visit(Application{project, new_id, blobs}, edit));
  return std::make_shared<const Project>(std::move(edited));
}

std::string_view name_of(const Edit& edit) {
  return std::visit([](const auto& one) { return one.kName; }, edit);
}

std::string describe(const Edit& edit, const Project& before) {
  return std::visit(Description{before}, edit);
}

}  // namespace trocar::workbench
