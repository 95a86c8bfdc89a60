// The workbench without a face, with its real threads: record, learn, look, undo, film, and what goes wrong.
#include "engine/workbench/workbench.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <thread>

#include "engine/media/video_writer.h"
#include "engine/workbench/importing.h"
#include "tests/support/scratch_folder.h"

using namespace trocar;
using namespace trocar::workbench;

namespace {

constexpr double kPatience_s = 300.0;  // sanitizers are slow

/// A workbench with a new project, without pictures.
struct Bench {
  trocar::testing::ScratchFolder folder;
  Workbench workbench{{nullptr, false}};

  Bench() { run(OpenProject{folder / "p.trocar", true}); }
  const WorkbenchState& state() const { return workbench.state(); }
  void run(Command command) {
    workbench.post(std::move(command));
    REQUIRE(workbench.wait_idle(kPatience_s));
  }
  bool logged(Severity severity) const {
    return std::any_of(state().log.begin(), state().log.end(),
                       [severity](const LogLine& line) { return line.severity == severity; });
  }
  void record() { run(RecordScripted{{}, "", false}); }
};

}  // namespace

TEST_CASE("a recorded transfer is in the project, selected, placed and verified") {
  Bench bench;
  REQUIRE(bench.state().load == LoadState::kReady);
  bench.record();
  REQUIRE(bench.state().project->demonstrations.size() == 1);
  const auto& shown = *bench.state().project->demonstrations.begin()->second;
  CHECK(bench.state().demonstration == shown.id);
  CHECK(shown.name == "Expert 1");
  CHECK(shown.recording->placed);
  CHECK(shown.recording->provenance.operator_kind == "scripted");
  bench.run(VerifyReplay{shown.id});
  REQUIRE_FALSE(bench.state().jobs.empty());
  CHECK(bench.state().jobs.front().state == JobState::kDone);
}

