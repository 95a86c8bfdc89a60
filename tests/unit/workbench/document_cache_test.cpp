#include "engine/workbench/document_cache.h"

#include <doctest/doctest.h>

#include "engine/demonstration/edits.h"
#include "tests/support/document_samples.h"
#include "tests/support/project_fixture.h"

using namespace trocar;
using namespace trocar::workbench;
using testing::add_demonstration;
using testing::created;
using testing::ScratchFolder;

namespace {

std::shared_ptr<const Project> project_of(const demonstration::Demonstration& document) {
  auto project = std::make_shared<Project>();
  project->demonstrations[document.id] = std::make_shared<const demonstration::Demonstration>(document);
  return project;
}

/// Long enough to be worth weighing.
demonstration::Demonstration long_demonstration() {
  static const demonstration::Demonstration kLong = testing::moving_demonstration(60'000);
  return kLong;
}

std::shared_ptr<const Project> offset_by(double metres) {
  return project_of(
      demonstration::apply(long_demonstration(), demonstration::Offset{demonstration::Arms::kBoth, {metres, 0.0, 0.0}})
          .value());
}

}  // namespace

TEST_CASE("documents that are only near are few, those on long ways stay") {
  DocumentCache cache;
  const auto small = project_of(testing::moving_demonstration(10));
  for (int node = 1; node <= 300; ++node) {
    cache.keep(node, small, node % 64 == 0 ? DocumentCache::For::kGood : DocumentCache::For::kAWhile);
    cache.bound(*small);
  }
  CHECK(cache.count() == 4 + kRecentDocuments);
  CHECK(cache.contains(64));
  CHECK(cache.contains(299));
  CHECK_FALSE(cache.contains(200));
  CHECK(cache.find(0)->demonstrations.empty());
  CHECK(cache.find(200) == nullptr);
}

TEST_CASE("what rewrote all of a long demonstration is let go of when there is no room, oldest first") {
  const std::size_t one = [] {
    std::size_t bytes = 0;
    offset_by(0.001)->demonstrations.begin()->second->samples.visit_blocks(
        [&](const demonstration::SampleBlock& block) { bytes += block.bytes(); });
    return bytes;
  }();
  DocumentCache cache(5 * one / 2);
  const auto shown = project_of(long_demonstration());
  for (int node = 1; node <= 5; ++node) {
    cache.keep(node, offset_by(0.001 * node), DocumentCache::For::kGood);
    cache.bound(*shown);
  }
  // Two of the five have room.
  CHECK(cache.count() == 2);
  CHECK(cache.contains(5));
  CHECK(cache.contains(4));
  // What is shown anyway takes no room.
  const auto fifth = cache.find(5);
  cache.keep(6, fifth, DocumentCache::For::kGood);
  cache.bound(*fifth);
  CHECK(cache.count() == 3);
}

TEST_CASE("undo and redo of neighbours hand out the very documents that were there") {
  const ScratchFolder folder;
  ProjectFile file = created(folder / "p.trocar");
  const DemonstrationId id = add_demonstration(file, 200, "a");
  std::vector<std::shared_ptr<const Project>> seen{file.project()};
  for (int i = 1; i <= 5; ++i) {
    REQUIRE(file.commit(EditDemonstration{id, demonstration::Trim{0.0, 0.9 - 0.01 * i}}));
    seen.push_back(file.project());
  }
  for (int i = 4; i >= 0; --i) {
    REQUIRE(file.undo());
    CHECK(file.project() == seen[static_cast<std::size_t>(i)]);
  }
  REQUIRE(file.redo());
  CHECK(file.project() == seen[1]);
}
