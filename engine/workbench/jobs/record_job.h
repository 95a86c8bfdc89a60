/// Records a transfer by the scripted operators into a project, as fast as the simulator goes.
#pragma once

#include <string>

#include "engine/core/progress.h"
#include "engine/core/result.h"
#include "engine/demonstration/recording.h"
#include "engine/trial/transfer_session.h"
#include "engine/workbench/project_file.h"

namespace trocar::workbench {

struct RecordReport {
  DemonstrationId id;
  demonstration::Outcome outcome = demonstration::Outcome::kUnfinished;
  bool placed = false;
  double duration_s = 0.0;
  std::int64_t samples = 0;
};

/// "Expert 3": the skill and the first number that is free.
std::string demonstration_name(const Project& project, trial::Skill skill);

/// Threads: the project's. Errors: kIo; kCancelled: what was recorded until then is discarded.
Result<RecordReport> record_transfer(ProjectFile& file, const trial::TransferOptions& options, std::string name,
                                     Progress& progress);

}  // namespace trocar::workbench
