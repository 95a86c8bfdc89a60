/// What an edit did, or would do, in numbers and words, as `trocar demo edit` says it.
#pragma once

#include "app/console.h"
#include "engine/demonstration/demonstration.h"
#include "engine/demonstration/edit.h"

namespace trocar::app {

/// Adds "effect", "remarks" and, of a trim of what is idle, "spans" to the answer's JSON, and to its text what there is
/// to say; `in_detail`: each of the spans, too. `after` is what `edit` made of `before`.
void add_edit_effect(const demonstration::Edit& edit, const demonstration::Demonstration& before,
                     const demonstration::Demonstration& after, bool in_detail, Answer& answer);

}  // namespace trocar::app
