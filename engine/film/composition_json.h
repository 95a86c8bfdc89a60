/// A film's job in a file: what is left out is as `Composition` has it.
#pragma once

#include <string>
#include <string_view>

#include "engine/core/result.h"
#include "engine/film/composition.h"

namespace trocar::film {

/// An object of JSON, two blanks for each level; reads back as the same composition.
std::string to_json(const Composition& composition);
/// A key that nobody knows is refused, as it may be a slip of the pen.
/// Errors: kCorrupt for what is no such object, naming the key; those of `check`.
Result<Composition> composition_from_json(std::string_view text);

}  // namespace trocar::film