TEST_CASE("a training shows its curve while it runs, and leaves none behind when it is stopped") {
  Bench bench;
  bench.record();
  TrainModel train;
  train.demonstrations = {bench.state().demonstration};
  train.options = learning::options_of(learning::Preset::kPaper, 22);
  train.options.episodes = 1'000'000;
  bench.workbench.post(train);
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::duration<double>(kPatience_s);
  const auto told = [&] { return bench.state().training ? bench.state().training->curve.size() : 0; };
  std::size_t first = 0;
  while (std::chrono::steady_clock::now() < deadline && (first == 0 || told() <= first)) {
    bench.workbench.poll();
    if (first == 0) first = told();
  }
  REQUIRE(bench.state().training);
  const TrainingView view = *bench.state().training;
  CHECK(view.epochs == 10'000);
  CHECK(view.name == "eg-maxent A ε=0.1");
  // What it tells is the beginning of the curve that the model would have.
  train.options.episodes = static_cast<int>(100 * view.curve.size());
  bench.run(CancelJob{view.job});
  CHECK_FALSE(bench.state().training);
  CHECK(bench.state().project->models.empty());
  if (view.curve.size() < 2000) {
    bench.run(train);
    CHECK(bench.state().project->models.begin()->second->model->curve == view.curve);
  }
}

TEST_CASE("a preview shows what an edit would do, is gone after the edit, and says why one cannot be made") {
  Bench bench;
  bench.record();
  const DemonstrationId id = bench.state().demonstration;
  const demonstration::Edit offset = demonstration::Offset{demonstration::Arms::kLeft, {0.0, 0.0, 0.005}};
  const std::uint64_t before = bench.state().project->demonstrations.at(id)->hash();
  bench.run(PreviewEdit{offset, 0});
  REQUIRE(bench.state().preview);
  REQUIRE(bench.state().preview->after);
  CHECK(bench.state().preview->difference.max_deviation_m == doctest::Approx(0.005).epsilon(1e-4));
  CHECK(bench.state().project->demonstrations.at(id)->hash() == before);
  const std::uint64_t promised = bench.state().preview->after->hash();
  bench.run(CommitEdit{EditDemonstration{id, offset}});
  CHECK(bench.state().project->demonstrations.at(id)->hash() == promised);
  CHECK_FALSE(bench.state().preview);
  bench.run(PreviewEdit{demonstration::Trim{80.0, 90.0}, 0});
  REQUIRE(bench.state().preview);
  CHECK_FALSE(bench.state().preview->after);
  CHECK_FALSE(bench.state().preview->error.empty());
  bench.run(EndPreview{});
  CHECK_FALSE(bench.state().preview);
}

TEST_CASE("a trained model is selected with its field and rollouts, stale after an edit and fresh after undo") {
  Bench bench;
  bench.record();
  const DemonstrationId id = bench.state().demonstration;
  learning::TrainOptions options;
  options.method = learning::Method::kExact;
  bench.run(TrainModel{{id}, demonstration::Segment::kA, options, 22, ""});
  REQUIRE(bench.state().insight);
  CHECK(bench.state().insight->all.count == 10648);
  CHECK(bench.state().insight->all.arrived == 10648);
  CHECK_FALSE(bench.state().insight->ghosts.empty());
  CHECK_FALSE(bench.state().insight->stale);

  const auto& shown = *bench.state().project->demonstrations.at(id);
  bench.run(CommitEdit{EditDemonstration{id, demonstration::Trim{shown.begin_s + 0.1, shown.end_s - 0.1}}});
  CHECK(bench.state().insight->stale);
  bench.run(Undo{});
  CHECK_FALSE(bench.state().insight->stale);
}

TEST_CASE("a discarded recording leaves no demonstration") {
  Bench bench;
  bench.workbench.post(RecordScripted{{}, "", true});
  bench.workbench.poll();
  REQUIRE(bench.state().live);
  CHECK(bench.state().live->world.blocks[0].X_WK.p.z() > 0.0);  // a world, from the first frame on
  bench.run(StopRecording{false});
  CHECK(bench.state().project->demonstrations.empty());
  CHECK_FALSE(bench.state().live);
}

TEST_CASE("a stopped recording that is kept ends as aborted") {
  Bench bench;
  bench.workbench.post(RecordScripted{{}, "Short", true});
  while (!bench.state().live || bench.state().live->samples < 10) bench.workbench.poll();
  bench.run(StopRecording{true});
  REQUIRE(bench.state().project->demonstrations.size() == 1);
  CHECK(bench.state().project->demonstrations.begin()->second->recording->outcome == demonstration::Outcome::kAborted);
}

TEST_CASE("a project that cannot be opened leaves the open one alone and says why") {
  Bench bench;
  const auto before = bench.state().project;
  std::ofstream(bench.folder / "foreign.trocar") << "not a project";
  bench.run(OpenProject{bench.folder / "foreign.trocar", false});
  CHECK(bench.state().load == LoadState::kReady);
  CHECK(bench.state().project == before);
  CHECK(bench.logged(Severity::kError));
}

TEST_CASE("a film or a field is never written over the open project") {
  Bench bench;
  bench.record();
  const std::filesystem::path project = bench.folder / "p.trocar";
  std::filesystem::create_symlink(project, bench.folder / "link.mp4");
  const std::uint64_t hash = bench.state().project->hash();
  for (const std::filesystem::path& path : {project, bench.folder / "link.mp4"}) {
    bench.run(ExportVideo{{bench.state().demonstration}, path});
    ExportField field;
    field.path = path;
    bench.run(field);
  }
  CHECK(bench.state().jobs.empty());
  CHECK(bench.logged(Severity::kError));
  bench.run(OpenProject{project, false});
  REQUIRE(bench.state().load == LoadState::kReady);
  CHECK(bench.state().project->hash() == hash);
}

TEST_CASE("unknown ids and commands without a project are answered in the log") {
  Workbench empty({nullptr, false});
  empty.post(Undo{});
  CHECK(empty.state().log.size() == 1);
  Bench bench;
  bench.run(SelectDemonstration{DemonstrationId{77}});
  CHECK(bench.state().log.back().severity == Severity::kError);
  bench.run(TrainModel{{DemonstrationId{77}}, demonstration::Segment::kA, {}, 22, ""});
  CHECK(bench.state().jobs.front().state == JobState::kFailed);
}

TEST_CASE("the playhead stays within the gates and playing stops at the end") {
  Bench bench;
  bench.record();
  const auto& shown = *bench.state().project->demonstrations.begin()->second;
  bench.run(SetPlayhead{1e9});
  CHECK(bench.state().playhead_s == shown.end_s);
  bench.run(SetPlayhead{-1e9});
  CHECK(bench.state().playhead_s == shown.begin_s);
  bench.run(SetPlayhead{shown.end_s - 0.05});
  bench.run(Play{1.0});
  CHECK(bench.state().play_speed == 0.0);
  CHECK(bench.state().playhead_s == shown.end_s);
}

TEST_CASE("a cancelled film leaves no file, a finished one has every frame") {
  Bench bench;
  bench.record();
  const DemonstrationId id = bench.state().demonstration;
  const std::filesystem::path path = bench.folder / "film.mp4";
  bench.workbench.post(ExportVideo{{id}, path, 320, 180, 10.0});
  while (bench.workbench.poll() && bench.state().jobs.front().fraction == 0.0) {
  }
  bench.run(CancelJob{bench.state().jobs.front().id});
  CHECK(bench.state().jobs.front().state == JobState::kCancelled);
  CHECK(std::none_of(std::filesystem::directory_iterator(bench.folder.path()), {},
                     [](const auto& entry) { return entry.path().extension() == ".mp4"; }));

  const auto& shown = *bench.state().project->demonstrations.at(id);
  bench.run(CommitEdit{EditDemonstration{id, demonstration::Trim{shown.begin_s, shown.begin_s + 1.0}}});
  bench.run(ExportVideo{{id}, path, 320, 180, 10.0});
  CHECK(bench.state().jobs.front().state == JobState::kDone);
  CHECK(media::probe_video(path).value().frames == 11);
}

TEST_CASE("while a project is being opened, nothing is recorded into the one that is about to close") {
  Bench bench;
  const std::filesystem::path first = bench.folder / "p.trocar";
  bench.run(OpenProject{bench.folder / "second.trocar", true});
  bench.workbench.post(OpenProject{first, false});
  bench.workbench.post(RecordScripted{{}, "", true});
  CHECK_FALSE(bench.state().live);
  REQUIRE(bench.workbench.wait_idle(kPatience_s));
  CHECK(bench.state().path == first);
  CHECK_FALSE(bench.state().live);
  CHECK(bench.logged(Severity::kWarning));
  bench.record();
  CHECK(bench.state().project->demonstrations.size() == 1);
}

TEST_CASE("a project opens beside a film, and a model lands in the project it was learned from") {
  Bench bench;
  bench.record();
  const DemonstrationId id = bench.state().demonstration;
  learning::TrainOptions options;
  options.method = learning::Method::kExact;
  bench.workbench.post(ExportVideo{{id}, bench.folder / "film.mp4", 1280, 720, 60.0});
  bench.workbench.post(TrainModel{{id}, demonstration::Segment::kA, options, 22, "Mine"});
  bench.workbench.post(OpenProject{bench.folder / "second.trocar", true});
  while (bench.state().load == LoadState::kLoading) bench.workbench.poll();
  REQUIRE(bench.state().jobs.size() == 2);
  CHECK(bench.state().jobs.back().state == JobState::kRunning);
  bench.workbench.post(CancelJob{bench.state().jobs.back().id});
  REQUIRE(bench.workbench.wait_idle(kPatience_s));
  CHECK(bench.state().project->models.empty());
  bench.run(OpenProject{bench.folder / "p.trocar", false});
  REQUIRE(bench.state().project->models.size() == 1);
  CHECK(bench.state().history.back().description == "Add model Mine");
}

TEST_CASE("at the end of the program a recording is kept and a film leaves nothing behind") {
  Bench bench;
  bench.record();
  bench.workbench.post(ExportVideo{{bench.state().demonstration}, bench.folder / "film.mp4", 320, 180, 10.0});
  bench.workbench.post(RecordScripted{{}, "Short", true});
  while (!bench.state().live || bench.state().live->samples < 10) bench.workbench.poll();
  REQUIRE(bench.workbench.finish(kPatience_s));
  CHECK_FALSE(bench.state().live);
  CHECK(bench.state().project->demonstrations.size() == 2);
  CHECK(bench.state().jobs.front().state == JobState::kCancelled);
  CHECK_FALSE(std::filesystem::exists(bench.folder / "film.mp4"));
}

TEST_CASE("undo and redo say in the log what they did") {
  Bench bench;
  bench.record();
  bench.run(Undo{});
  CHECK(bench.state().log.back().text == "Undid: Add Expert 1");
  bench.run(Redo{});
  CHECK(bench.state().log.back().text == "Did again: Add Expert 1");
}

TEST_CASE("curves and a comparison follow the demonstration, its preview and its past") {
  Bench bench;
  bench.record();
  const DemonstrationId id = bench.state().demonstration;
  const std::int64_t recorded_at = bench.state().head;
  bench.run(ShowCurves{bit(CurveKind::kZ)});
  REQUIRE(bench.state().curves != nullptr);
  REQUIRE(bench.state().curves->curves.size() == 2);
  CHECK(bench.state().curves->find(CurveKind::kZ, 0)->before == nullptr);
  const double at_rest = bench.state().curves->find(CurveKind::kZ, 0)->now->y().front();

  const demonstration::Edit raise = demonstration::Offset{demonstration::Arms::kLeft, {0.0, 0.0, 0.005}};
  bench.run(PreviewEdit{raise, 0});
  CHECK(bench.state().curves->find(CurveKind::kZ, 0)->now->y().front() == doctest::Approx(at_rest + 5.0));
  CHECK(bench.state().curves->find(CurveKind::kZ, 0)->before->y().front() == at_rest);
  bench.run(EndPreview{});
  bench.run(CommitEdit{EditDemonstration{id, raise}});

  ComparisonSettings settings;
  settings.against = {Against::Kind::kHistory, {}, recorded_at};
  bench.run(CompareWith{settings});
  REQUIRE(bench.state().comparison != nullptr);
  REQUIRE(bench.state().comparison->comparison.has_value());
  CHECK(bench.state().comparison->comparison->deviation[0].mean_m == doctest::Approx(0.005).epsilon(1e-4));
  CHECK(bench.state().comparison->comparison->deviation[1].max_m == 0.0);
  bench.run(Undo{});
  CHECK(bench.state().comparison->comparison->both.max_m == 0.0);

  settings.against = {Against::Kind::kHistory, {}, 0};
  bench.run(CompareWith{settings});
  CHECK_FALSE(bench.state().comparison->comparison.has_value());
  CHECK_FALSE(bench.state().comparison->error.empty());
  bench.run(EndComparison{});
  CHECK(bench.state().comparison == nullptr);
}

namespace {

/// Polls until it is so; fails when that takes too long.
template <typename Condition>
void poll_until(Bench& bench, Condition condition) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(kPatience_s);
  while (!condition()) {
    REQUIRE(std::chrono::steady_clock::now() < end);
    bench.workbench.poll();
    std::this_thread::yield();
  }
}

RecordByHand left_arm_by_hand() {
  RecordByHand take;
  take.options.sources = {trial::ArmSource::kHand, trial::ArmSource::kStill};
  take.options.countdown_s = 0.0;
  return take;
}

void record_until_verdict(Bench& bench) {
  const auto& live = bench.state().live;
  poll_until(bench, [&] { return live && live->status.phase == trial::Phase::kRecording; });
  bench.workbench.post(HandInput{{trial::DriveTool{kinematics::ArmSide::kLeft, {0.0, 0.02, 0.0}, {0.0, 0.0, 0.0}}}});
  poll_until(bench, [&] { return live->samples > 60; });
  bench.workbench.post(HandInput{{trial::EndTake{}}});
  poll_until(bench, [&] { return bench.state().take && bench.state().take->reviewing; });
}

}  // namespace

