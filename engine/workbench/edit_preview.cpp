#include "engine/workbench/edit_preview.h"

#include <utility>

namespace trocar::workbench {
namespace {

Result<demonstration::Demonstration> edited(const PreviewRequest& request) {
  if (request.entry == 0) return demonstration::apply(*request.before, request.edit);
  TROCAR_ASSIGN_OR_RETURN(demonstration::EditStack stack,
                          demonstration::entry_replaced(*request.before->stack, request.entry, request.edit));
  return demonstration::with_stack(*request.before, std::move(stack));
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
  Result<demonstration::Demonstration> after = edited(request);
  if (after) {
    preview->difference = demonstration::difference(*request.before, *after);
    preview->after = std::make_shared<const demonstration::Demonstration>(std::move(*after));
  } else {
    preview->error = after.error().text();
  }
  return preview;
}

}  // namespace trocar::workbench
