/// What a film is of: the list of its sources, another one, and camera, layer or curve of the chosen one.
#pragma once

#include "engine/workbench/film_draft.h"
#include "ui/panel.h"

namespace trocar::ui {

/// What the next source would be.
struct AddedSource {
  int kind = 0;  ///< As `film::SourceKind`.
  int of = 0;    ///< In the list of those that there are.
};

void draw_film_sources(Ui& ui, const WorkbenchState& state, workbench::FilmDraft& draft, AddedSource& added,
                       Requests& requests);

}  // namespace trocar::ui
