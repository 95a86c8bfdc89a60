// Takes by hand on their way into a project: kept, cut off, put in place of a span, beside what another arm does.
#include <doctest/doctest.h>

#include "engine/trial/key_script.h"
#include "engine/workbench/jobs/record_job.h"
#include "engine/workbench/take_plan.h"
#include "tests/support/project_fixture.h"

using namespace trocar;
using namespace trocar::workbench;
using testing::created;
using testing::opened;
using testing::ScratchFolder;
using trial::ArmSource;

namespace {

RecordByHand left_by_keys(const std::string& name = "") {
  RecordByHand request;
  request.options.sources = {ArmSource::kHand, ArmSource::kStill};
  request.options.countdown_s = 0.0;
  request.name = name;
  return request;
}

RecordReport record(ProjectFile& file, const RecordByHand& request, std::string_view script) {
  Progress progress;
  const auto report = record_keys(file, request, trial::parse_key_script(script).value(), progress);
  if (!report) FAIL(report.error().text());
  return *report;
}

std::shared_ptr<const demonstration::Demonstration> shown(const ProjectFile& file, DemonstrationId id) {
  return file.project()->demonstrations.at(id);
}

bool verifies(const demonstration::Demonstration& document) {
  Progress progress;
  return trial::replay(*document.recording, document.recorded, progress).value().verified;
}

}  // namespace

TEST_CASE("a take by keys is a demonstration that verifies, and says that a script played it") {
  const ScratchFolder folder;
  ProjectFile file = created(folder / "p.trocar");
  const RecordReport report = record(file, left_by_keys(), "0 hold D 0.5\n0.6 tap C\n1.5 end\n");
  const auto take = shown(file, report.id);
  CHECK(take->name == "By hand 1");
  CHECK(take->recording->provenance.operator_kind == "scripted");
  CHECK(take->recording->provenance.device == "key script; right arm still");
  CHECK(report.duration_s == doctest::Approx(1.5).epsilon(0.01));
  CHECK(verifies(*take));
  CHECK(record(file, left_by_keys(), "0.2 end\n").name == "By hand 2");
}

TEST_CASE("the same script gives the same take, bit for bit") {
  const ScratchFolder folder;
  ProjectFile file = created(folder / "p.trocar");
  constexpr std::string_view kScript = "0 hold Shift+W 0.4\n0.2 hold A 0.3\n0.8 tap C\n1 end\n";
  const RecordReport first = record(file, left_by_keys(), kScript);
  const RecordReport second = record(file, left_by_keys(), kScript);
  CHECK(shown(file, first.id)->hash() == shown(file, second.id)->hash());
}

TEST_CASE("a pause leaves a note where it was") {
  const ScratchFolder folder;
  ProjectFile file = created(folder / "p.trocar");
  const auto take = shown(file, record(file, left_by_keys(), "0.5 pause 2\n1 end\n").id);
  CHECK(file.history().size() == 1);
  REQUIRE(take->notes.size() == 1);
  CHECK(take->notes[0].begin_s == doctest::Approx(0.5).epsilon(0.02));
  CHECK(take->notes[0].text == "Paused for 2.0 s");
  CHECK(take->full_duration_s() == doctest::Approx(1.0).epsilon(0.02));
}

TEST_CASE("a take by hand that a crash cuts off is recovered up to its last quarter of a second, and verifies") {
  const ScratchFolder folder;
  {
    ProjectFile file = created(folder / "p.trocar");
    const TakePlan plan = plan_take(*file.project(), left_by_keys()).value();
    const auto session = trial::HandSession::create(plan.options).value();
    TakeWriter writer(file, session->provenance(), plan.name);
    session->post(trial::DriveTool{kinematics::ArmSide::kLeft, {0.0, 0.02, 0.0}, {0.0, 0.0, 0.0}});
    for (int i = 0; i < 2130; ++i) {
      session->step();
      REQUIRE(writer.write(take_part(*session)));
    }
  }
  Diagnostics diagnostics;
  const ProjectFile file = opened(folder / "p.trocar", diagnostics);
  REQUIRE(file.project()->demonstrations.size() == 1);
  const auto& recovered = *file.project()->demonstrations.begin()->second;
  CHECK(recovered.recording->recovered);
  CHECK(recovered.recording->provenance.operator_kind == "person");
  CHECK(recovered.full_duration_s() > 1.7);
  CHECK(verifies(recovered));
}

