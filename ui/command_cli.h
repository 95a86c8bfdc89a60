/// What the command line calls an act of the window.
#pragma once

#include <string_view>

namespace trocar::ui {

/// "trocar demo edit P DEMO trim --from S --to S" for the row "edit.trim_in": P is the project, DEMO and MODEL what is
/// selected. "" for acts that change only what is seen.
std::string_view cli_of(std::string_view id);

}  // namespace trocar::ui
