/// The edits that lead from a recording to what is shown of it, and how to change them afterwards.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/result.h"
#include "engine/demonstration/edit.h"

namespace trocar::demonstration {

struct Demonstration;

struct StackEntry {
  std::int64_t id = 0;  ///< Made of the journal's row that added it, see `entry_id`; unique within a demonstration.
  std::shared_ptr<const Edit> edit;
  bool enabled = true;
  std::string name;  ///< Given by the user; empty: the edit's own.
  /// Why it cannot be applied to what the edits before it leave, as when its span is gone; then it is passed over until
  /// it can be again. Empty: it is applied, or switched off.
  std::string conflict{};
};

/// In the order in which they apply.
using EditStack = std::vector<StackEntry>;

/// The demonstration as `stack` makes it from the recording; id, name and all that does not stack are kept. An entry
/// that cannot be applied is passed over and says why; nothing else is lost by it.
Demonstration with_stack(const Demonstration& document, EditStack stack);

/// Of a stack entry, as people read and type it: "12", or "12.3" for the fourth edit of one step of the history.
std::string entry_words(std::int64_t entry);
/// Also the bare number. Nothing for what is no entry's id.
std::optional<std::int64_t> entry_from(std::string_view words);
/// The id of the `nth` (from 0) edit of the journal's row `row`.
constexpr std::int64_t entry_id(std::int64_t row, std::size_t nth) {
  return row + (static_cast<std::int64_t>(nth) << 32);
}

// Changes of a stack; each returns the new one. Errors: kNotFound for an unknown entry.

/// `place` counts from 0 and is cut to the length.
Result<EditStack> entry_moved(const EditStack& stack, std::int64_t entry, int place);
Result<EditStack> entry_enabled(const EditStack& stack, std::int64_t entry, bool enabled);
/// The edit anew, with other parameters.
Result<EditStack> entry_replaced(const EditStack& stack, std::int64_t entry, Edit edit);
Result<EditStack> entry_named(const EditStack& stack, std::int64_t entry, std::string name);
Result<EditStack> entry_removed(const EditStack& stack, std::int64_t entry);

}  // namespace trocar::demonstration
