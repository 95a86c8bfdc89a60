/// What the user just did, as the command line would say it: "Copy as command".
#pragma once

#include <string>

#include "engine/workbench/workbench.h"

namespace trocar::ui {

/// "trocar demo edit P.trocar 3 trim --from 0.4 --to 12.3"; "" for what only changes the view.
std::string command_text(const workbench::Command& command, const workbench::WorkbenchState& state);

/// A word for a shell: quoted if it must be.
std::string shell_word(const std::string& word);

}  // namespace trocar::ui
