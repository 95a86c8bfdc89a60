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

/// A model whose every array holds something else.
inline workbench::ModelEntry small_model() {
  learning::Model model;
  model.grid = spatial::Grid::with_cells(3);
  const auto cells = static_cast<std::size_t>(model.grid.cell_count());
  model.options.method = learning::Method::kExact;
  model.options.seed = 0xFFFFFFFFFFFFFFFFULL;
  model.experts = {{{0}, {1}, {2}}, {{3}, {4}}};
  model.start = {0};
  model.goal = {2};
  model.safe = spatial::CellSet(model.grid);
  model.safe.insert({5});
  for (std::size_t i = 0; i < cells; ++i) {
    model.theta.push_back(0.1 * static_cast<double>(i));
    model.value.push_back(-0.1 * static_cast<double>(i));
    model.visits.push_back(static_cast<std::uint32_t>(i));
    model.tried.push_back(static_cast<std::uint8_t>(i % 64));
  }
  for (std::size_t i = 0; i < 6 * cells; ++i) model.q.push_back(1.0 / static_cast<double>(i + 1));
  model.curve = {0.5, 0.25};
  model.seconds = 1.5;
  workbench::ModelEntry entry;
  entry.name = "exact A";
  entry.segment = demonstration::Segment::kC;
  entry.demonstrations = {{1}, {4}};
  entry.demonstration_hashes = {1, 0xFFFFFFFFFFFFFFFFULL};
  entry.created = "2026-01-01T00:00:00Z";
  entry.model = std::make_shared<const learning::Model>(std::move(model));
  return entry;
}

}  // namespace trocar::testing
