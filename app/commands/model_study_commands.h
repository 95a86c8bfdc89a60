/// `trocar model seeds`, `explore` and `epoch`: how much of a model is chance, what ε does, and how it was learned.
#pragma once

#include "app/options.h"

namespace trocar::app {

void add_model_study_commands(CLI::App& noun, Action& chosen);
/// `curve`.
void add_model_curve_command(CLI::App& noun, Action& chosen);

}  // namespace trocar::app
