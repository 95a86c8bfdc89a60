/// A job as the user sees it.
#pragma once

#include <filesystem>
#include <optional>
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
  bool paused = false;           ///< A running one that stands still, or will at its next frame.
  int done = 0;                  ///< So many frames of …
  int of = 0;                    ///< … so many; 0: nothing is counted.
  std::optional<double> left_s;  ///< Until it is done, at its pace so far; none: not known.
  std::filesystem::path film;    ///< Where the film goes; empty: it makes none.
};

}  // namespace trocar::workbench
