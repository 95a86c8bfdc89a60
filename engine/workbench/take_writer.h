/// Puts what a live session records into the project as it comes, and at the end the demonstration that it makes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/trial/live_session.h"
#include "engine/workbench/clipboard.h"
#include "engine/workbench/project_file.h"

namespace trocar::workbench {

/// What a session recorded since it was last asked.
struct TakePart {
  std::optional<std::string> initial_world;  ///< The recording begins with this part.
  std::vector<demonstration::Sample> samples;
  std::vector<demonstration::HashMark> marks;
  std::vector<trial::TakeNote> notes;
};
/// Threads: the session's.
TakePart take_part(trial::LiveSession& session);

/// A take that replaces a span of another demonstration.
struct PunchIn {
  DemonstrationId into;
  TimeSpan span;
};

/// Threads: the project's. The project file must outlive it and stay where it is.
class TakeWriter {
 public:
  TakeWriter(ProjectFile& file, demonstration::Provenance provenance, std::string name,
             std::optional<PunchIn> punch = std::nullopt);

  /// Errors: those of `ProjectFile::begin_recording` and `RecordingWriter::add`.
  Status write(const TakePart& part);
  bool begun() const { return writer_.has_value(); }
  std::int64_t samples() const { return samples_; }
  double duration_s() const;
  const std::string& name() const { return name_; }

  /// Adds the demonstration with its notes; a punch-in also replaces the span, and its demonstration is returned.
  /// Errors: kCancelled if nothing was recorded; kIo.
  Result<DemonstrationId> finish(demonstration::Outcome outcome, bool placed);
  /// Nothing of it stays.
  Status discard();

 private:
  Status add_notes(DemonstrationId id);
  /// From where the take ended to the old motion, by an edit of its own.
  Status ease_out();

  ProjectFile& file_;
  demonstration::Provenance provenance_;
  std::string name_;
  std::optional<PunchIn> punch_;
  std::optional<RecordingWriter> writer_;
  std::vector<trial::TakeNote> notes_;
  std::int64_t samples_ = 0;
  std::int64_t first_tick_ = 0;
  std::int64_t last_tick_ = 0;
  demonstration::Sample last_;
};

}  // namespace trocar::workbench
