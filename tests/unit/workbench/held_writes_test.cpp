// A project that another program is writing to: nothing waits for it, and nothing that was asked for is lost.
#include <doctest/doctest.h>

#include <memory>

#include "engine/store/project_store.h"
#include "engine/workbench/workbench.h"
#include "tests/support/project_fixture.h"

using namespace trocar;
using namespace trocar::workbench;
using testing::ScratchFolder;

namespace {

/// The application, and another program, on a project with one demonstration.
struct HeldBench {
  HeldBench() {
    { id = testing::add_demonstration(*std::make_unique<ProjectFile>(testing::created(path)), 1001, "a"); }
    bench.post(OpenProject{path, false});
    CHECK(bench.wait_idle(60.0));
    other = std::make_unique<store::ProjectStore>(store::ProjectStore::open(path).value());
  }
  void rename(const std::string& name) { bench.post(CommitEdit{EditDemonstration{id, demonstration::Rename{name}}}); }
  std::string name() const { return bench.state().project->demonstrations.at(id)->name; }
  /// `work` happens while the other program is in the middle of a write.
  void while_held(const std::function<void()>& work) const {
    const Status done = other->transaction([&]() -> Status {
      TROCAR_RETURN_IF_ERROR(other->set_setting("busy", "yes"));
      work();
      return {};
    });
    CHECK(done);
  }
  std::size_t logged(const std::string& words) const {
    std::size_t count = 0;
    for (const LogLine& line : bench.state().log) count += line.text.find(words) != std::string::npos ? 1 : 0;
    return count;
  }

  ScratchFolder folder;
  std::filesystem::path path = folder / "p.trocar";
  DemonstrationId id;
  std::shared_ptr<ManualClock> clock = std::make_shared<ManualClock>();
  Workbench bench{{clock, false}};
  std::unique_ptr<store::ProjectStore> other;
};

}  // namespace

TEST_CASE("an edit while another program writes is made as soon as that is done, and said to wait") {
  HeldBench desk;
  desk.while_held([&] {
    desk.rename("b");
    desk.bench.poll();
    CHECK(desk.name() == "a");
    CHECK(desk.bench.busy());
  });
  desk.bench.poll();
  CHECK(desk.name() == "b");
  CHECK(desk.logged("waits for it") == 1);
  CHECK(desk.bench.wait_idle(60.0));
}

TEST_CASE("what waits is done in the order in which it was asked for") {
  HeldBench desk;
  desk.while_held([&] {
    desk.rename("b");
    desk.rename("c");
    desk.bench.post(Undo{});
    desk.bench.poll();
  });
  desk.bench.poll();
  CHECK(desk.name() == "b");
  CHECK(desk.bench.state().redoable);
  CHECK(desk.logged("waits for it") == 1);
}

TEST_CASE("what has waited too long is given up, and said to be") {
  HeldBench desk;
  desk.while_held([&] {
    desk.rename("b");
    desk.clock->advance_s(20.0);
    desk.bench.poll();
    CHECK(desk.logged("was given up") == 1);
    CHECK_FALSE(desk.bench.busy());
  });
  desk.bench.poll();
  CHECK(desk.name() == "a");
}

TEST_CASE("an edit that cannot be made is no wait, also after one that waited") {
  HeldBench desk;
  desk.while_held([&] { desk.rename("b"); });
  desk.bench.poll();
  desk.bench.post(Redo{});
  CHECK(desk.bench.wait_idle(60.0));
  CHECK(desk.logged("waits for it") == 1);
}

TEST_CASE("a recording goes on while another program writes, and has all samples in the end") {
  const ScratchFolder folder;
  ProjectFile file = testing::created(folder / "p.trocar");
  store::ProjectStore other = store::ProjectStore::open(folder / "p.trocar").value();
  const demonstration::Recording made = testing::moving_recording(401);
  RecordingWriter writer = file.begin_recording(made.provenance, made.initial_world).value();
  const auto add = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) REQUIRE(writer.add(made.samples[i]));
  };
  add(0, 120);
  CHECK(other.transaction([&]() -> Status {
    TROCAR_RETURN_IF_ERROR(other.set_setting("busy", "yes"));
    add(120, 330);
    return {};
  }));
  add(330, 401);
  const auto id = writer.finish(demonstration::Outcome::kSuccess, true);
  REQUIRE(id);
  REQUIRE(file.commit(AddDemonstration{*id, "a"}));
  CHECK(file.project()->demonstrations.begin()->second->recorded.size() == 401);
}
