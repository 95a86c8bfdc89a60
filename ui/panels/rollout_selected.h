/// The rollout that stands out: how it ends and why, and a demonstration that would put it right.
#pragma once

#include "ui/panel.h"

namespace trocar::ui {

/// Nothing if none is selected.
void draw_selected_rollout(Ui& ui, const WorkbenchState& state, Requests& requests);

}  // namespace trocar::ui
