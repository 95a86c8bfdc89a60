#include "engine/workbench/project_file.h"

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>

#include "engine/core/file.h"
#include "engine/store/project_store.h"
#include "tests/support/document_samples.h"
#include "tests/support/project_fixture.h"

namespace fs = std::filesystem;
using namespace trocar;
using namespace trocar::workbench;
using demonstration::LabelSegment;
using demonstration::Rename;
using demonstration::Segment;
using demonstration::Trim;
using testing::add_demonstration;
using testing::created;
using testing::moving_recording;
using testing::moving_sample;
using testing::opened;
using testing::ScratchFolder;

namespace {

std::string name_of_only(const ProjectFile& file) {
  REQUIRE(file.project()->demonstrations.size() == 1);
  return file.project()->demonstrations.begin()->second->name;
}

std::int64_t rename(ProjectFile& file, DemonstrationId id, const std::string& name) {
  return file.commit(EditDemonstration{id, Rename{name}}).value();
}

}  // namespace

TEST_CASE("a demonstration comes back as it was recorded when the project is opened again") {
  const ScratchFolder folder;
  std::uint64_t hash = 0;
  {
    ProjectFile file = created(folder / "p.trocar");
    add_demonstration(file, 200, "First");
    hash = file.project()->hash();
  }
  const ProjectFile file = opened(folder / "p.trocar");
  CHECK(name_of_only(file) == "First");
  const demonstration::Demonstration& document = *file.project()->demonstrations.begin()->second;
  CHECK(document.segments.size() == 5);
  CHECK(testing::recording_of(document).content_hash() == moving_recording(200).content_hash());
  CHECK(document.recording->initial_world == moving_recording(1).initial_world);
  CHECK(document.recording->provenance.seed == 0xFFFFFFFFFFFFFFFFULL);
  CHECK(file.project()->hash() == hash);
}

TEST_CASE("closing a project leaves exactly one file") {
  const ScratchFolder folder;
  {
    ProjectFile file = created(folder / "p.trocar");
    add_demonstration(file, 200, "First");
  }
  CHECK(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator{}) == 1);
}

TEST_CASE("what is added has the number of its journal entry, and the history describes each edit") {
  const ScratchFolder folder;
  ProjectFile file = created(folder / "p.trocar");
  const DemonstrationId id = add_demonstration(file, 1000, "Expert 1");
  REQUIRE(file.commit(EditDemonstration{id, Trim{0.4, 3.25}}));
  REQUIRE(file.commit(EditDemonstration{id, LabelSegment{Segment::kC, 1.0, 2.0}}));
  rename(file, id, "Expert 2");
  REQUIRE(file.commit(RemoveDemonstration{id}));
  CHECK(id.value == 1);
  REQUIRE(file.history().size() == 5);
  CHECK(file.history()[0].description == "Add Expert 1");
  CHECK(file.history()[1].description == "Trim Expert 1 to 0.40–3.25 s");
  CHECK(file.history()[2].description == "Label 1.00–2.00 s of Expert 1 as C");
  CHECK(file.history()[3].description == "Rename Expert 1 to Expert 2");
  CHECK(file.history()[4].description == "Remove Expert 2");
  CHECK(file.history()[4].time == "2023-11-14T22:13:20Z");
  CHECK(file.head() == 5);
}

TEST_CASE("undo and redo walk the history, also after opening again, and stop at its ends") {
  const ScratchFolder folder;
  {
    ProjectFile file = created(folder / "p.trocar");
    const DemonstrationId id = add_demonstration(file, 10, "a");
    rename(file, id, "b");
    rename(file, id, "c");
    REQUIRE(file.undo());
    CHECK(name_of_only(file) == "b");
  }
  ProjectFile file = opened(folder / "p.trocar");
  CHECK(name_of_only(file) == "b");
  REQUIRE(file.redo());
  CHECK(name_of_only(file) == "c");
  CHECK_FALSE(file.redoable());
  CHECK(file.redo().error().text() == "there is nothing to redo");
  for (int i = 0; i < 3; ++i) REQUIRE(file.undo());
  CHECK(file.project()->demonstrations.empty());
  CHECK_FALSE(file.undoable());
  CHECK(file.undo().error().text() == "there is nothing to undo");
}

