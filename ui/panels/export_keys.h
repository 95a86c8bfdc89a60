/// The camera of a film's source: from where, and the keys that it goes by.
#pragma once

#include "engine/workbench/film_draft.h"
#include "ui/panel.h"

namespace trocar::ui {

/// Precondition: the chosen source is a recording.
void draw_film_camera(Ui& ui, const WorkbenchState& state, workbench::FilmDraft& draft, Requests& requests);

}  // namespace trocar::ui
