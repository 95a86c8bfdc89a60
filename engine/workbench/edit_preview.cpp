#include "engine/workbench/edit_preview.h"

#include <algorithm>
#include <utility>

namespace trocar::workbench {
namespace {

Result<demonstration::Demonstration> edited(const PreviewRequest& request) {
  if (request.entry == 0) {
    if (const auto* trim = std::get_if<demonstration::Trim>(&request.edit)) {
      TROCAR_RETURN_IF_ERROR(demonstration::kept_trim(*request.before, *trim).map([](const auto&) {}));
    }
    return demonstration::apply(*request.before, request.edit);
  }
  TROCAR_ASSIGN_OR_RETURN(demonstration::EditStack stack,
                          demonstration::entry_replaced(*request.before->stack, request.entry, request.edit));
  demonstration::Demonstration made = demonstration::with_stack(*request.before, std::move(stack));
  for (const demonstration::StackEntry& each : *made.stack) {
    if (each.id == request.entry && !each.conflict.empty()) return fail(ErrorCode::kInvalidArgument, each.conflict);
  }
  return made;
}

/// The demonstration as the edit finds it.
demonstration::Demonstration found_by(const PreviewRequest& request) {
  if (request.entry == 0) return *request.before;
  demonstration::EditStack earlier;
  for (const demonstration::StackEntry& each : *request.before->stack) {
    if (each.id == request.entry) break;
    earlier.push_back(each);
  }
  return demonstration::with_stack(*request.before, std::move(earlier));
}

std::vector<demonstration::SnapFigures> snap_of(const PreviewRequest& request) {
  const auto* snap = std::get_if<demonstration::SnapToGrid>(&request.edit);
  if (snap == nullptr) return {};
  return demonstration::snap_figures(found_by(request), *snap).value_or(std::vector<demonstration::SnapFigures>{});
}

std::vector<demonstration::IdleCut> idle_in(const PreviewRequest& request) {
  const auto* trim = std::get_if<demonstration::TrimIdle>(&request.edit);
  if (trim == nullptr) return {};
  return demonstration::idle_cuts(found_by(request), *trim).value_or(std::vector<demonstration::IdleCut>());
}

}  // namespace

std::shared_ptr<const EditPreview> preview_of(const PreviewRequest& request) {
  if (!request.before) return nullptr;
  auto preview = std::make_shared<EditPreview>();
  preview->edit = request.edit;
  preview->entry = request.entry;
  preview->before = request.before;
  if (!request.problem.empty()) {
    preview->error = request.problem;
    return preview;
  }
  preview->idle = idle_in(request);
  Result<demonstration::Demonstration> after = edited(request);
  if (after) {
    preview->difference = demonstration::difference(*request.before, *after);
    preview->effect = demonstration::effect_of(request.edit, *request.before, *after);
    preview->snap = snap_of(request);
    preview->after = std::make_shared<const demonstration::Demonstration>(std::move(*after));
  } else {
    preview->error = after.error().text();
  }
  return preview;
}

}  // namespace trocar::workbench
