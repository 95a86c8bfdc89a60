/// Recordings and models of a project, read from the store once and then shared.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>

#include "engine/store/project_store.h"
#include "engine/workbench/edit.h"

namespace trocar::workbench {

/// Precondition: outlived by the store. Threads: one at a time.
class BlobCache final : public BlobSource {
 public:
  explicit BlobCache(const store::ProjectStore& store) : store_(store) {}

  /// From now on models come without their bytes, as `describe_model` gives them.
  void describe_models_only() { describe_only_ = true; }

  /// Errors: kNotFound; kCorrupt for one that is unfinished or does not match its own hash; kInvalidArgument for
  /// samples that make no demonstration.
  Result<StoredRecording> recording(demonstration::RecordingId id) const override;
  Result<ModelEntry> model(std::int64_t object) const override;
  Result<std::shared_ptr<const Project>> project_at(std::int64_t node) const override { return past_(node); }

  std::shared_ptr<const demonstration::Demonstration> prepared(
      const std::shared_ptr<const demonstration::Demonstration>& before,
      const demonstration::Edit& edit) const override;
  /// See `ProjectFile::prepare`; nulls forget what was.
  void prepare(std::shared_ptr<const demonstration::Demonstration> before, const demonstration::Edit& edit,
               std::shared_ptr<const demonstration::Demonstration> after);

  using Past = std::function<Result<std::shared_ptr<const Project>>(std::int64_t node)>;
  /// Who knows the history; before that, no `project_at`.
  void find_past_with(Past past) { past_ = std::move(past); }
  /// After a transaction was rolled back: its number will be given again, to other content.
  void forget(demonstration::RecordingId id) { recordings_.erase(id); }
  void forget_model(std::int64_t object) { models_.erase(object); }

 private:
  const store::ProjectStore& store_;
  Past past_;
  bool describe_only_ = false;
  struct Prepared {
    std::shared_ptr<const demonstration::Demonstration> before;
    std::string name;
    std::string parameters;
    std::shared_ptr<const demonstration::Demonstration> after;
  };
  Prepared prepared_;
  // Kept as long as the project is open: undo and redo may need any of them again within a frame.
  mutable std::map<demonstration::RecordingId, StoredRecording> recordings_;
  mutable std::map<std::int64_t, ModelEntry> models_;
};

/// Reads a recording's chunks as far as they are whole and in order; `row` need not be finished.
/// Errors: kCorrupt for a damaged header, kUnsupported for another layout of samples.
Result<demonstration::Recording> read_whole_chunks(const store::ProjectStore& store, const store::RecordingRow& row);

}  // namespace trocar::workbench
