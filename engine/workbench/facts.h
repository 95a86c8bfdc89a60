/// What a project remembers beside its history, so that no undo forgets it: names of points, and what replays found.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

#include "engine/core/result.h"
#include "engine/demonstration/recording.h"
#include "engine/trial/transfer_session.h"

namespace trocar::workbench {

/// Names that points of the history were given, by node.
using Checkpoints = std::map<std::int64_t, std::string>;
/// "Checkpoint 3": the first such name that no point has.
std::string unused_name(const Checkpoints& taken);

/// What the last replay of a recording found. It is a fact about the recording, which never changes.
struct ReplayFound {
  bool verified = false;
  double diverged_at_s = 0.0;  ///< Where it was not.
  bool operator==(const ReplayFound&) const = default;
};
using Replays = std::map<demonstration::RecordingId, ReplayFound>;

ReplayFound found_of(const trial::ReplayResult& result);

// As text, for the project file. Errors: kCorrupt.
std::string to_text(const ReplayFound& found);
Result<ReplayFound> replay_found_from(std::string_view text);

}  // namespace trocar::workbench
