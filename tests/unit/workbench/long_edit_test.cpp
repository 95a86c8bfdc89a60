// Edits of all of a long demonstration: made beside the window, and the same as if they were made in it.
#include <doctest/doctest.h>

#include <algorithm>
#include <memory>

#include "engine/demonstration/edits.h"
#include "engine/workbench/workbench.h"
#include "tests/support/project_fixture.h"

using namespace trocar;
using namespace trocar::workbench;
using testing::ScratchFolder;

namespace {

struct LongBench {
  LongBench() {
    { id = testing::add_demonstration(*std::make_unique<ProjectFile>(testing::created(path)), 25'000, "long"); }
    bench.post(OpenProject{path, false});
    CHECK(bench.wait_idle(120.0));
  }
  std::shared_ptr<const demonstration::Demonstration> shown() const {
    return bench.state().project->demonstrations.at(id);
  }

  ScratchFolder folder;
  std::filesystem::path path = folder / "p.trocar";
  DemonstrationId id;
  Workbench bench{{std::make_shared<ManualClock>(), false}};
};

const demonstration::Edit kSmooth = demonstration::Smooth{0.0, 125.0};

}  // namespace

TEST_CASE("an edit of all of a long demonstration does not hold up the window, and is what it would have been") {
  LongBench desk;
  const auto before = desk.shown();
  desk.bench.post(CommitEdit{EditDemonstration{desk.id, kSmooth}});
  CHECK(desk.shown() == before);
  CHECK(desk.bench.busy());
  REQUIRE(desk.bench.wait_idle(120.0));
  const auto expected = demonstration::apply(*before, kSmooth, desk.bench.state().head).value();
  CHECK(desk.shown()->hash() == expected.hash());
  CHECK(desk.shown()->hash() != before->hash());
  REQUIRE(desk.shown()->stack->size() == 1);
  CHECK(desk.shown()->stack->front().id == desk.bench.state().head);
  // The file has it too.
  CHECK(testing::opened(desk.path).project()->demonstrations.at(desk.id)->hash() == expected.hash());
  const auto after = desk.shown();
  desk.bench.post(Undo{});
  CHECK(desk.shown() == before);
  desk.bench.post(Redo{});
  CHECK(desk.shown() == after);
}

TEST_CASE("what is shown while its parameters are chosen is not worked out again when it is committed") {
  LongBench desk;
  desk.bench.post(PreviewEdit{kSmooth});
  REQUIRE(desk.bench.wait_idle(120.0));
  REQUIRE(desk.bench.state().preview->after != nullptr);
  const auto preview = desk.bench.state().preview->after;
  desk.bench.post(CommitEdit{EditDemonstration{desk.id, kSmooth}});
  // At once, and the very samples.
  CHECK(desk.shown()->samples.same_pieces(preview->samples));
  CHECK(desk.shown()->stack->front().id == desk.bench.state().head);
}

TEST_CASE(
    "an edit that is made beside the window is given up, with a word, if the demonstration is changed meanwhile") {
  LongBench desk;
  desk.bench.post(CommitEdit{EditDemonstration{desk.id, kSmooth}});
  desk.bench.post(CommitEdit{EditDemonstration{desk.id, demonstration::Trim{1.0, 20.0}}});
  REQUIRE(desk.bench.wait_idle(120.0));
  REQUIRE(desk.shown()->stack->size() == 1);
  CHECK(name_of(*desk.shown()->stack->front().edit) == "trim");
  CHECK(desk.shown()->begin_s == 1.0);
  const auto& log = desk.bench.state().log;
  CHECK(std::any_of(log.begin(), log.end(), [](const LogLine& line) {
    return line.severity == Severity::kError && line.text.find("changed meanwhile") != std::string::npos;
  }));
}

TEST_CASE("no take begins while an edit is being made beside the window, and it is said why") {
  LongBench desk;
  desk.bench.post(CommitEdit{EditDemonstration{desk.id, kSmooth}});
  RecordByHand take;
  take.options.countdown_s = 0.0;
  for (const Command& asked : std::vector<Command>{take, RecordScripted{}}) {
    desk.bench.post(asked);
    CHECK(desk.bench.state().log.back().text == "An edit is still being made; record when it is done");
  }
  REQUIRE(desk.bench.wait_idle(120.0));
  CHECK_FALSE(desk.bench.state().live);
  CHECK(desk.bench.state().project->demonstrations.size() == 1);
  REQUIRE(desk.shown()->stack->size() == 1);
  // Then it does.
  desk.bench.post(take);
  CHECK(desk.bench.state().log.back().text == "Armed");
  CHECK(desk.bench.finish(120.0));
}
