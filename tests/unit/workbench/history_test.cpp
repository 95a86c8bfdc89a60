#include <doctest/doctest.h>
#include <fmt/format.h>
#include <rapidcheck.h>

#include <map>

#include "engine/core/random.h"
#include "engine/demonstration/edit_fields.h"
#include "tests/support/project_fixture.h"
#include "tests/support/random_project_edits.h"

using namespace trocar;
using namespace trocar::workbench;
using demonstration::LabelSegment;
using demonstration::Rename;
using demonstration::Segment;
using demonstration::Trim;
using testing::add_demonstration;
using testing::created;
using testing::moving_recording;
using testing::opened;
using testing::ScratchFolder;

namespace {

/// A quarter of a second of `source` as it was at `as_of`, put in at its begin.
demonstration::Splice splice(DemonstrationId source, std::int64_t as_of, double from_s) {
  return {source.value, from_s, from_s + 0.25, 0.1, 0.0, demonstration::Align::kMeet, as_of, nullptr};
}

/// The tools rest for 0.5 s at first; then the left one closes and holds the block, both do, and the right one.
demonstration::Recording resting_and_grasping(int count) {
  demonstration::Recording recording = moving_recording(count);
  for (int i = 0; i < count; ++i) {
    demonstration::Sample& sample = recording.samples[static_cast<std::size_t>(i)];
    if (i < 100) sample.arms = recording.samples[100].arms;
    demonstration::ArmSample& left = sample.arms[0];
    left.setpoint_jaw_rad = i < 110 || i >= 175 ? 0.6 : 0.02;
    left.jaw_rad = static_cast<float>(left.setpoint_jaw_rad);
    sample.blocks[0].p = {0.0F, 0.0F, i < 130 ? 0.0F : 0.01F};
    if (i >= 120 && i < 170) sample.flags |= demonstration::kLeftHolds;
    if (i >= 160) sample.flags |= demonstration::kRightHolds;
  }
  return recording;
}

/// A project with two demonstrations, and recordings and a model that random edits may add.
struct Walked {
  ScratchFolder folder;
  ProjectFile file = created(folder / "p.trocar");
  testing::StoredThings stored;

  Walked() {
    add_demonstration(file, 200, "a");
    add_demonstration(file, 150, "b");
    stored.recordings.push_back(file.store_recording(moving_recording(120)).value());
    stored.recordings.push_back(file.store_recording(resting_and_grasping(200)).value());
    stored.model = file.store_model(testing::small_model()).value();
  }

  void reopen() {
    { ProjectFile closing = std::move(file); }
    file = opened(folder / "p.trocar");
  }

  /// Any point of the history, the empty project among them.
  std::int64_t any_node(Random& random) const {
    const auto& nodes = file.history();
    const std::uint32_t place = random.below(static_cast<std::uint32_t>(nodes.size()) + 1);
    return place == nodes.size() ? 0 : nodes[place].id;
  }

  Edit any_edit(Random& random) const {
    return testing::random_project_edit(random, *file.project(), stored, any_node(random));
  }
};

/// Every sample, bit for bit; what undo must bring back.
std::string bytes_of(const Project& project) {
  std::string bytes;
  for (const auto& [id, document] : project.demonstrations) {
    bytes += std::to_string(id.value) + document->name;
    for (const demonstration::Sample& sample : document->samples) {
      bytes.append(reinterpret_cast<const char*>(&sample), sizeof sample);
    }
  }
  return bytes;
}

/// The document's hash, and what it leaves out: notes, and the stack with what is on in it.
std::string whole_state(const Project& project) {
  std::string state = std::to_string(project.hash());
  for (const auto& [id, document] : project.demonstrations) {
    state += fmt::format("|{}", id.value);
    for (const demonstration::Note& note : document->notes) {
      state += fmt::format(";{} {} {} {}", note.text, note.begin_s, note.end_s, note.tag);
    }
    for (const demonstration::StackEntry& entry : *document->stack) {
      state += fmt::format(";{} {} {}", entry.name, entry.enabled, demonstration::to_json(*entry.edit));
    }
  }
  return state;
}

/// The name of an edit, and of what it does to a demonstration.
std::string kind_of(const Edit& edit) {
  const auto* of_one = std::get_if<EditDemonstration>(&edit);
  return std::string(of_one != nullptr ? demonstration::name_of(of_one->edit) : name_of(edit));
}

}  // namespace

TEST_CASE("any edits undone give the original hash, and redone the edited one") {
  CHECK(rc::check([] {
    Walked walked;
    ProjectFile& file = walked.file;
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    std::vector<std::string> states{whole_state(*file.project())};
    const int count = *rc::gen::inRange(1, 40);
    for (int i = 0; i < count; ++i) {
      if (file.commit(walked.any_edit(random))) states.push_back(whole_state(*file.project()));
    }
    for (std::size_t i = states.size() - 1; i-- > 0;) {
      RC_ASSERT(file.undo().has_value());
      RC_ASSERT(whole_state(*file.project()) == states[i]);
    }
    for (std::size_t i = 1; i < states.size(); ++i) {
      RC_ASSERT(file.redo().has_value());
      RC_ASSERT(whole_state(*file.project()) == states[i]);
    }
    RC_ASSERT(!file.redoable());
  }));
}

