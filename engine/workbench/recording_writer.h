/// Writes a recording into a project while it is made, so that a crash costs at most a quarter of a second.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "engine/core/result.h"
#include "engine/demonstration/recording.h"
#include "engine/store/project_store.h"

namespace trocar::workbench {

/// A recording in the making: samples go in, and are on disk at most 0.25 s later. Dropped unfinished, what was
/// written stays and is recovered when the project is next opened. What is finished and never added to the project
/// is recovered as well; what nobody wants is to be discarded.
///
/// Precondition: outlived by its project file. Threads: that of the project file.
class RecordingWriter {
 public:
  /// Errors (of all functions): kIo (disk full, project locked).
  static Result<RecordingWriter> begin(store::ProjectStore& store, const demonstration::Provenance& provenance,
                                       const std::string& initial_world);
  ~RecordingWriter();
  RecordingWriter(RecordingWriter&&) noexcept;
  RecordingWriter& operator=(RecordingWriter&&) noexcept;

  /// Commits a chunk each 50 samples (0.25 s). Errors: as `check_samples`, then nothing was added.
  Status add(const demonstration::Sample& sample);
  Status mark(const demonstration::HashMark& mark);
  /// Writes the rest; the recording can now be added to the project. Errors: kInvalidArgument for fewer than 2
  /// samples, or if it was finished or discarded before.
  Result<demonstration::RecordingId> finish(demonstration::Outcome outcome, bool placed);
  /// Takes what was written out of the project.
  Status discard();
  demonstration::RecordingId id() const;

 private:
  struct Impl;
  explicit RecordingWriter(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace trocar::workbench
