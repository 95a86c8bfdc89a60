/// How far the rollouts are from the expert, step by step: the middle one, where half and 90 % lie, and below it how
/// many still go on.
#pragma once

#include "ui/panel.h"

namespace trocar::ui {

void draw_deviation_band(Ui& ui, const workbench::ModelInsight& insight);

}  // namespace trocar::ui
