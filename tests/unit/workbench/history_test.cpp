#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <map>

#include "engine/core/random.h"
#include "tests/support/project_fixture.h"

using namespace trocar;
using namespace trocar::workbench;
using demonstration::LabelSegment;
using demonstration::Rename;
using demonstration::Segment;
using demonstration::Trim;
using testing::add_demonstration;
using testing::created;
using testing::opened;
using testing::ScratchFolder;

namespace {

/// Any edit of any demonstration, most of which apply.
Edit random_edit(Random& random, const Project& project) {
  if (project.demonstrations.empty()) return RemoveDemonstration{{1}};
  auto chosen = project.demonstrations.begin();
  std::advance(chosen, random.below(static_cast<std::uint32_t>(project.demonstrations.size())));
  const double from_s = random.uniform(-0.1, 1.0);
  const double to_s = from_s + random.uniform(0.0, 1.0);
  switch (random.below(8)) {
    case 0:
    case 1:
    case 2:
      return EditDemonstration{chosen->first, Trim{from_s, to_s}};
    case 3:
      return RemoveDemonstration{chosen->first};
    case 4:
      return AddDemonstration{chosen->second->recording->id, "copy"};
    case 5:
      return EditDemonstration{chosen->first, Rename{"name " + std::to_string(random.below(1000))}};
    default:
      return EditDemonstration{chosen->first, LabelSegment{static_cast<Segment>(random.below(5)), from_s, to_s}};
  }
}

}  // namespace

TEST_CASE("any edits undone give the original hash, and redone the edited one") {
  CHECK(rc::check([] {
    const ScratchFolder folder;
    ProjectFile file = created(folder / "p.trocar");
    add_demonstration(file, 200, "a");
    add_demonstration(file, 150, "b");
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    std::vector<std::uint64_t> hashes{file.project()->hash()};
    const int count = *rc::gen::inRange(1, 40);
    for (int i = 0; i < count; ++i) {
      if (file.commit(random_edit(random, *file.project()))) hashes.push_back(file.project()->hash());
    }
    for (std::size_t i = hashes.size() - 1; i-- > 0;) {
      RC_ASSERT(file.undo().has_value());
      RC_ASSERT(file.project()->hash() == hashes[i]);
    }
    for (std::size_t i = 1; i < hashes.size(); ++i) {
      RC_ASSERT(file.redo().has_value());
      RC_ASSERT(file.project()->hash() == hashes[i]);
    }
    RC_ASSERT(!file.redoable());
  }));
}

TEST_CASE("a node of the history has one document, however and after however many restarts it is reached") {
  const ScratchFolder folder;
  std::map<std::int64_t, std::uint64_t> hashes;
  Random random(7);
  ProjectFile file = created(folder / "p.trocar");
  hashes[0] = file.project()->hash();
  add_demonstration(file, 200, "a");
  add_demonstration(file, 150, "b");
  hashes[2] = file.project()->hash();
  REQUIRE(file.undo());
  hashes[1] = file.project()->hash();
  REQUIRE(file.redo());
  for (int i = 0; i < 1200; ++i) {
    switch (random.below(6)) {
      case 0:
        (void)file.undo();
        break;
      case 1:
        (void)file.redo();
        break;
      case 2:
        REQUIRE(file.go_to(random.below(static_cast<std::uint32_t>(file.history().size()) + 1)));
        break;
      case 3:
        if (random.below(20) == 0) {
          const std::int64_t head = file.head();
          const bool redoable = file.redoable();
          { ProjectFile closing = std::move(file); }
          file = opened(folder / "p.trocar");
          REQUIRE(file.head() == head);
          REQUIRE(file.redoable() == redoable);
        }
        break;
      default:
        if (const auto id = file.commit(random_edit(random, *file.project()))) hashes[*id] = file.project()->hash();
    }
    REQUIRE(hashes.at(file.head()) == file.project()->hash());
  }
  CHECK(hashes.size() > 200);
}

TEST_CASE("a history much longer than the distance of keyframes is undone and redone exactly") {
  const ScratchFolder folder;
  ProjectFile file = created(folder / "p.trocar");
  const DemonstrationId id = add_demonstration(file, 200, "0");
  for (int i = 1; i <= 300; ++i) REQUIRE(file.commit(EditDemonstration{id, Rename{std::to_string(i)}}));
  { ProjectFile closing = std::move(file); }
  ProjectFile again = opened(folder / "p.trocar");
  for (int i = 299; i >= 0; --i) {
    REQUIRE(again.undo());
    REQUIRE(again.project()->demonstrations.at(id)->name == std::to_string(i));
  }
  for (int i = 1; i <= 300; ++i) {
    REQUIRE(again.redo());
    REQUIRE(again.project()->demonstrations.at(id)->name == std::to_string(i));
  }
}

TEST_CASE("every edit of the project reads back from its JSON as it was") {
  const std::vector<Edit> edits{AddDemonstration{{3}, "Grasp \"über\""},
                                RemoveDemonstration{{4}},
                                EditDemonstration{{5}, Trim{0.1, 1.0 / 3.0}},
                                EditDemonstration{{5}, LabelSegment{Segment::kE, 0.0, 1e-9}},
                                AddModel{6},
                                RemoveModel{{7}}};
  for (const Edit& edit : edits) {
    const Result<Edit> read = edit_from_json(name_of(edit), to_json(edit));
    REQUIRE(read);
    CHECK(name_of(*read) == name_of(edit));
    CHECK(to_json(*read) == to_json(edit));
  }
  CHECK(edit_from_json("melt", "{}").error().code() == ErrorCode::kCorrupt);
  CHECK(edit_from_json("add model", R"({"object":1.5})").error().code() == ErrorCode::kCorrupt);
  CHECK(edit_from_json("edit demonstration", R"({"demonstration":1,"edit":"trim"})").error().code() ==
        ErrorCode::kCorrupt);
}
