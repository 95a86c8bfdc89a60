/// Edits as the history tells them.
#pragma once

#include <string>
#include <string_view>

#include "engine/demonstration/edit.h"

namespace trocar::demonstration {

/// "Trim Expert 1 to 0.40–12.30 s"; `name` is the demonstration's. No full stop.
std::string sentence(const Edit& edit, std::string_view name, std::string_view source = {});
/// The same beside its title, without the demonstration: "to 0.40–12.30 s"; "" if there is nothing to say.
std::string particulars(const Edit& edit);

}  // namespace trocar::demonstration