TEST_CASE("redo takes the branch that was left last, also after opening again") {
  const ScratchFolder folder;
  {
    ProjectFile file = created(folder / "p.trocar");
    const DemonstrationId id = add_demonstration(file, 10, "root");
    const std::int64_t first = rename(file, id, "first");
    REQUIRE(file.undo());
    rename(file, id, "second");
    REQUIRE(file.undo());
    REQUIRE(file.redo());
    CHECK(name_of_only(file) == "second");
    REQUIRE(file.go_to(first));
    CHECK(name_of_only(file) == "first");
    REQUIRE(file.undo());
  }
  ProjectFile file = opened(folder / "p.trocar");
  REQUIRE(file.redo());
  CHECK(name_of_only(file) == "first");
}

TEST_CASE("an edit that does not apply leaves project and history alone") {
  const ScratchFolder folder;
  ProjectFile file = created(folder / "p.trocar");
  const DemonstrationId id = add_demonstration(file, 10, "a");
  CHECK(file.commit(EditDemonstration{id, Trim{5.0, 1.0}}).error().code() == ErrorCode::kInvalidArgument);
  CHECK(file.commit(EditDemonstration{{77}, Trim{0.0, 1.0}}).error().text() == "the project has no demonstration 77");
  CHECK(file.commit(RemoveDemonstration{{77}}).error().code() == ErrorCode::kNotFound);
  CHECK(file.commit(RemoveModel{{77}}).error().code() == ErrorCode::kNotFound);
  CHECK(file.commit(AddModel{77}).error().code() == ErrorCode::kNotFound);
  CHECK(file.commit(AddDemonstration{{77}, "x"}).error().code() == ErrorCode::kNotFound);
  CHECK(file.go_to(77).error().code() == ErrorCode::kNotFound);
  CHECK(file.history().size() == 1);
}

TEST_CASE("demonstrations that an edit does not touch are shared between versions") {
  const ScratchFolder folder;
  ProjectFile file = created(folder / "p.trocar");
  const DemonstrationId touched = add_demonstration(file, 10, "a");
  const DemonstrationId other = add_demonstration(file, 10, "b");
  const auto before = file.project();
  rename(file, touched, "c");
  CHECK(file.project()->demonstrations.at(other) == before->demonstrations.at(other));
  CHECK(file.project()->demonstrations.at(touched)->recording == before->demonstrations.at(touched)->recording);
}

TEST_CASE("a recording that was cut off is recovered once, with a warning, and can be undone") {
  const ScratchFolder folder;
  {
    ProjectFile file = created(folder / "p.trocar");
    RecordingWriter writer = file.begin_recording({}, "world").value();
    for (int i = 0; i < 130; ++i) REQUIRE(writer.add(moving_sample(i)));
  }
  {
    Diagnostics diagnostics;
    ProjectFile file = opened(folder / "p.trocar", diagnostics);
    REQUIRE(diagnostics.warnings().size() == 1);
    CHECK(diagnostics.warnings()[0] == "a recording was cut off after 0.5 s and has been recovered");
    CHECK(name_of_only(file) == "Recovered (0.5 s)");
    const auto& shown = *file.project()->demonstrations.begin()->second;
    CHECK(shown.recorded.size() == 100);  // Whole chunks of 50.
    CHECK(shown.recording->recovered);
    CHECK(shown.recording->initial_world == "world");
  }
  ProjectFile again = opened(folder / "p.trocar");
  CHECK(again.project()->demonstrations.size() == 1);
  CHECK(again.undo());
}

TEST_CASE("a recording that was finished but never added is recovered, one that was discarded is not") {
  const ScratchFolder folder;
  {
    ProjectFile file = created(folder / "p.trocar");
    for (const bool keep : {true, false}) {
      RecordingWriter writer = file.begin_recording({}, "").value();
      for (int i = 0; i < 60; ++i) REQUIRE(writer.add(moving_sample(i)));
      if (keep) REQUIRE(writer.finish(demonstration::Outcome::kSuccess, true));
      if (!keep) REQUIRE(writer.discard());
    }
  }
  Diagnostics diagnostics;
  const ProjectFile file = opened(folder / "p.trocar", diagnostics);
  CHECK(name_of_only(file) == "Recovered (0.3 s)");
  CHECK(file.project()->demonstrations.begin()->second->recording->outcome == demonstration::Outcome::kSuccess);
}

