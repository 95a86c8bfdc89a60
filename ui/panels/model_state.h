/// What has to be known of the model that is shown: whether it is of demonstrations as they are, follows an edit, or is
/// shown at an earlier epoch.
#pragma once

#include "ui/panel.h"

namespace trocar::ui {

/// A line or two above what a panel shows of the model; nothing for a model as it was trained.
/// Precondition: `state.insight` has an entry.
void draw_model_state(Ui& ui, const WorkbenchState& state, Requests& requests);

}  // namespace trocar::ui
