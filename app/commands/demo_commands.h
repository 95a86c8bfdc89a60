/// The verbs of `trocar demo`, in groups; and how every one of them shows a demonstration.
#pragma once

#include "app/lookup.h"
#include "app/options.h"

namespace trocar::app {

void add_demo_record_commands(CLI::App& noun, Action& chosen);  ///< record, replay
void add_demo_edit_commands(CLI::App& noun, Action& chosen);    ///< edit, remove
void add_demo_stack_command(CLI::App& noun, Action& chosen);
void add_demo_copy_commands(CLI::App& noun, Action& chosen);     ///< copy, split
void add_demo_library_commands(CLI::App& noun, Action& chosen);  ///< list, tag, trash, restore, filter, batch
void add_demo_review_commands(CLI::App& noun, Action& chosen);   ///< check
void add_demo_diff_command(CLI::App& noun, Action& chosen);
void add_demo_plot_command(CLI::App& noun, Action& chosen);
void add_demo_exchange_commands(CLI::App& noun, Action& chosen);  ///< import, export

/// What `demo list` and `demo show` say of one demonstration.
Json demonstration_json(const demonstration::Demonstration& document);

}  // namespace trocar::app