TEST_CASE("a take by hand is driven live, waits for its verdict, is kept as a person's, and verifies") {
  Bench bench;
  bench.workbench.post(left_arm_by_hand());
  record_until_verdict(bench);
  CHECK_FALSE(bench.workbench.busy());
  CHECK(bench.state().project->demonstrations.empty());
  bench.workbench.post(JudgeTake{TakeVerdict::kKeep});
  poll_until(bench, [&] { return !bench.state().take; });
  REQUIRE(bench.state().project->demonstrations.size() == 1);
  const auto shown = bench.state().project->demonstrations.begin()->second;
  CHECK(bench.state().demonstration == shown->id);
  CHECK(shown->name == "By hand 1");
  CHECK(shown->recording->provenance.operator_kind == "person");
  CHECK(shown->recording->provenance.device == "keyboard and mouse; right arm still");
  const double moved_m = shown->samples.back().arms[0].setpoint_p[1] - shown->samples.front().arms[0].setpoint_p[1];
  CHECK(moved_m > 0.001);
  bench.run(VerifyReplay{shown->id});
  CHECK(bench.state().jobs.front().state == JobState::kDone);
}

TEST_CASE("nothing of the document is changed while a take goes on or waits for its verdict, and it is said why") {
  Bench bench;
  bench.record();
  const DemonstrationId id = bench.state().demonstration;
  bench.run(CommitEdit{CopyDemonstration{id, "Copy", {}}});
  const DemonstrationId copy = bench.state().project->demonstrations.rbegin()->first;
  REQUIRE(copy != id);
  bench.run(CommitEdit{RemoveDemonstration{copy}});
  bench.run(CommitEdit{SaveFilter{"long", "length>3"}});
  std::ofstream(bench.folder / "hand.csv")
      << "time_s,left_x_mm,left_y_mm,left_z_mm\n0,1,2,30\n0.1,2,2,30\n0.2,3,2,30\n";
  ImportSettings table;
  table.path = bench.folder / "hand.csv";
  bench.run(ReadImport{table});
  REQUIRE(bench.state().import);
  REQUIRE(bench.state().import->parts.size() == 1);
  bench.workbench.post(left_arm_by_hand());
  record_until_verdict(bench);
  const std::int64_t head = bench.state().head;
  const std::uint64_t hash = bench.state().project->hash();
  const std::size_t jobs = bench.state().jobs.size();
  const Edit offset = EditDemonstration{id, demonstration::Offset{demonstration::Arms::kLeft, {0.0, 0.0, 0.002}}};
  MarkChange mark;
  mark.flag = Flag::kBad;
  const Batch batch{"Flag", {MarkDemonstration{id, mark}}};
  for (const Command& asked : std::vector<Command>{
           CommitEdit{offset}, CommitEdit{EditDemonstration{id, demonstration::Trim{1.0, 2.0}}}, CommitEdit{batch},
           CommitEdit{SaveFilter{"short", "length<3"}}, CommitEdit{RemoveFilter{"long"}},
           CommitEdit{RemoveDemonstration{id}}, CommitEdit{RestoreDemonstration{copy}}, MakeImport{}, Undo{}, Redo{},
           GoToHistory{0}, FixProblems{id}}) {
    bench.workbench.post(asked);
    bench.workbench.poll();
    CHECK(bench.state().head == head);
    CHECK(bench.state().project->hash() == hash);
    CHECK(bench.state().log.back().text == "A transfer is being recorded");
  }
  CHECK(bench.state().jobs.size() == jobs);
  bench.workbench.post(JudgeTake{TakeVerdict::kDiscard});
  poll_until(bench, [&] { return !bench.state().take; });
  // What had been looked at can still be imported.
  bench.run(MakeImport{});
  CHECK(bench.state().project->demonstrations.size() == 2);
  bench.run(CommitEdit{offset});
  CHECK(bench.state().head != head);
}

TEST_CASE("a take that is made again leaves nothing, keep and next goes on, and leaving the program keeps the last") {
  Bench bench;
  bench.workbench.post(left_arm_by_hand());
  record_until_verdict(bench);
  bench.workbench.post(JudgeTake{TakeVerdict::kAgain});
  poll_until(bench, [&] { return bench.state().take && !bench.state().take->reviewing; });
  CHECK(bench.state().project->demonstrations.empty());
  record_until_verdict(bench);
  bench.workbench.post(JudgeTake{TakeVerdict::kKeepAndNext});
  poll_until(bench, [&] { return bench.state().take && !bench.state().take->reviewing; });
  CHECK(bench.state().project->demonstrations.size() == 1);
  CHECK(bench.state().take->request.options.seed == 2);
  record_until_verdict(bench);
  CHECK(bench.workbench.finish(kPatience_s));
  CHECK(bench.state().project->demonstrations.size() == 2);
}
