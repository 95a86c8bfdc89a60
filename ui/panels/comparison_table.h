/// What two models measure, side by side.
#pragma once

#include "engine/workbench/insight.h"
#include "ui/widgets/widgets.h"

namespace trocar::ui {

/// One row for each measure: A, B and the change. Precondition: `insight.second` is there.
void comparison_table(Ui& ui, const workbench::ModelInsight& insight);

/// "policy changed in 1,204 cells (11.3 %), of 4,100 that both know in 300"
std::string policy_change_words(const learning::ModelComparison& comparison, int cells);

}  // namespace trocar::ui
