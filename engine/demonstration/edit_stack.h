/// The edits that lead from a recording to what is shown of it, and how to change them afterwards.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "engine/core/result.h"
#include "engine/demonstration/edit.h"

namespace trocar::demonstration {

struct Demonstration;

struct StackEntry {
  std::int64_t id = 0;  ///< Of the journal's row that added it; unique within a demonstration.
  std::shared_ptr<const Edit> edit;
  bool enabled = true;
  std::string name;  ///< Given by the user; empty: the edit's own.
};

/// In the order in which they apply.
using EditStack = std::vector<StackEntry>;

/// The demonstration as `stack` makes it from the recording; id, name and all that does not stack are kept.
/// Errors: kInvalidArgument naming the entry that cannot be applied and why.
Result<Demonstration> with_stack(const Demonstration& document, EditStack stack);

// Changes of a stack; each returns the new one. Errors: kNotFound for an unknown entry.

/// `place` counts from 0 and is cut to the length.
Result<EditStack> entry_moved(const EditStack& stack, std::int64_t entry, int place);
Result<EditStack> entry_enabled(const EditStack& stack, std::int64_t entry, bool enabled);
/// The edit anew, with other parameters.
Result<EditStack> entry_replaced(const EditStack& stack, std::int64_t entry, Edit edit);
Result<EditStack> entry_named(const EditStack& stack, std::int64_t entry, std::string name);
Result<EditStack> entry_removed(const EditStack& stack, std::int64_t entry);

}  // namespace trocar::demonstration
