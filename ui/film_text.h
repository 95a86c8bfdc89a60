/// The film that is being made in words: its command line, and why it cannot be rendered.
#pragma once

#include <string>

#include "engine/workbench/workbench.h"

namespace trocar::ui {

/// "trocar video render P.trocar 5 6 --out pair.mp4 …"; by the job's file if that is `film` as it is; "" if neither
/// words nor a file say all of it.
std::string film_text(const film::Composition& film, const workbench::WorkbenchState& state);

/// The same of a film of one or two demonstrations.
std::string film_text(const workbench::ExportVideo& video, const std::string& project);

/// Why the film that is being made cannot be rendered, in one sentence; "" if it can.
std::string film_reason(const workbench::WorkbenchState& state);

}  // namespace trocar::ui
