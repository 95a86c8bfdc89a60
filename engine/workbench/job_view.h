/// A job as the user sees it.
#pragma once

#include <string>

#include "engine/core/id.h"

namespace trocar::workbench {

using JobId = Id<struct JobTag>;

enum class JobState { kQueued, kRunning, kDone, kFailed, kCancelled };

struct JobView {
  JobId id;
  std::string title;  ///< "Train exact on segment A"
  JobState state = JobState::kQueued;
  double fraction = 0.0;  ///< 0 … 1.
  std::string message;    ///< What it found, or the error.
  bool hidden = false;
};

}  // namespace trocar::workbench
