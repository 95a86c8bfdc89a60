/// How a training went, epoch by epoch: a curve that is dragged along to see what was known at any of them.
#pragma once

#include <optional>

#include "engine/workbench/insight.h"
#include "ui/widgets/widgets.h"

namespace trocar::ui {

/// Of a training that still runs: `curve` so far, over a width for `epochs` (0: as many as there are). Nothing to
/// choose.
void growing_curve(Ui& ui, const std::vector<double>& curve, int epochs, float height);

/// `curve` is the model's: ‖f − D‖₁ / ‖f‖₁ of each epoch. `epoch` is marked, 0 … the number of epochs. Returns the
/// epoch that was clicked or dragged to; the arrow keys step while the keyboard is on it.
std::optional<int> learning_curve(Ui& ui, const std::vector<double>& curve, int epoch, float height);

}  // namespace trocar::ui