TEST_CASE("a recording of fewer than two samples is dropped with a warning") {
  const ScratchFolder folder;
  {
    ProjectFile file = created(folder / "p.trocar");
    RecordingWriter writer = file.begin_recording({}, "").value();
    REQUIRE(writer.add(moving_sample(0)));
    CHECK(writer.finish(demonstration::Outcome::kSuccess, true).error().code() == ErrorCode::kInvalidArgument);
  }
  Diagnostics diagnostics;
  CHECK(opened(folder / "p.trocar", diagnostics).project()->demonstrations.empty());
  CHECK(diagnostics.warnings().size() == 1);
  CHECK(opened(folder / "p.trocar").history().empty());
}

TEST_CASE("a recording in the making is left alone by another who opens the project") {
  const ScratchFolder folder;
  ProjectFile file = created(folder / "p.trocar");
  RecordingWriter writer = file.begin_recording({}, "").value();
  for (int i = 0; i < 60; ++i) REQUIRE(writer.add(moving_sample(i)));
  CHECK(opened(folder / "p.trocar").project()->demonstrations.empty());
  for (int i = 60; i < 120; ++i) REQUIRE(writer.add(moving_sample(i)));
  const auto id = writer.finish(demonstration::Outcome::kSuccess, true);
  REQUIRE(id);
  REQUIRE(file.commit(AddDemonstration{*id, "Whole"}));
  CHECK(file.project()->demonstrations.begin()->second->gated().size() == 120);
}

TEST_CASE("a bad sample is refused by the writer and the recording goes on without it") {
  const ScratchFolder folder;
  ProjectFile file = created(folder / "p.trocar");
  RecordingWriter writer = file.begin_recording({}, "").value();
  REQUIRE(writer.add(moving_sample(0)));
  CHECK(writer.add(moving_sample(0)).error().code() == ErrorCode::kInvalidArgument);
  demonstration::Sample bad = moving_sample(1);
  bad.arms[0].setpoint_p[0] = std::nan("");
  CHECK(writer.add(bad).error().code() == ErrorCode::kInvalidArgument);
  REQUIRE(writer.add(moving_sample(1)));
  const auto id = writer.finish(demonstration::Outcome::kSuccess, false).value();
  REQUIRE(file.commit(AddDemonstration{id, "Good"}));
}

TEST_CASE("a model that is cancelled while it is stored leaves nothing behind, and one that is added stays") {
  const ScratchFolder folder;
  ProjectFile file = created(folder / "p.trocar");
  const DemonstrationId source = add_demonstration(file, 10, "a");
  const ModelEntry entry = testing::small_model();
  Progress cancelled;
  cancelled.cancel();
  const auto refused = file.add_model(entry, cancelled);
  REQUIRE_FALSE(refused);
  CHECK(refused.error().code() == ErrorCode::kCancelled);
  CHECK(file.project()->models.empty());
  ProjectFile other = opened(folder / "p.trocar");
  REQUIRE(other.commit(EditDemonstration{source, Rename{"b"}}));
  const auto id = file.add_model(entry, Progress());
  REQUIRE(id);
  CHECK(file.project()->models.at(ModelId{*id})->model->hash() == entry.model->hash());
  CHECK(name_of_only(file) == "b");
  store::ProjectStore store = store::ProjectStore::open(folder / "p.trocar").value();
  CHECK(store.objects("model").value().size() == 1);
}

