/// Two models over the same starts: who arrives where the other does not, and how sure that is.
#pragma once

#include "ui/panel.h"

namespace trocar::ui {

void draw_second_model(Ui& ui, const WorkbenchState& state, Requests& requests);

}  // namespace trocar::ui
