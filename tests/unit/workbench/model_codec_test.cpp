#include "engine/workbench/model_codec.h"

#include <doctest/doctest.h>

#include "tests/support/project_fixture.h"

using namespace trocar;
using namespace trocar::workbench;

namespace {

/// A model whose every array holds something else.
ModelEntry small_model() {
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
  ModelEntry entry;
  entry.name = "exact A";
  entry.segment = demonstration::Segment::kC;
  entry.demonstrations = {{1}, {4}};
  entry.demonstration_hashes = {1, 0xFFFFFFFFFFFFFFFFULL};
  entry.created = "2026-01-01T00:00:00Z";
  entry.model = std::make_shared<const learning::Model>(std::move(model));
  return entry;
}

}  // namespace

TEST_CASE("a stored model reads back to the same hash with all that it came from") {
  const ModelEntry entry = small_model();
  const EncodedModel encoded = encode_model(entry);
  const ModelEntry read = decode_model(encoded.meta, encoded.bytes).value();
  CHECK(read.model->hash() == entry.model->hash());
  CHECK(read.model->seconds == 1.5);
  CHECK(read.model->safe == entry.model->safe);
  CHECK(read.model->experts == entry.model->experts);
  CHECK(read.name == entry.name);
  CHECK(read.segment == entry.segment);
  CHECK(read.demonstrations == entry.demonstrations);
  CHECK(read.demonstration_hashes == entry.demonstration_hashes);
  CHECK(read.created == entry.created);
}

TEST_CASE("a model cut off at any byte is refused") {
  const EncodedModel encoded = encode_model(small_model());
  for (std::size_t size = 0; size < encoded.bytes.size(); ++size) {
    const auto read = decode_model(encoded.meta, std::string_view(encoded.bytes).substr(0, size));
    REQUIRE_FALSE(read);
    CHECK(read.error().code() == ErrorCode::kCorrupt);
  }
  CHECK_FALSE(decode_model(encoded.meta, encoded.bytes + '\0'));
  CHECK_FALSE(decode_model("{}", encoded.bytes));
}

TEST_CASE("a model is stale when a demonstration it came from is edited, and fresh again after undo") {
  const testing::ScratchFolder folder;
  ProjectFile file = testing::created(folder / "p.trocar");
  const DemonstrationId id = testing::add_demonstration(file, 100, "a");
  ModelEntry entry = small_model();
  entry.demonstrations = {id};
  entry.demonstration_hashes = {file.project()->demonstrations.at(id)->hash()};
  const std::int64_t object = file.store_model(entry).value();
  const ModelId model{file.commit(AddModel{object}).value()};
  const auto stale = [&] { return file.project()->stale(*file.project()->models.at(model)); };
  CHECK_FALSE(stale());
  REQUIRE(file.commit(EditDemonstration{id, demonstration::Rename{"b"}}));
  CHECK_FALSE(stale());
  REQUIRE(file.commit(EditDemonstration{id, demonstration::Trim{0.1, 0.3}}));
  CHECK(stale());
  REQUIRE(file.undo());
  CHECK_FALSE(stale());
  REQUIRE(file.commit(RemoveDemonstration{id}));
  CHECK(stale());
}
