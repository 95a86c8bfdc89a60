#include "engine/workbench/clipboard.h"

#include <doctest/doctest.h>

#include "engine/demonstration/edits.h"
#include "engine/demonstration/motion.h"
#include "engine/workbench/workbench.h"
#include "tests/support/project_fixture.h"

using namespace trocar;
using namespace trocar::workbench;
using demonstration::Align;
using demonstration::measured_tip;
using testing::ScratchFolder;

namespace {

/// The application on a project with one demonstration of 5 s.
struct Bench {
  Bench() {
    {
      id = testing::add_demonstration(*std::make_unique<ProjectFile>(testing::created(folder / "p.trocar")), 1001, "a");
    }
    bench.post(OpenProject{folder / "p.trocar", false});
    CHECK(bench.wait_idle(60.0));
  }
  const WorkbenchState& state() const { return bench.state(); }
  std::shared_ptr<const demonstration::Demonstration> shown() const { return state().project->demonstrations.at(id); }
  void edit(const demonstration::Edit& edit) { bench.post(CommitEdit{EditDemonstration{id, edit}}); }
  void copy(double begin_s, double end_s) { bench.post(CopyRun{id, {begin_s, end_s}}); }
  void take_out(double begin_s, double end_s, bool ripple) {
    edit(deletion(*shown(), {begin_s, end_s}, ripple).value());
  }
  void paste_at(double t_s, std::optional<TimeSpan> selection = {}, Align align = Align::kAsRecorded) {
    edit(paste(*state().clipboard, *shown(), t_s, selection, align));
  }

  ScratchFolder folder;
  DemonstrationId id;
  std::shared_ptr<ManualClock> clock = std::make_shared<ManualClock>();
  Workbench bench{{clock, false}};
};

}  // namespace

TEST_CASE("what is pasted is what was copied, also when the source has been edited since") {
  Bench desk;
  const auto original = desk.shown();
  desk.copy(1.0, 2.0);
  desk.edit(demonstration::Offset{demonstration::Arms::kBoth, {0.005, 0.0, 0.0}});
  desk.take_out(0.5, 3.0, true);
  desk.paste_at(1.0);
  const auto pasted = desk.shown();
  REQUIRE(pasted->samples.size() == 1001 - 500 + 200);
  for (std::size_t i = 0; i < 200; ++i) {
    CHECK(measured_tip(pasted->samples[200 + i], 0) == measured_tip(original->samples[200 + i], 0));
  }
}

TEST_CASE("what was copied can be pasted after its source is gone from the project") {
  Bench desk;
  desk.bench.post(CommitEdit{CopyDemonstration{desk.id, "b", {}}});
  desk.copy(1.0, 2.0);
  const DemonstrationId other{desk.state().project->demonstrations.rbegin()->first};
  desk.bench.post(CommitEdit{RemoveDemonstration{desk.id}});
  REQUIRE(desk.state().demonstration == other);
  desk.id = other;
  desk.paste_at(3.0);
  CHECK(desk.shown()->samples.size() == 1201);
}

TEST_CASE("a paste is one step of the history, and undone the hash is as before") {
  Bench desk;
  desk.copy(1.0, 2.0);
  const std::uint64_t before = desk.state().project->hash();
  const std::size_t steps = desk.state().history.size();
  desk.paste_at(3.0, {}, Align::kMeet);
  const std::uint64_t after = desk.state().project->hash();
  CHECK(after != before);
  CHECK(desk.state().history.size() == steps + 1);
  desk.bench.post(Undo{});
  CHECK(desk.state().project->hash() == before);
  desk.bench.post(Redo{});
  CHECK(desk.state().project->hash() == after);
}

TEST_CASE("what was cut and is pasted where it was is there as if nothing had happened") {
  for (const TimeSpan& span : {TimeSpan{1.0, 2.0}, TimeSpan{0.0, 0.75}, TimeSpan{1.0025, 1.5025}}) {
    Bench desk;
    const std::uint64_t before = desk.shown()->samples.hash();
    desk.copy(span.begin_s, span.end_s);
    desk.take_out(span.begin_s, span.end_s, true);
    CHECK(desk.shown()->samples.hash() != before);
    desk.paste_at(span.begin_s);
    CHECK(desk.shown()->samples.hash() == before);
  }
}

TEST_CASE("a span up to the gate is taken out by moving the gate, and what is pasted there is between the gates") {
  Bench desk;
  desk.edit(demonstration::Trim{1.0, 4.0});
  desk.copy(3.0, 4.0);
  CHECK(desk.state().clipboard->to_s == doctest::Approx(4.0));
  desk.take_out(3.0, 4.0, true);
  CHECK(desk.shown()->samples.size() == 1001);
  CHECK(desk.shown()->end_s == doctest::Approx(2.995));
  const double length_s = desk.shown()->duration_s();
  desk.paste_at(desk.shown()->end_s);
  CHECK(desk.shown()->duration_s() == doctest::Approx(length_s + 1.005));
  CHECK(measured_tip(desk.shown()->gated().back(), 0) == measured_tip(desk.shown()->recorded[800], 0));
  CHECK(desk.state().playhead_s == doctest::Approx(desk.shown()->end_s));
}

