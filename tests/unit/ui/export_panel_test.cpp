// The panel Export: a film put together from its sources, looked at, kept as a job, queued, held and given up.
#include <doctest/doctest.h>

#include <algorithm>

#include "tests/support/scratch_folder.h"
#include "tests/support/ui_desk.h"
#include "ui/command_text.h"
#include "ui/film_text.h"
#include "ui/panels/export_queue.h"
#include "ui/widgets/lint.h"

namespace trocar::ui {
namespace {

using workbench::JobState;
using workbench::JobView;

/// The window in the workspace Export; what is said of the film is so, as the workbench would have it.
struct ExportDesk : Desk {
  explicit ExportDesk(workbench::WorkbenchState of, float scale = 1.0F) : Desk(std::move(of), scale) {
    state.path = folder / "pegs.trocar";
    CHECK(driver().key("Ctrl+6"));
    settle();
    CHECK(text_of(driver().click("Tabs/Export")) == "");
    settle();
  }
  void settle() {
    for (int i = 0; i < 3; ++i) {
      CHECK(driver().frames(2));
      for (; taken < commands.size(); ++taken) {
        if (const auto* film = std::get_if<workbench::SetFilm>(&commands[taken])) state.film = film->draft;
      }
    }
  }
  void click(const std::string& path) {
    CHECK(text_of(driver().click(path)) == "");
    settle();
  }
  void type(const std::string& path, const std::string& words) {
    CHECK(text_of(driver().type(path, words)) == "");
    settle();
  }
  std::string reason(const std::string& path) {
    const Result<Item> item = driver().item(path);
    return item ? item->reason : "there is no " + path;
  }
  std::string value(const std::string& path) {
    const Result<Item> item = driver().item(path);
    return item ? item->value : "there is no " + path;
  }

