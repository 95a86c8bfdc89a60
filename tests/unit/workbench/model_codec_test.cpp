#include "engine/workbench/model_codec.h"

#include <doctest/doctest.h>

#include "engine/core/hash.h"

#include "tests/support/project_fixture.h"

using namespace trocar;
using namespace trocar::workbench;
using testing::small_model;

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

TEST_CASE("a model is described without its bytes, with the same hash, and a wrong length is found") {
  const ModelEntry entry = small_model();
  const EncodedModel encoded = encode_model(entry);
  const auto size = static_cast<std::int64_t>(encoded.bytes.size());
  const std::optional<ModelEntry> described = describe_model(encoded.meta, size).value();
  REQUIRE(described);
  CHECK_FALSE(described->model);
  CHECK(described->model_hash == entry.model->hash());
  CHECK(described->name == entry.name);
  CHECK(described->demonstration_hashes == entry.demonstration_hashes);
  CHECK(describe_model(encoded.meta, size - 1).error().code() == ErrorCode::kCorrupt);
  std::string older = encoded.meta;
  older.replace(older.find("\"hash\":\"" + to_hex(entry.model->hash())), 6, "\"hsah\"");
  CHECK_FALSE(describe_model(older, size).value());
}

TEST_CASE("a project whose models are only described has the same hash, and takes the same edits") {
  const trocar::testing::ScratchFolder folder;
  std::uint64_t hash = 0;
  {
    ProjectFile file = trocar::testing::created(folder / "p.trocar");
    trocar::testing::add_demonstration(file, 10, "a");
    REQUIRE(file.add_model(small_model(), Progress()));
    hash = file.project()->hash();
  }
  Diagnostics diagnostics;
  ProjectFile file = ProjectFile::open(folder / "p.trocar", trocar::testing::clock_at_rest(), diagnostics,
                                       ProjectFile::Purpose::kEdit, ProjectFile::Models::kDescribed)
                         .value();
  CHECK(file.project()->hash() == hash);
  REQUIRE(file.project()->models.size() == 1);
  CHECK_FALSE(file.project()->models.begin()->second->model);
  REQUIRE(file.undo());
  REQUIRE(file.redo());
  CHECK(file.project()->hash() == hash);
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