TEST_CASE("a selection is replaced by what is pasted, the gate's end included") {
  Bench desk;
  desk.copy(1.0, 1.5);
  desk.paste_at(0.0, TimeSpan{2.0, 4.0});
  CHECK(desk.shown()->samples.size() == 1001 - 400 + 100);
  desk.paste_at(0.0, TimeSpan{2.0, desk.shown()->end_s});
  CHECK(desk.shown()->gated().size() == 500);
  CHECK(measured_tip(desk.shown()->gated().back(), 0) == measured_tip(desk.shown()->recorded[299], 0));
}

TEST_CASE("not all can be taken out, and a lifted begin is trimmed") {
  Bench desk;
  CHECK_FALSE(deletion(*desk.shown(), {0.0, 5.0}, true).has_value());
  const auto begin = deletion(*desk.shown(), {0.0, 1.0}, false).value();
  REQUIRE(std::holds_alternative<demonstration::Trim>(begin));
  CHECK(std::get<demonstration::Trim>(begin).from_s == doctest::Approx(1.0));
}

TEST_CASE("a selection is kept within the gates, and goes with what it was about") {
  Bench desk;
  desk.bench.post(SetSelection{TimeSpan{6.0, 3.0}});
  REQUIRE(desk.state().selection);
  CHECK(*desk.state().selection == TimeSpan{3.0, 5.0});
  desk.edit(demonstration::Trim{0.0, 4.0});
  CHECK(*desk.state().selection == TimeSpan{3.0, 4.0});
  desk.edit(demonstration::Trim{0.0, 2.0});
  CHECK_FALSE(desk.state().selection);
  desk.bench.post(SetSelection{TimeSpan{1.0, 1.0}});
  CHECK_FALSE(desk.state().selection);
}

TEST_CASE("after a cut the playhead stands at the join, nothing is selected, and the jump is told") {
  Bench desk;
  desk.bench.post(SetSelection{TimeSpan{1.0, 2.0}});
  desk.take_out(1.0, 2.0, true);
  CHECK(desk.state().playhead_s == 1.0);
  CHECK_FALSE(desk.state().selection);
  CHECK(desk.state().done.starts_with("Delete 1.00–2.00 s of a; the tools jump "));
  CHECK(desk.state().done.ends_with(" at 1.00 s"));
}

TEST_CASE("nothing of another project is pasted") {
  Bench desk;
  desk.copy(1.0, 2.0);
  CHECK(desk.state().clipboard);
  desk.bench.post(OpenProject{desk.folder / "q.trocar", true});
  CHECK(desk.bench.wait_idle(60.0));
  CHECK_FALSE(desk.state().clipboard);
}

TEST_CASE("a loop plays the selection again and again, also backwards, and the gates end it where there is none") {
  Bench desk;
  const auto play_s = [&](double seconds) {
    desk.clock->advance_s(seconds);
    desk.bench.poll();
    return desk.state().playhead_s;
  };
  desk.bench.post(SetSelection{TimeSpan{1.0, 2.0}});
  desk.bench.post(SetLoop{Loop::kSpan});
  desk.bench.post(SetPlayhead{1.9});
  desk.bench.post(Play{1.0});
  desk.bench.poll();
  CHECK(play_s(0.2) == doctest::Approx(1.1));
  desk.bench.post(Play{-1.0});
  CHECK(play_s(0.2) == doctest::Approx(1.9));
  desk.bench.post(SetLoop{});
  desk.bench.post(SetPlayhead{4.9});
  desk.bench.post(Play{1.0});
  CHECK(play_s(0.2) == doctest::Approx(5.0));
  CHECK(desk.state().play_speed == 0.0);
  desk.bench.post(Play{-2.0});
  CHECK(play_s(0.1) == doctest::Approx(4.8));
}

TEST_CASE("the loop of a segment goes with the playhead") {
  Bench desk;
  desk.bench.post(SetLoop{Loop::kSegment});
  const auto& span = desk.shown()->segments[2];
  desk.bench.post(SetPlayhead{span.end_s - 0.05});
  desk.bench.post(Play{1.0});
  desk.bench.poll();
  desk.clock->advance_s(0.1);
  desk.bench.poll();
  CHECK(desk.state().playhead_s == doctest::Approx(span.begin_s + 0.05));
}
