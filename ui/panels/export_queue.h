/// The films that wait, are rendered and have been, with their progress.
#pragma once

#include <string>

#include "ui/panel.h"

namespace trocar::ui {

void draw_film_queue(Ui& ui, const WorkbenchState& state, Requests& requests);

/// "frame 12 of 300, 4 %, 1:05 left": "–" for what is not known.
std::string film_progress_words(const workbench::JobView& job);

}  // namespace trocar::ui
