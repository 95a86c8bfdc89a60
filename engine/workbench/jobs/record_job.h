/// Records a transfer by the scripted operators into a project, as fast as the simulator goes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/core/progress.h"
#include "engine/core/result.h"
#include "engine/demonstration/recording.h"
#include "engine/trial/key_script.h"
#include "engine/trial/transfer_session.h"
#include "engine/workbench/command.h"
#include "engine/workbench/project_file.h"
#include "engine/workbench/take_writer.h"

namespace trocar::workbench {

/// Of the take, but for `id`.
struct RecordReport {
  DemonstrationId id;  ///< To be looked at now: the take, or the demonstration of which it replaced a part.
  demonstration::Outcome outcome = demonstration::Outcome::kUnfinished;
  bool placed = false;
  double duration_s = 0.0;
  std::int64_t samples = 0;
  std::string name;
  std::int64_t limited = 0;  ///< Samples at which an arm was at a limit; of takes by keys.
  std::int64_t refused = 0;  ///< Samples at which an arm could not reach what was wished; likewise.
  DemonstrationId take{};
  std::optional<TakeTarget> replaced{};  ///< Where a punch-in went.
};

/// "Expert 3": the skill and the first number that is free.
std::string demonstration_name(const Project& project, trial::Skill skill);

/// Threads: the project's. Errors: kIo; kCancelled: what was recorded until then is discarded.
Result<RecordReport> record_transfer(ProjectFile& file, const trial::TransferOptions& options, std::string name,
                                     Progress& progress);

/// Plays key presses through the session that a person drives in the window, as fast as the simulator goes; recorded as
/// scripted, since no person was there.
/// Errors: those of `plan_take` and `HandSession::create`; as above.
Result<RecordReport> record_keys(ProjectFile& file, const RecordByHand& request,
                                 const std::vector<trial::KeyStroke>& strokes, Progress& progress);

}  // namespace trocar::workbench
