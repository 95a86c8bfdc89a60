/// Finds recordings that a crash cut off, so that they can be put into the project.
#pragma once

#include <string>
#include <vector>

#include "engine/core/diagnostics.h"
#include "engine/core/result.h"
#include "engine/demonstration/recording.h"
#include "engine/store/project_store.h"

namespace trocar::workbench {

struct Recovered {
  demonstration::RecordingId recording;
  std::string name;  ///< "Recovered (14.7 s)"
};

/// Finishes each recording whose writer is gone, as recovered, with what is whole of it, and returns those that no
/// journal row names; ones with fewer than 2 samples are discarded. Each gets a warning. What cannot be read is left
/// as it is, with a warning.
std::vector<Recovered> recover_recordings(store::ProjectStore& store, const std::vector<store::JournalRow>& journal,
                                          Diagnostics& diagnostics);

}  // namespace trocar::workbench
