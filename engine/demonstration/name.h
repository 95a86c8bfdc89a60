/// What a name that a person gives may be.
#pragma once

#include <string_view>

#include "engine/core/result.h"

namespace trocar::demonstration {

/// Errors: kInvalidArgument for a name that is empty or blank, longer than 200 bytes, not UTF-8, or has control
/// characters.
Status check_name(std::string_view name);

}  // namespace trocar::demonstration
