/// Makes whole what is left of a recording that a crash cut off, so that it can be put into the project.
#pragma once

#include "engine/core/result.h"
#include "engine/demonstration/recording.h"
#include "engine/store/project_store.h"

namespace trocar::workbench {

struct Recovered {
  demonstration::RecordingId recording;
  bool kept = false;  ///< False: it had fewer than 2 samples and was discarded.
  double duration_s = 0.0;
};

/// Finishes a recording whose writer is gone, as recovered, with what is whole of it.
/// Errors: those of reading and writing; what cannot be read is left as it is.
Result<Recovered> recover_recording(store::ProjectStore& store, const store::RecordingRow& row);

}  // namespace trocar::workbench
