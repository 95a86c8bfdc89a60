#include <doctest/doctest.h>

#include "engine/workbench/history_graph.h"
#include "engine/workbench/path_sketch.h"
#include "tests/support/project_fixture.h"

namespace trocar::workbench {
namespace {

using testing::add_demonstration;
using testing::created;
using testing::opened;
using testing::ScratchFolder;

HistoryNode node(std::int64_t id, std::int64_t parent) {
  return {id, parent, "edit", "", ""};
}

}  // namespace

TEST_CASE("an abandoned branch has a lane of its own that ends where it left the line") {
  // 1 – 2 – 3 (abandoned), 2 – 4 (HEAD).
  const std::vector<HistoryRow> rows = history_graph({node(1, 0), node(2, 1), node(3, 2), node(4, 2)}, 4);
  REQUIRE(rows.size() == 5);
  CHECK(rows[0].node == 4);
  CHECK(rows[0].lane == 0);
  CHECK(rows[0].done);
  CHECK(rows[1].node == 3);
  CHECK(rows[1].lane == 1);
  CHECK_FALSE(rows[1].done);
  CHECK(rows[1].above == 0b01);
  CHECK(rows[1].below == 0b11);
  CHECK(rows[2].node == 2);
  CHECK(rows[2].joins == 0b11);
  CHECK(rows[2].below == 0b01);
  CHECK(rows[4].node == 0);
}

TEST_CASE("what can be redone stays on HEAD's line") {
  const std::vector<HistoryRow> rows = history_graph({node(1, 0), node(2, 1), node(3, 2)}, 1);
  CHECK(rows[0].ahead);
  CHECK(rows[0].lane == 0);
  CHECK(rows[2].done);
}

TEST_CASE("more branches than there is room for share the last lane, and none is lost") {
  std::vector<HistoryNode> nodes;
  for (std::int64_t id = 1; id <= 40; ++id) nodes.push_back(node(id, 0));
  const std::vector<HistoryRow> rows = history_graph(nodes, 40);
  CHECK(rows.size() == 41);
  for (const HistoryRow& row : rows) CHECK(row.lane < kMostLanes);
  CHECK(rows[0].lane == 0);
  CHECK(rows[39].lane == kMostLanes - 1);
}

TEST_CASE("a checkpoint keeps its name across undo and a restart, and can be renamed and taken away") {
  const ScratchFolder folder;
  ProjectFile file = created(folder / "p.trocar");
  const DemonstrationId id = add_demonstration(file, 400, "one");
  REQUIRE(file.name_checkpoint(id.value, "Before smoothing"));
  REQUIRE(file.undo());
  CHECK(file.checkpoints().at(id.value) == "Before smoothing");
  ProjectFile again = opened(folder / "p.trocar");
  CHECK(again.checkpoints().at(id.value) == "Before smoothing");
  CHECK(unused_name(again.checkpoints()) == "Checkpoint 1");
  CHECK(again.name_checkpoint(99, "nowhere").error().code() == ErrorCode::kNotFound);
  CHECK_FALSE(again.name_checkpoint(id.value, "\x01"));
  REQUIRE(again.name_checkpoint(id.value, ""));
  CHECK(opened(folder / "p.trocar").checkpoints().empty());
}

TEST_CASE("what a replay found is kept with the project, and no undo forgets it") {
  const ScratchFolder folder;
  ProjectFile file = created(folder / "p.trocar");
  add_demonstration(file, 400, "one");
  const auto recording = file.project()->demonstrations.begin()->second->recording->id;
  REQUIRE(file.keep_replay(recording, {false, 1.25}));
  REQUIRE(file.undo());
  const ProjectFile again = opened(folder / "p.trocar");
  REQUIRE(again.replays().contains(recording));
  CHECK(again.replays().at(recording) == ReplayFound{false, 1.25});
}

TEST_CASE("each point of the history tells of the demonstration that its edit left, on whatever branch") {
  const ScratchFolder folder;
  ProjectFile file = created(folder / "p.trocar");
  const DemonstrationId id = add_demonstration(file, 400, "one");
  const auto trimmed = file.commit(EditDemonstration{id, demonstration::Trim{0.5, 1.0}});
  REQUIRE(trimmed);
  REQUIRE(file.undo());
  const auto removed = file.commit(RemoveDemonstration{id});
  REQUIRE(removed);
  CHECK(file.subject_at(0).value() == nullptr);
  CHECK(file.subject_at(id.value).value()->end_s == doctest::Approx(1.995));
  CHECK(file.subject_at(*trimmed).value()->end_s == 1.0);
  CHECK(file.subject_at(*removed).value() == nullptr);
  CHECK(file.subject_at(77).error().code() == ErrorCode::kNotFound);
}

TEST_CASE("a sketch has few points, in the picture, with the segments that they are in") {
  const PathSketch sketch = path_sketch(testing::moving_demonstration(4000));
  for (const auto& arm : sketch.arms) {
    CHECK(arm.size() == 48);
    for (const SketchPoint& point : arm) {
      CHECK(point.x >= 0.0F);
      CHECK(point.x <= 1.0F);
    }
    CHECK(arm.front().segment == demonstration::Segment::kA);
  }
  CHECK(sketch.arms[0].front().x < sketch.arms[1].front().x);  // The left arm is on the left.
  CHECK(sketch_pegs().size() == 12);
}

}  // namespace trocar::workbench
