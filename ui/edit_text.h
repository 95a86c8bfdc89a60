/// An edit of the project as the command line would say it.
#pragma once

#include <string>

#include "engine/workbench/edit.h"

namespace trocar::ui {

/// "trocar demo edit P.trocar 3 trim --from 0.4 --to 12.3"; "" for one that no command makes. `project` is a word for a
/// shell.
std::string edit_text(const workbench::Edit& edit, const std::string& project);

}  // namespace trocar::ui
