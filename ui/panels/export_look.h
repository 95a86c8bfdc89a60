/// How a film looks, apart from its sources: preset, layout, pace and what is written over it.
#pragma once

#include "engine/workbench/film_draft.h"
#include "ui/widgets/widgets.h"

namespace trocar::ui {

void draw_film_look(Ui& ui, film::Composition& film);

}  // namespace trocar::ui