TEST_CASE("a take that ends before the countdown leaves nothing") {
  const ScratchFolder folder;
  ProjectFile file = created(folder / "p.trocar");
  RecordByHand request = left_by_keys();
  request.options.countdown_s = 3.0;
  const auto session = trial::HandSession::create(plan_take(*file.project(), request)->options).value();
  TakeWriter writer(file, session->provenance(), "x");
  session->post(trial::EndTake{});
  session->step();
  REQUIRE(writer.write(take_part(*session)));
  CHECK(writer.finish(demonstration::Outcome::kUnfinished, false).error().code() == ErrorCode::kCancelled);
  CHECK(file.project()->demonstrations.empty());
  CHECK(file.history().empty());
}

TEST_CASE("an overdub keeps what the replayed arm did and records the other one in the same world") {
  const ScratchFolder folder;
  ProjectFile file = created(folder / "p.trocar");
  const DemonstrationId first = record(file, left_by_keys("Left"), "0 hold W 0.5\n0.5 tap C\n1.2 end\n").id;
  RecordByHand request;
  request.options.sources = {ArmSource::kReplay, ArmSource::kHand};
  request.options.countdown_s = 0.0;
  request.replayed = first;
  const auto both = shown(file, record(file, request, "0.1 hold J 0.5\n1.2 end\n").id);
  const auto left = shown(file, first);
  CHECK(both->recording->provenance.device == "key script; left arm replay of Left");
  REQUIRE(both->samples.size() >= left->samples.size());
  for (std::size_t i = 0; i < left->samples.size(); ++i) {
    CHECK(both->samples[i].arms[0].setpoint() == left->samples[i].arms[0].setpoint());
    CHECK(both->samples[i].arms[0].setpoint_jaw_rad == left->samples[i].arms[0].setpoint_jaw_rad);
  }
  CHECK(both->samples.back().arms[1].setpoint_p[1] < left->samples.back().arms[1].setpoint_p[1] - 0.01);
  CHECK(verifies(*both));
}

TEST_CASE("a punch-in replaces the span that was selected, begins and ends where the arms were, and is undone") {
  const ScratchFolder folder;
  ProjectFile file = created(folder / "p.trocar");
  const DemonstrationId whole = record(file, left_by_keys("Whole"), "0 hold D 2\n2.5 end\n").id;
  const auto before = shown(file, whole);
  RecordByHand request = left_by_keys();
  request.replayed = whole;
  request.punch = TimeSpan{1.0, 1.5};
  const RecordReport report = record(file, request, "0 hold W 3\n3 end\n");
  CHECK(report.id == whole);
  const auto after = shown(file, whole);
  CHECK(after->full_duration_s() == doctest::Approx(before->full_duration_s()).epsilon(0.01));
  // Before the span nothing has changed; in it the tool goes up from where it was.
  CHECK(after->sample_at(0.9).arms[0].setpoint() == before->sample_at(0.9).arms[0].setpoint());
  const Eigen::Vector3d begin = before->sample_at(1.0).arms[0].setpoint().p;
  CHECK((after->sample_at(1.005).arms[0].setpoint().p - begin).norm() < 0.0005);
  CHECK(after->sample_at(1.45).arms[0].setpoint().p.z() > begin.z() + 0.008);
  // After it the old motion is joined again without a leap.
  for (double t_s = 1.4; t_s < 2.4; t_s += 0.005) {
    const Eigen::Vector3d from = after->sample_at(t_s).arms[0].setpoint().p;
    CHECK((after->sample_at(t_s + 0.005).arms[0].setpoint().p - from).norm() < 0.0012);
  }
  CHECK((after->sample_at(2.1).arms[0].setpoint().p - before->sample_at(2.1).arms[0].setpoint().p).norm() < 0.001);
  CHECK(after->segments == before->segments);
  CHECK(after->full_duration_s() == before->full_duration_s());
  REQUIRE(report.replaced);
  CHECK(report.take != whole);
  CHECK(shown(file, report.take)->name == report.name);
  // One step, and one entry of the stack, which can be made with other parameters.
  const std::int64_t made = file.head();
  REQUIRE(after->stack->size() == 1);
  auto overdub = std::get<demonstration::Overdub>(*after->stack->back().edit);
  CHECK(overdub.source == report.take.value);
  overdub.ease_s = 0.0;
  REQUIRE(file.commit(ReplaceStackEntry{whole, after->stack->back().id, overdub}));
  CHECK(shown(file, whole)->hash() != after->hash());
  REQUIRE(file.undo());
  CHECK(file.head() == made);
  REQUIRE(file.undo());
  CHECK(shown(file, whole)->hash() == before->hash());
  CHECK_FALSE(file.project()->demonstrations.contains(report.take));
  REQUIRE(file.redo());
  CHECK(shown(file, whole)->hash() == after->hash());
  Diagnostics diagnostics;
  CHECK(opened(folder / "p.trocar", diagnostics).project()->hash() == file.project()->hash());
}

