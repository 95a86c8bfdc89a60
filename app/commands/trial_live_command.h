/// `trocar trial run --operator tcp`: one transfer in real time, by whoever sits at a console somewhere else.
#pragma once

#include <string>

#include "app/options.h"
#include "engine/workbench/jobs/trial_job.h"
#include "engine/workbench/project_file.h"

namespace trocar::app {

struct LiveTrialArguments {
  std::string listen;      ///< "5005" or "0.0.0.0:5005".
  double wait_s = -1.0;    ///< For the console; negative: as long as usual.
  bool real_time = false;  ///< A real-time scheduler is asked for.
  bool assists = false;    ///< The console's right hand has the right arm.
  bool given() const { return !listen.empty() || wait_s >= 0.0 || real_time || assists; }
};

void bind_live(CLI::App& verb, LiveTrialArguments& arguments);

/// Waits for a console, runs the plan's one transfer at 1 kHz and puts it into the project, however it ended.
Result<Answer> run_live_command(workbench::ProjectFile& file, const workbench::TrialPlan& plan,
                                const LiveTrialArguments& arguments, Console& console);

/// Of a trial, as every command shows it.
Json json_of(const workbench::TrialEntry& trial);
std::string row_of(const workbench::TrialEntry& trial);

}  // namespace trocar::app