TEST_CASE("an edit is made on what another program has committed in between, and both stay") {
  const ScratchFolder folder;
  ProjectFile one = created(folder / "p.trocar");
  const DemonstrationId id = add_demonstration(one, 400, "a");
  ProjectFile two = opened(folder / "p.trocar");
  rename(one, id, "from one");
  REQUIRE(two.commit(EditDemonstration{id, Trim{0.5, 1.5}}));
  CHECK(name_of_only(two) == "from one");
  CHECK(two.project()->demonstrations.at(id)->begin_s == 0.5);
  REQUIRE(two.history().size() == 3);
  CHECK(two.history()[2].parent == 2);
  CHECK(two.history()[2].description == "Trim from one to 0.50–1.50 s");
  REQUIRE(one.commit(EditDemonstration{id, Rename{"last"}}));
  CHECK(one.project()->demonstrations.at(id)->begin_s == 0.5);
  CHECK(opened(folder / "p.trocar").project()->hash() == one.project()->hash());
}

TEST_CASE("an edit of what another program has removed is an error, and its own document follows") {
  const ScratchFolder folder;
  ProjectFile one = created(folder / "p.trocar");
  const DemonstrationId id = add_demonstration(one, 10, "a");
  ProjectFile two = opened(folder / "p.trocar");
  REQUIRE(one.commit(RemoveDemonstration{id}));
  CHECK(two.commit(EditDemonstration{id, Rename{"b"}}).error().code() == ErrorCode::kNotFound);
  CHECK(two.history().size() == 2);
  CHECK(two.project()->demonstrations.empty());
}

TEST_CASE("undo and redo go on from where another program has moved the project") {
  const ScratchFolder folder;
  ProjectFile one = created(folder / "p.trocar");
  const DemonstrationId id = add_demonstration(one, 10, "a");
  rename(one, id, "b");
  ProjectFile two = opened(folder / "p.trocar");
  rename(one, id, "c");
  REQUIRE(two.undo());  // Of "c", which is the last edit, not of "b".
  CHECK(name_of_only(two) == "b");
  REQUIRE(one.undo());
  CHECK(name_of_only(one) == "a");
  REQUIRE(two.redo());
  CHECK(name_of_only(two) == "b");
  REQUIRE(one.redo());
  CHECK(name_of_only(one) == "c");
  CHECK_FALSE(two.redo());
  CHECK(name_of_only(two) == "c");
  rename(two, id, "d");
  CHECK(two.history().size() == 4);
  CHECK(two.history()[3].parent == 3);
  CHECK(opened(folder / "p.trocar").head() == 4);
}

TEST_CASE("damaged samples are found by their hash when the project is opened") {
  const ScratchFolder folder;
  {
    ProjectFile file = created(folder / "p.trocar");
    add_demonstration(file, 400, "a");
  }
  std::string bytes = read_file(folder / "p.trocar").value();
  // The last chunk's bytes lie in the last pages; a changed digit of a coordinate is a plausible number still.
  const demonstration::Sample sample = moving_sample(390);
  const std::string_view pattern(reinterpret_cast<const char*>(&sample.arms[0].setpoint_p), 16);
  const std::size_t at = bytes.find(pattern);
  REQUIRE(at != std::string::npos);
  bytes[at] = static_cast<char>(bytes[at] ^ 1);
  REQUIRE(write_file(folder / "bad.trocar", bytes));
  Diagnostics diagnostics;
  const auto file = ProjectFile::open(folder / "bad.trocar", testing::clock_at_rest(), diagnostics);
  REQUIRE_FALSE(file);
  CHECK(file.error().code() == ErrorCode::kCorrupt);
  CHECK(file.error().text().find("its content does not match its hash") != std::string::npos);
}

TEST_CASE("a journal that does not apply is an error that names the entry") {
  const ScratchFolder folder;
  { created(folder / "p.trocar"); }
  {
    store::ProjectStore store = store::ProjectStore::open(folder / "p.trocar").value();
    REQUIRE(store.append({0, 0, "t", "remove demonstration", R"({"demonstration":5})", ""}));
  }
  Diagnostics diagnostics;
  const auto file = ProjectFile::open(folder / "p.trocar", testing::clock_at_rest(), diagnostics);
  REQUIRE_FALSE(file);
  CHECK(
      file.error().text().starts_with("the history's entry 1 (remove demonstration) cannot be applied: the project "
                                      "has no demonstration 5: "));
}
