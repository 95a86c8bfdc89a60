#include "engine/demonstration/edits.h"

#include <utility>

#include "engine/demonstration/edits/edit_functions.h"

namespace trocar::demonstration {

Result<Demonstration> transformed(const Demonstration& document, const Edit& edit, std::int64_t entry) {
  return std::visit(
      [&](const auto& one) {
        if constexpr (requires { made_by(document, one, entry); }) {
          return made_by(document, one, entry);
        } else {
          return made_by(document, one);
        }
      },
      edit);
}

Result<Demonstration> apply(const Demonstration& document, const Edit& edit, std::int64_t entry) {
  TROCAR_ASSIGN_OR_RETURN(Demonstration edited, transformed(document, edit, entry));
  return stacked(document, std::move(edited), edit, entry);
}

Demonstration stacked(const Demonstration& before, Demonstration edited, const Edit& edit, std::int64_t entry) {
  edited.stack = before.stack;
  if (!stacks(edit)) return edited;
  auto stack = std::make_shared<EditStack>(*before.stack);
  stack->push_back({entry, std::make_shared<const Edit>(edit), true, {}});
  edited.stack = std::move(stack);
  return edited;
}

}  // namespace trocar::demonstration
