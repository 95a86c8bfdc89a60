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
  std::vector<trial::TrialEvent> events;  ///< Of a trial.
};
/// Threads: the session's.
TakePart take_part(trial::LiveSession& session);

/// A take replaces a span of another demonstration: what the arms that are recorded do there. Nothing moves in time. If
/// the take ends before the span does, what was there goes on from where it ended.
struct TakeTarget {
  DemonstrationId into;
  TimeSpan span;
  demonstration::Arms arms =
      demonstration::Arms::kBoth;  ///< Those that are recorded; a replayed one keeps what it did.
};

/// Threads: the project's. The project file must outlive it and stay where it is.
class TakeWriter {
 public:
  TakeWriter(ProjectFile& file, demonstration::Provenance provenance, std::string name,
             std::optional<TakeTarget> target = std::nullopt);

  /// Errors: those of `ProjectFile::begin_recording` and `RecordingWriter::add`.
  Status write(const TakePart& part);
  bool begun() const { return writer_.has_value(); }
  std::int64_t samples() const { return samples_; }
  double duration_s() const;
  const std::string& name() const { return name_; }

  /// Adds the demonstration with its notes, as one step of the history; a punch-in also replaces the span, in the same
  /// step, and its demonstration is returned.
  /// Errors: kCancelled if nothing was recorded; kIo.
  Result<DemonstrationId> finish(demonstration::Outcome outcome, bool placed);
  /// What was recorded, once it is finished; a punch-in's is another than the demonstration that it went into.
  DemonstrationId take() const { return take_; }
  const std::optional<TakeTarget>& target() const { return target_; }
  /// The recording alone, finished: what becomes of it is the caller's to commit. Errors: as `finish`.
  Result<demonstration::RecordingId> finish_recording(demonstration::Outcome outcome, bool placed);
  /// Nothing of it stays.
  Status discard();

 private:
  std::vector<demonstration::Edit> note_edits() const;
  Edit edit_for(demonstration::RecordingId recording) const;
  /// How long the arms may take from where the take ended to their old motion.
  double ease_s() const;

  ProjectFile& file_;
  demonstration::Provenance provenance_;
  std::string name_;
  std::optional<TakeTarget> target_;
  DemonstrationId take_;
  std::optional<RecordingWriter> writer_;
  std::vector<trial::TakeNote> notes_;
  std::int64_t samples_ = 0;
  std::int64_t first_tick_ = 0;
  std::int64_t last_tick_ = 0;
  demonstration::Sample last_;
};

}  // namespace trocar::workbench
