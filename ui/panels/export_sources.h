/// What a film is of: the list of its sources, another one, and camera, layer or curve of the chosen one.
#pragma once

#include <string>

#include "engine/workbench/film_draft.h"
#include "ui/panel.h"

namespace trocar::ui {

/// What the next source would be.
struct AddedSource {
  int kind = 0;  ///< As `film::SourceKind`.
  int of = 0;    ///< In the list of those that there are.
};

/// The name of what the source is of; what it says itself, if that is no id of the project.
std::string name_of_source(const workbench::Project& project, const film::Source& source);

void draw_film_sources(Ui& ui, const WorkbenchState& state, workbench::FilmDraft& draft, AddedSource& added,
                       Requests& requests);

}  // namespace trocar::ui