TEST_CASE("a take that ends early replaces only what it recorded of its arm; a verdict is unsaid in the same step") {
  const ScratchFolder folder;
  ProjectFile file = created(folder / "p.trocar");
  const DemonstrationId whole = record(file, left_by_keys("Whole"), "0 hold D 2\n2.5 end\n").id;
  MarkChange said;
  said.verdict = Verdict::kSuccess;
  REQUIRE(file.commit(MarkDemonstration{whole, said}));
  const auto before = shown(file, whole);
  RecordByHand request = left_by_keys();
  request.options.sources = {ArmSource::kHand, ArmSource::kReplay};
  request.replayed = whole;
  request.punch = TimeSpan{1.0, 2.0};
  const std::int64_t steps = std::ssize(file.history());
  const RecordReport report = record(file, request, "0 hold W 0.2\n0.1 pause 1\n0.3 end\n");
  CHECK(std::ssize(file.history()) == steps + 1);
  CHECK(shown(file, report.take)->notes.size() == 1);
  CHECK(report.duration_s == doctest::Approx(0.3).epsilon(0.05));
  const auto after = shown(file, whole);
  CHECK(after->full_duration_s() == before->full_duration_s());
  REQUIRE(after->samples.size() == before->samples.size());
  for (std::size_t i = 0; i < before->samples.size(); ++i) {
    REQUIRE(after->samples[i].arms[1].setpoint_p == before->samples[i].arms[1].setpoint_p);
    REQUIRE(after->samples[i].arms[1].measured.p == before->samples[i].arms[1].measured.p);
  }
  CHECK(after->sample_at(1.9).arms[0].setpoint_p == before->sample_at(1.9).arms[0].setpoint_p);
  CHECK(file.project()->marks_of(whole).verdict == Verdict::kNone);
  REQUIRE(file.undo());
  CHECK(file.project()->marks_of(whole).verdict == Verdict::kSuccess);
  request.options.sources = {ArmSource::kReplay, ArmSource::kReplay};
  CHECK(plan_take(*file.project(), request).error().text() ==
        "both arms replay what is there: nothing would be replaced");
}

TEST_CASE("what a take cannot be made of is refused in one sentence") {
  const ScratchFolder folder;
  ProjectFile file = created(folder / "p.trocar");
  RecordByHand unknown = left_by_keys();
  unknown.replayed = DemonstrationId{77};
  CHECK(plan_take(*file.project(), unknown).error().text() == "there is no demonstration 77");
  RecordByHand nowhere = left_by_keys();
  nowhere.punch = TimeSpan{0.0, 1.0};
  CHECK(plan_take(*file.project(), nowhere).error().code() == ErrorCode::kInvalidArgument);
}

TEST_CASE("where the world of a demonstration is not known the arms are led to where it begins") {
  const ScratchFolder folder;
  ProjectFile file = created(folder / "p.trocar");
  const DemonstrationId source = record(file, left_by_keys("Source"), "0 hold D 1\n1 end\n").id;
  demonstration::RecordingInfo imported = *shown(file, source)->recording;
  imported.initial_world.clear();
  const auto stored = file.store_recording(imported, shown(file, source)->recorded);
  REQUIRE(stored);
  const DemonstrationId id{file.commit(AddDemonstration{*stored, "Imported"}).value()};
  RecordByHand request = left_by_keys();
  request.replayed = id;
  request.punch = TimeSpan{0.6, 0.9};
  const TakePlan plan = plan_take(*file.project(), request).value();
  CHECK(plan.options.initial_world.empty());
  const auto session = trial::HandSession::create(plan.options).value();
  int ticks = 0;
  while (session->status().phase == trial::Phase::kCountdown && ticks < 10'000) {
    session->step();
    ++ticks;
  }
  CHECK(ticks > 100);
  const Eigen::Vector3d there = shown(file, id)->sample_at(0.6).arms[0].setpoint().p;
  CHECK((session->state().arm(kinematics::ArmSide::kLeft).X_WT.p - there).norm() < 1e-6);
}