TEST_CASE(
    "10,000 steps over every kind of edit: a node has one document however it is reached, and undo ends at the "
    "original") {
  constexpr int kSteps = 10'000;
  Walked walked;
  ProjectFile& file = walked.file;
  Random random(7);
  std::map<std::int64_t, std::uint64_t> hashes;
  std::map<std::string, int> kinds;
  const std::string original = bytes_of(*file.project());
  const std::int64_t begin = file.head();
  hashes[begin] = file.project()->hash();
  REQUIRE(file.undo());
  hashes[file.head()] = file.project()->hash();
  REQUIRE(file.undo());
  hashes[0] = file.project()->hash();
  REQUIRE(file.go_to(begin));
  for (int i = 0; i < kSteps; ++i) {
    switch (random.below(8)) {
      case 0:
        (void)file.undo();
        break;
      case 1:
        (void)file.redo();
        break;
      case 2:
        REQUIRE(file.go_to(walked.any_node(random)));
        break;
      case 3:
        if (random.below(40) == 0) {
          const std::int64_t head = file.head();
          const bool redoable = file.redoable();
          walked.reopen();
          REQUIRE(file.head() == head);
          REQUIRE(file.redoable() == redoable);
        }
        break;
      default: {
        const Edit edit = walked.any_edit(random);
        if (const auto id = file.commit(edit)) {
          hashes[*id] = file.project()->hash();
          ++kinds[kind_of(edit)];
        }
      }
    }
    REQUIRE(hashes.at(file.head()) == file.project()->hash());
  }
  CHECK(hashes.size() > kSteps / 3);
  demonstration::for_each_edit([&](const auto* edit) {
    const std::string kind(std::remove_pointer_t<decltype(edit)>::kName);
    CAPTURE(kind);
    CHECK(kinds[kind] > 0);
  });
  for (const char* kind :
       {"add demonstration", "import demonstrations", "remove demonstration", "restore demonstration",
        "mark demonstration", "copy demonstration", "split demonstration", "move edit", "enable edit", "change edit",
        "name edit", "remove edit", "add model", "remove model", "save filter", "remove filter", "batch"}) {
    CAPTURE(kind);
    CHECK(kinds[kind] > 0);
  }
  // All of it undone, from the deepest node: every document on the way again, and at its end what was there first.
  REQUIRE(file.go_to(file.history().back().id));
  while (file.undoable()) {
    if (file.head() == begin) {
      REQUIRE(bytes_of(*file.project()) == original);
    }
    REQUIRE(file.undo());
    REQUIRE(hashes.at(file.head()) == file.project()->hash());
  }
  REQUIRE(file.head() == 0);
  REQUIRE(file.go_to(begin));
  CHECK(bytes_of(*file.project()) == original);
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

TEST_CASE("what was cut is pasted as it was before the cut, also after the project is opened again") {
  const ScratchFolder folder;
  ProjectFile file = created(folder / "p.trocar");
  const DemonstrationId id = add_demonstration(file, 400, "a");
  const std::int64_t before_cut = file.head();
  const auto original = file.project()->demonstrations.at(id);
  REQUIRE(file.commit(EditDemonstration{id, demonstration::DeleteSpan{0.5, 1.0, true}}));
  REQUIRE(file.commit(EditDemonstration{id, splice(id, before_cut, 0.5)}));
  const auto pasted = file.project()->demonstrations.at(id);
  CHECK(pasted->samples.size() == 400 - 100 + 51);
  // At 0.1 s stands what was at 0.5 s, moved to where the tool was.
  const auto way = [](const auto& of, std::size_t from, std::size_t to) {
    return Eigen::Vector3d(of->samples[to].arms[0].measured.pose().p - of->samples[from].arms[0].measured.pose().p);
  };
  CHECK((way(pasted, 20, 60) - way(original, 100, 140)).norm() < 1e-6);
  const std::uint64_t hash = file.project()->hash();
  { ProjectFile closing = std::move(file); }
  ProjectFile again = opened(folder / "p.trocar");
  CHECK(again.project()->hash() == hash);
  REQUIRE(again.undo());
  REQUIRE(again.redo());
  CHECK(again.project()->hash() == hash);
}

TEST_CASE("a pasted clip stays as it was when its source is edited or removed") {
  const ScratchFolder folder;
  ProjectFile file = created(folder / "p.trocar");
  const DemonstrationId source = add_demonstration(file, 400, "source");
  const DemonstrationId id = add_demonstration(file, 400, "a");
  const auto node = file.commit(EditDemonstration{id, splice(source, 0, 0.5)});
  REQUIRE(node);
  const std::uint64_t hash = file.project()->demonstrations.at(id)->hash();
  REQUIRE(file.commit(EditDemonstration{source, demonstration::Offset{demonstration::Arms::kBoth, {0.0, 0.0, 0.01}}}));
  REQUIRE(file.commit(RemoveDemonstration{source}));
  REQUIRE(file.commit(EnableStackEntry{id, *node, false}));
  REQUIRE(file.commit(EnableStackEntry{id, *node, true}));
  CHECK(file.project()->demonstrations.at(id)->hash() == hash);
}

TEST_CASE("a long chain of pastes, each from the point before it, is opened at once") {
  const ScratchFolder folder;
  ProjectFile file = created(folder / "p.trocar");
  const DemonstrationId id = add_demonstration(file, 200, "a");
  for (int i = 0; i < 60; ++i) REQUIRE(file.commit(EditDemonstration{id, splice(id, file.head(), 0.3)}));
  const std::uint64_t hash = file.project()->hash();
  { ProjectFile closing = std::move(file); }
  // Without memory of the points in between this would take 2⁶⁰ steps.
  CHECK(opened(folder / "p.trocar").project()->hash() == hash);
}

TEST_CASE("a paste from the future or from nowhere is refused") {
  const ScratchFolder folder;
  ProjectFile file = created(folder / "p.trocar");
  const DemonstrationId id = add_demonstration(file, 200, "a");
  CHECK_FALSE(file.commit(EditDemonstration{id, splice(id, file.head() + 1, 0.3)}));
  CHECK_FALSE(file.commit(EditDemonstration{id, splice(id, -1, 0.3)}));
  CHECK_FALSE(file.commit(EditDemonstration{id, splice({99}, 0, 0.3)}));
  CHECK(file.project()->demonstrations.at(id)->stack->empty());
}

TEST_CASE("a split makes two that together are the whole, in one step of the history") {
  const ScratchFolder folder;
  ProjectFile file = created(folder / "p.trocar");
  const DemonstrationId id = add_demonstration(file, 400, "whole");
  const std::uint64_t hash = file.project()->hash();
  const auto node = file.commit(SplitDemonstration{id, 1.0, "rest"});
  REQUIRE(node);
  const auto first = file.project()->demonstrations.at(id);
  const auto second = file.project()->demonstrations.at(DemonstrationId{*node});
  CHECK(first->end_s == 1.0);
  CHECK(second->begin_s == 1.0);
  CHECK(second->end_s == doctest::Approx(1.995));
  CHECK(first->stack->back().id != second->stack->back().id);
  CHECK_FALSE(file.commit(SplitDemonstration{id, 5.0, "beyond"}));
  const auto copy = file.commit(CopyDemonstration{id, "", {}});
  const auto again = file.commit(CopyDemonstration{id, "", {}});
  REQUIRE((copy && again));
  CHECK(file.project()->demonstrations.at(DemonstrationId{*copy})->name == "whole copy");
  CHECK(file.project()->demonstrations.at(DemonstrationId{*again})->name == "whole copy 2");
  REQUIRE((file.undo() && file.undo()));
  REQUIRE(file.undo());
  CHECK(file.project()->hash() == hash);
}

TEST_CASE("every edit of the project reads back from its JSON as it was") {
  const std::vector<Edit> edits{
      AddDemonstration{{3}, "Grasp \"über\""},
      CopyDemonstration{{3}, "b", {demonstration::Mirror{}, demonstration::Trim{0.5, 1.5}}},
      SplitDemonstration{{3}, 1.25, "rest"},
      AddDemonstration{{3}, "paused", {demonstration::AddNote{"Paused", 0.5, 0.5, "recording", 0}}},
      PunchIn{{{3}, "take", {demonstration::AddNote{"Paused", 0.5, 0.5, "recording", 0}}},
              {4},
              demonstration::Overdub{0, 0.0, 0.5, 1.25, demonstration::Arms::kRight, 0.5, 0, nullptr}},
      CopyDemonstrations{{{{3}, "b", {demonstration::Mirror{}}}, {{3}, "c", {}}}},
      EditDemonstration{{3}, splice({2}, 1, 0.5)},
      RemoveDemonstration{{4}},
      EditDemonstration{{5}, Trim{0.1, 1.0 / 3.0}},
      EditDemonstration{{5}, LabelSegment{Segment::kE, 0.0, 1e-9}},
      AddModel{6},
      RemoveModel{{7}},
      RestoreDemonstration{{4}},
      MarkDemonstration{{4}, {Flag::kBad, Verdict::kFailure, 3, {"a"}, {"b"}, "über"}},
      MarkDemonstration{{4}, {}},
      SaveFilter{"long", "length>10"},
      RemoveFilter{"long"},
      Batch{"Two", {RemoveDemonstration{{4}}, EditDemonstration{{5}, Trim{0.1, 0.2}}}}};
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
