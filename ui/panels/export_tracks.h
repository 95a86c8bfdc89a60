/// What changes in a film as it goes: its numbers by keys, and where it stands still.
#pragma once

#include "engine/workbench/film_draft.h"
#include "ui/panel.h"

namespace trocar::ui {

/// `of`: 0 the film, then its sources; kept within those that there are.
void draw_film_tracks(Ui& ui, const WorkbenchState& state, workbench::FilmDraft& draft, int& of);

}  // namespace trocar::ui
