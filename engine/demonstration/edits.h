/// The pure function that applies an edit to a demonstration.
#pragma once

#include <cstdint>

#include "engine/demonstration/demonstration.h"
#include "engine/demonstration/edit.h"

namespace trocar::demonstration {

/// What the edit makes of the demonstration, its stack left as it is. `document` is untouched and what did not change
/// is shared. The result is the same on every machine. `entry` is the edit's id, for what it adds. Errors:
/// kInvalidArgument with what is wrong: an empty result, an end before its begin, a number that is not finite.
Result<Demonstration> transformed(const Demonstration& document, const Edit& edit, std::int64_t entry = 0);

/// The same, and the edit is the last of the stack if it stacks.
Result<Demonstration> apply(const Demonstration& document, const Edit& edit, std::int64_t entry = 0);

/// `edited`, which `edit` made of `before`, with the edit as the last of the stack if it stacks.
Demonstration stacked(const Demonstration& before, Demonstration edited, const Edit& edit, std::int64_t entry);

/// A trim as somebody asks for it, kept within the demonstration. Entries of a history are applied without this.
/// Errors: kInvalidArgument if it would change nothing.
Result<Trim> kept_trim(const Demonstration& document, const Trim& asked);

}  // namespace trocar::demonstration
