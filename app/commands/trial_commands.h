/// The verbs of `trocar trial`, in groups.
#pragma once

#include "app/options.h"

namespace trocar::app {

void add_trial_commands(CLI::App& root, Action& chosen);
void add_trial_results_command(CLI::App& noun, Action& chosen);

}  // namespace trocar::app