  testing::ScratchFolder folder;
  std::size_t taken = 0;  ///< Of the commands.
};

JobView film_of(std::int64_t id, const char* path, JobState of) {
  JobView job;
  job.id = {id};
  job.title = "Film";
  job.film = path;
  job.state = of;
  return job;
}

}  // namespace

TEST_CASE("sources are added, chosen and removed, and the layout follows") {
  ExportDesk desk(testing::made_state_with_model());
  desk.click("Export/Page/File");
  CHECK(desk.reason("Export/File/Add to queue").find("Add a source") == 0);
  desk.click("Export/Page/Sources");
  desk.click("Export/Sources/Add/Add source");
  desk.click("Export/Sources/Add/Kind/Field");
  desk.click("Export/Sources/Add/Add source");
  desk.click("Export/Sources/Add/Kind/Curve");
  desk.click("Export/Sources/Add/Add source");
  const film::Composition& film = desk.state.film.film;
  REQUIRE(film.sources.size() == 3);
  CHECK(film.sources[0].kind == film::SourceKind::kRecording);
  CHECK(film.sources[1].kind == film::SourceKind::kField);
  CHECK(film.sources[2].kind == film::SourceKind::kCurve);
  CHECK(film.layout == film::Layout::kTwoByTwo);
  CHECK(film.path == (desk.folder / "film.mp4").string());
  CHECK(desk.state.film.source == 2);
  desk.click("Export/Sources/Chosen/Remove source");
  CHECK(desk.state.film.film.layout == film::Layout::kSideBySide);
  CHECK(desk.value("Export/Sources/List/exact A") == "field, value, z=11");
  desk.click("Export/Sources/List/exact A");
  desk.type("Export/Sources/Chosen/Slice", "x=9");
  CHECK(desk.state.film.film.sources[1].slice == "x=9");
}

TEST_CASE("a key of the camera is taken from the 3-D view at the instant of the film, and removed") {
  ExportDesk desk(testing::made_state_with_model());
  CHECK(desk.reason("Export/Sources/Chosen/Add key from view").find("there is no") == 0);
  desk.click("Export/Sources/Add/Add source");
  desk.state.orbit.azimuth_rad = 1.25;
  desk.click("Export/Sources/Chosen/Add key from view");
  desk.state.film.at_s = 2.0;
  desk.state.orbit.azimuth_rad = 0.25;
  CHECK(desk.driver().key("Ctrl+Shift+K"));
  desk.settle();
  const auto& keys = desk.state.film.film.sources[0].camera.keys;
  REQUIRE(keys.size() == 2);
  CHECK(keys[1].t_s == 2.0);
  CHECK(keys[1].eye_m[0] == desk.state.orbit.camera().X_WC.p.x());
  CHECK(desk.value("Export/Sources/Chosen/Keys/2.00 s").starts_with("from "));
  desk.click("Export/Sources/Chosen/Keys/0.00 s/Remove key");
  REQUIRE(desk.state.film.film.sources[0].camera.keys.size() == 1);
  CHECK(desk.state.film.film.sources[0].camera.keys[0].t_s == 2.0);
  CHECK_FALSE(desk.reason("Export/Sources/Chosen/Keys/2.00 s/Remove key").empty());
}

TEST_CASE("the look of a film is chosen, by a preset at once, and what is wrong with it is said") {
  ExportDesk desk(testing::made_state_with_model());
  desk.click("Export/Sources/Add/Add source");
  desk.click("Export/Sources/Add/Add source");
  desk.click("Export/Page/Look");
  desk.click("Export/Look/Preset");
  desk.click("Preset/mt-vs-sc");
  CHECK(desk.state.film.film.pace.sync == film::Sync::kSegment);
  CHECK(desk.state.film.film.overlays.has(film::Overlay::kCaptions));
  CHECK(desk.state.film.film.sources.size() == 2);
  desk.click("Export/Look/Overlays/Trail");
  desk.click("Export/Look/Overlays/Colour bar");
  CHECK(desk.state.film.film.overlays.has(film::Overlay::kTrail));
  CHECK_FALSE(desk.state.film.film.overlays.has(film::Overlay::kColourBar));
  desk.click("Export/Look/Speed/4×");
  CHECK(desk.state.film.film.pace.speed == 4.0);
  CHECK(film_reason(desk.state).empty());
  desk.click("Export/Look/Layout/Single");
  CHECK(film_reason(desk.state).find("the layout single shows 1") != std::string::npos);
  desk.click("Export/Page/File");
  CHECK(desk.reason("Export/File/Add to queue") == film_reason(desk.state));
}

TEST_CASE("a film is queued as it is, and its command line is words or its job") {
  ExportDesk desk(testing::made_state_with_model());
  desk.click("Export/Sources/Add/Add source");
  desk.click("Export/Page/File");
  desk.type("Export/File/Width", "640");
  desk.type("Export/File/Height", "360");
  desk.click("Export/File/Codec/FFV1");
  CHECK(desk.state.film.film.path == (desk.folder / "film.mkv").string());
  desk.click("Export/File/Add to queue");
  const auto* render = desk.last<workbench::RenderFilm>();
  REQUIRE(render != nullptr);
  CHECK(render->film == desk.state.film.film);
  CHECK(render->film.width == 640);
  const std::string words = command_text(*render, desk.state);
  CHECK(words.find(" 1 --out ") != std::string::npos);
  CHECK(words.find("--size 640x360 --fps 30 --layout single --codec ffv1") != std::string::npos);
  // What words do not say, a job does.
  desk.state.film.film.sources[0].title = "Mine";
  CHECK(command_text(workbench::RenderFilm{desk.state.film.film}, desk.state).empty());
  desk.state.film_file = workbench::FilmFile{"job.json", desk.state.film.film};
  CHECK(command_text(workbench::RenderFilm{desk.state.film.film}, desk.state).ends_with("pegs.trocar job.json"));

  desk.click("Export/Page/File");
  desk.type("Export/File/Job", (desk.folder / "film.json").string());
  desk.click("Export/File/Save job");
  REQUIRE(desk.last<workbench::SaveFilmJob>() != nullptr);
  desk.click("Export/File/Open job");
  REQUIRE(desk.last<workbench::OpenFilmJob>() != nullptr);
  CHECK(desk.last<workbench::OpenFilmJob>()->path == desk.folder / "film.json");
}

TEST_CASE("a picture is asked for once for each film and instant, and again when the document is another") {
  ExportDesk desk(testing::made_state_with_model());
  const auto asked = [&desk] {
    return std::count_if(desk.commands.begin(), desk.commands.end(), [](const workbench::Command& command) {
      return std::holds_alternative<workbench::PreviewFilm>(command);
    });
  };
  CHECK(asked() == 0);
  desk.click("Export/Sources/Add/Add source");
  CHECK(asked() == 1);
  desk.state.film.film.path = "another.mp4";
  CHECK(desk.driver().frames(2));
  CHECK(asked() == 1);
  desk.state.film.at_s = 1.0;
  CHECK(desk.driver().frames(2));
  CHECK(asked() == 2);
  desk.state.project = std::make_shared<workbench::Project>(*desk.state.project);
  CHECK(desk.driver().frames(2));
  CHECK(asked() == 3);
}

TEST_CASE("the queue says of each film how far it is, and holds, goes on and gives up") {
  workbench::WorkbenchState state = testing::made_state_with_model();
  JobView running = film_of(8, "/data/pair.mp4", JobState::kRunning);
  running.fraction = 0.5;
  running.done = 600;
  running.of = 1200;
  running.left_s = 64.2;
  state.jobs = {film_of(9, "/data/next.mp4", JobState::kQueued), running,
                film_of(7, "/data/done.mp4", JobState::kDone)};
  ExportDesk desk(state);
  desk.click("Export/Page/Queue");
  CHECK(desk.value("Export/Queue/pair.mp4") == "frame 600 of 1,200, 50 %, 1:05 left");
  CHECK(desk.value("Export/Queue/done.mp4") == "in /data/done.mp4");
  CHECK(desk.reason("Export/Queue/next.mp4/Pause") == "It has not begun");
  desk.click("Export/Queue/pair.mp4/Pause");
  REQUIRE(desk.last<workbench::PauseJob>() != nullptr);
  CHECK(desk.last<workbench::PauseJob>()->id == workbench::JobId{8});
  CHECK(desk.last<workbench::PauseJob>()->paused);
  desk.state.jobs[1].paused = true;
  desk.settle();
  CHECK(desk.value("Export/Queue/pair.mp4") == "frame 600 of 1,200, 50 %, paused");
  desk.click("Export/Queue/pair.mp4/Go on");
  CHECK_FALSE(desk.last<workbench::PauseJob>()->paused);
  desk.click("Export/Queue/next.mp4/Cancel");
  CHECK(desk.last<workbench::CancelJob>()->id == workbench::JobId{9});
  JobView begun = film_of(1, "a.mp4", JobState::kRunning);
  CHECK(film_progress_words(begun) == "begins, 0 %, – left");
}

TEST_CASE("each page of Export is whole, named and large enough at every scale") {
  for (const float scale : {0.75F, 1.0F, 2.0F, 3.0F}) {
    CAPTURE(scale);
    workbench::WorkbenchState state = testing::made_state_with_model();
    state.jobs = {film_of(9, "/data/next.mp4", JobState::kQueued), film_of(8, "/data/pair.mp4", JobState::kRunning)};
    ExportDesk desk(state, scale);
    desk.click("Export/Sources/Add/Add source");
    desk.click("Export/Sources/Chosen/Add key from view");
    for (const char* page : {"Sources", "Look", "File", "Queue"}) {
      CAPTURE(page);
      desk.click(std::string("Export/Page/") + page);
      std::string words;
      for (const LintFinding& finding : lint(desk.session->items().items(), scale)) {
        words += finding.path + " " + finding.what + "; ";
      }
      CHECK(words == "");
    }
  }
}

TEST_CASE("a film of one trial is queued for all of its session") {
  workbench::WorkbenchState made = testing::made_state_with_model();
  auto project = std::make_shared<workbench::Project>(*made.project);
  for (const std::int64_t id : {71, 72, 73}) {
    auto trial = std::make_shared<workbench::TrialEntry>();
    trial->id = {id};
    trial->name = "MT " + std::to_string(id);
    trial->record.session = id == 73 ? "other" : "this one";
    trial->shown = project->demonstrations.begin()->second;
    project->trials[trial->id] = trial;
  }
  made.project = project;
  ExportDesk desk(made);
  desk.click("Export/Sources/Add/Add source");
  desk.click("Export/Page/File");
  CHECK(desk.reason("Export/File/Add all of its session").find("one trial") != std::string::npos);
  desk.state.film.film.sources[0].of = "MT 71";
  desk.settle();
  desk.click("Export/File/Add all of its session");
  std::vector<std::string> files;
  for (const workbench::Command& command : desk.commands) {
    const auto* render = std::get_if<workbench::RenderFilm>(&command);
    if (render != nullptr) files.push_back(std::filesystem::path(render->film.path).filename().string());
  }
  CHECK(files == std::vector<std::string>{"film_MT_71.mp4", "film_MT_72.mp4"});
}

}  // namespace trocar::ui
