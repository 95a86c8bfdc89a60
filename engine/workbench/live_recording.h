/// A transfer that runs in the simulation thread while the main thread writes it into the project.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "engine/core/result.h"
#include "engine/workbench/command.h"
#include "engine/workbench/live_runner.h"
#include "engine/workbench/project_file.h"

namespace trocar::workbench {

/// Threads: the main thread. The project file must outlive it and stay where it is.
class LiveRecording {
 public:
  /// Errors: those of `TransferSession::create` and `ProjectFile::begin_recording`.
  static Result<std::unique_ptr<LiveRecording>> start(ProjectFile& file, const RecordScripted& request);

  /// What became of it, once it has ended.
  struct End {
    Result<DemonstrationId> demonstration;  ///< kCancelled if it was discarded.
    std::string message;
  };
  /// Writes what arrived; the end, once.
  std::optional<End> poll();

  /// Ends it early; discarded recordings are not added to the project.
  void stop(bool keep);
  bool stopping() const { return stopping_; }
  const LiveView& view() const { return runner_.view(); }

 private:
  LiveRecording(ProjectFile& file, std::string name, trial::TransferSession session, RecordingWriter writer,
                bool realtime);
  Status write(const LiveBatch& batch);
  End conclude(const LiveBatch& last);

  ProjectFile& file_;
  std::string name_;
  RecordingWriter writer_;
  bool keep_ = true;
  bool stopping_ = false;
  LiveRunner runner_;
};

}  // namespace trocar::workbench
