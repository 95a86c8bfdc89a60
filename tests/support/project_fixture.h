/// Projects for the tests of the document.
#pragma once

#include <doctest/doctest.h>

#include <memory>
#include <string>
#include <utility>

#include "engine/workbench/project_file.h"
#include "tests/support/document_samples.h"
#include "tests/support/scratch_folder.h"

namespace trocar::testing {

inline std::shared_ptr<const Clock> clock_at_rest() {
  return std::make_shared<ManualClock>();
}

inline workbench::ProjectFile created(const std::filesystem::path& path) {
  auto file = workbench::ProjectFile::create(path, clock_at_rest());
  if (!file) FAIL(file.error().text());
  return std::move(*file);
}

inline workbench::ProjectFile opened(const std::filesystem::path& path, Diagnostics& diagnostics) {
  auto file = workbench::ProjectFile::open(path, clock_at_rest(), diagnostics);
  if (!file) FAIL(file.error().text());
  return std::move(*file);
}

/// Without warnings.
inline workbench::ProjectFile opened(const std::filesystem::path& path) {
  Diagnostics diagnostics;
  workbench::ProjectFile file = opened(path, diagnostics);
  CHECK(diagnostics.warnings().empty());
  return file;
}

/// Stores a recording of `count` samples and adds it.
inline workbench::DemonstrationId add_demonstration(workbench::ProjectFile& file, int count, const std::string& name) {
  const auto recording = file.store_recording(moving_recording(count));
  if (!recording) FAIL(recording.error().text());
  const auto node = file.commit(workbench::AddDemonstration{*recording, name});
  if (!node) FAIL(node.error().text());
  return {*node};
}

}  // namespace trocar::testing
