/// A project on disk with its whole history: open, edit, undo, redo, record; every change is safe when it returns.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/clock.h"
#include "engine/core/diagnostics.h"
#include "engine/core/progress.h"
#include "engine/core/result.h"
#include "engine/demonstration/recording.h"
#include "engine/workbench/edit.h"
#include "engine/workbench/facts.h"
#include "engine/workbench/history_tree.h"
#include "engine/workbench/project.h"
#include "engine/workbench/recording_writer.h"

namespace trocar::workbench {

/// Several programs may have one project open, and none loses what another does: each change first takes in what has
/// been committed, undone or redone elsewhere, and is then made on the document as it is by now. So after any change
/// `project()` may differ by more than that change; without one, `project()` stays as it is.
/// Errors of every function: kIo (disk full, locked by another program); then nothing has changed.
/// Threads: one at a time (the main thread).
class ProjectFile {
 public:
  enum class Purpose {
    kRead,  ///< Nothing is written, so that it works where nothing can be; every change is an error (kIo).
    kMove,  ///< Undo and redo: as kEdit, but nothing is recovered, which would be an edit and end what can be redone.
    kEdit,
  };

  static Result<ProjectFile> create(const std::filesystem::path& path, std::shared_ptr<const Clock> clock);
  /// What is not needed is not read: models are large, and describing them takes nothing but their names.
  enum class Models {
    kWhole,
    kDescribed,  ///< `ModelEntry::model` may be null.
  };

  /// Rebuilds the document at HEAD. To edit, recordings that were cut off are added as recovered demonstrations
  /// ("Recovered (14.7 s)"), each with a warning; else a warning says that they wait.
  /// Errors: as `store::ProjectStore::open`, kCorrupt for a journal that does not apply.
  static Result<ProjectFile> open(const std::filesystem::path& path, std::shared_ptr<const Clock> clock,
                                  Diagnostics& diagnostics, Purpose purpose = Purpose::kEdit,
                                  Models models = Models::kWhole);
  ~ProjectFile();
  ProjectFile(ProjectFile&&) noexcept;
  ProjectFile& operator=(ProjectFile&&) noexcept;

  std::shared_ptr<const Project> project() const;
  /// The document at a point of the history, on whatever branch. Errors: kNotFound if there is no such point.
  Result<std::shared_ptr<const Project>> project_at(std::int64_t node) const;
  /// Recordings that were recovered on opening.
  std::size_t recovered() const;

  /// Applies and commits; returns the new node's id (also the id of what was added). Errors: those of `apply`, also
  /// when another program has taken away what the edit is about.
  Result<std::int64_t> commit(const Edit& edit);
  /// The edit with what it takes from other demonstrations and from models found, as `commit` would find it now: for
  /// previews. `entry` not 0: it replaces that one of the stack.
  Result<demonstration::Edit> resolved(demonstration::Edit edit, DemonstrationId demonstration,
                                       std::int64_t entry = 0) const;
  /// `after` is what `edit` makes of `before`, worked out in another thread: the next commit, if it is of this, need
  /// not do it again. Precondition: the edit rewrites samples and nothing else.
  void prepare(std::shared_ptr<const demonstration::Demonstration> before, const demonstration::Edit& edit,
               std::shared_ptr<const demonstration::Demonstration> after);
  /// Errors: kInvalidArgument if there is nothing to undo or redo.
  Status undo();
  /// Towards the newest child, or the branch that was last left by undo.
  Status redo();
  bool undoable() const;
  bool redoable() const;
  Status go_to(std::int64_t node);
  std::int64_t head() const;
  const std::vector<HistoryNode>& history() const;
  /// The demonstration that a node's edit is about, as that edit left it: null if it is about none, or took it away.
  /// Quickest for neighbours, one after the other. Errors: kNotFound if there is no such node.
  Result<std::shared_ptr<const demonstration::Demonstration>> subject_at(std::int64_t node) const;

  /// Names a point of the history; an empty name takes the name away. Errors: kNotFound; those of `check_name`.
  Status name_checkpoint(std::int64_t node, const std::string& name);
  const Checkpoints& checkpoints() const;
  /// What a replay of a recording found, in place of what was known.
  Status keep_replay(demonstration::RecordingId recording, const ReplayFound& found);
  const Replays& replays() const;

  /// The writer must not outlive this object, which may be moved.
  Result<RecordingWriter> begin_recording(const demonstration::Provenance& provenance,
                                          const std::string& initial_world);
  /// Stores a whole recording (imports) and returns its id; add it with AddDemonstration. Of a provenance that is not
  /// UTF-8 the odd bytes are replaced. Errors: kInvalidArgument for samples that make no demonstration.
  Result<demonstration::RecordingId> store_recording(const demonstration::Recording& recording);
  /// Likewise of samples that were checked.
  Result<demonstration::RecordingId> store_recording(const demonstration::RecordingInfo& info,
                                                     const demonstration::SampleTrack& samples);
  /// Stores a trained model; add it with AddModel.
  Result<std::int64_t> store_model(const ModelEntry& entry);
  /// The above with its edit, in one transaction: all of it is in the project, or nothing. Returns the new node's id,
  /// which is that of the model. Errors: kCancelled if `progress` was cancelled.
  Result<std::int64_t> add_model(const ModelEntry& entry, const Progress& progress);
  /// Likewise all that an import found, as one step; returns the ids of the demonstrations in their order.
  struct NewRecording {
    std::shared_ptr<const demonstration::RecordingInfo> info;
    demonstration::SampleTrack samples;
    std::string name;
    std::vector<demonstration::Edit> edits;
  };
  Result<std::vector<DemonstrationId>> import_recordings(const std::string& file,
                                                         const std::vector<NewRecording>& recordings);

  /// As of `ProjectStore`: how long a change waits for those of other programs, and whether the last one failed for no
  /// other reason.
  void set_patience_ms(int patience_ms);
  bool held_elsewhere() const;

  Status set_setting(const std::string& key, const std::string& value);
  Result<std::optional<std::string>> setting(const std::string& key) const;
  std::int64_t size_bytes() const;
  const std::filesystem::path& path() const;

 private:
  struct Impl;
  explicit ProjectFile(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace trocar::workbench
