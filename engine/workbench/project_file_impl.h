/// The inside of `ProjectFile`. Private to the module.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "engine/store/project_store.h"
#include "engine/workbench/blob_cache.h"
#include "engine/workbench/document_cache.h"
#include "engine/workbench/project_file.h"

namespace trocar::workbench {

using ProjectPointer = std::shared_ptr<const Project>;

struct JournalEntry {
  std::string name;
  std::string parameters;
};

struct ProjectFile::Impl {
  Impl(store::ProjectStore opened, std::shared_ptr<const Clock> wall)
      : store(std::move(opened)), clock(std::move(wall)) {
    blobs.find_past_with([this](std::int64_t node) { return past(node); });
  }

  store::ProjectStore store;
  std::shared_ptr<const Clock> clock;
  BlobCache blobs{store};
  HistoryTree tree;
  std::unordered_map<std::int64_t, JournalEntry> entries;
  DocumentCache documents;
  std::int64_t head = 0;
  ProjectPointer project = documents.find(0);
  std::size_t recovered = 0;
  Checkpoints checkpoints;
  Replays replays;
  std::pair<std::int64_t, ProjectPointer> last_past{0, documents.find(0)};  ///< Where `subject_at` was asked last.
  bool behind = false;  ///< Another program has changed the store, and it has not been taken in yet.

  Status take_rows(std::vector<store::JournalRow> rows);
  Status take_redo();
  Status take_facts();
  Status follow_head();
  Status catch_up();
  Result<ProjectPointer> step(const ProjectPointer& before, std::int64_t node) const;
  Result<ProjectPointer> document_at(std::int64_t node);
  Result<ProjectPointer> past(std::int64_t node);
  void keep(std::int64_t node, const ProjectPointer& document);
  void stand_at(std::int64_t node, const ProjectPointer& document);
  Status load();
  std::vector<store::RedoRow> redo_back_from(std::int64_t node) const;
  Status move(const std::function<Result<std::int64_t>()>& where);
  Result<std::int64_t> commit(const std::function<Result<Edit>()>& prepare);
  Result<std::vector<store::RecordingRow>> cut_off() const;
  void recover(const store::RecordingRow& row, Diagnostics& diagnostics);
};

}  // namespace trocar::workbench
