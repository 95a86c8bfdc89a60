// The film that is being made: its sources with their layout, keys from the view, and the frame that is shown of it.
#include "engine/workbench/film_draft.h"

#include <doctest/doctest.h>

#include <thread>

#include "engine/workbench/film_preview_maker.h"
#include "engine/workbench/jobs/film_camera.h"
#include "engine/workbench/jobs/film_job.h"
#include "tests/support/document_samples.h"
#include "tests/support/scratch_folder.h"

using namespace trocar;
using namespace trocar::workbench;

namespace {

FilmDraft draft_of(int sources) {
  FilmDraft draft;
  for (int i = 0; i < sources; ++i) draft = with_source(std::move(draft), film::recording_of("1"));
  return draft;
}

std::shared_ptr<const Project> short_project() {
  auto recording = std::make_shared<demonstration::Recording>();
  recording->provenance.operator_kind = "scripted";
  for (int i = 0; i < 200; ++i) {
    demonstration::Sample sample = trocar::testing::moving_sample(i);
    for (demonstration::ArmSample& arm : sample.arms) arm.measured.q_wxyz = {0.0F, 1.0F, 0.0F, 0.0F};
    recording->samples.push_back(sample);
  }
  auto made = demonstration::make_demonstration({1}, "Short one", recording);
  REQUIRE(made);
  auto project = std::make_shared<Project>();
  project->demonstrations[{1}] = std::make_shared<const demonstration::Demonstration>(std::move(*made));
  return project;
}

film::Composition tiny_film() {
  film::Composition film;
  film.width = 160;
  film.height = 90;
  film.fps = 10.0;
  film.sources = {film::recording_of("1")};
  return film;
}

}  // namespace

TEST_CASE("the layout has room for the sources that there are, and the chosen one is one of them") {
  FilmDraft draft = draft_of(1);
  CHECK(draft.film.layout == film::Layout::kSingle);
  draft = with_source(std::move(draft), film::recording_of("2"));
  CHECK(draft.film.layout == film::Layout::kSideBySide);
  CHECK(draft.source == 1);
  draft.film.layout = film::Layout::kTopBottom;
  draft = with_source(std::move(draft), film::recording_of("3"));
  CHECK(draft.film.layout == film::Layout::kTwoByTwo);
  draft = without_source(std::move(draft));
  CHECK(draft.source == 1);
  CHECK(draft.film.sources.back().of == "2");
  for (int sources = 1; sources <= 9; ++sources) CHECK(film::check(draft_of(sources).film));
  CHECK(without_source(draft_of(1)).film.sources.empty());
}

TEST_CASE("a key from the view lies in order, replaces one of the same frame, and the film looks from there") {
  FilmDraft draft = draft_of(1);
  scene::OrbitCamera view;
  for (const double at_s : {2.0, 0.0, 1.0}) {
    draft.at_s = at_s;
    view.azimuth_rad = at_s;
    draft = with_key(std::move(draft), view);
  }
  const film::CameraPath& path = draft.film.sources[0].camera;
  REQUIRE(path.keys.size() == 3);
  CHECK(path.view == film::View::kPoses);
  CHECK(film::check(draft.film));
  for (int i = 0; i < 3; ++i) CHECK(path.keys[static_cast<std::size_t>(i)].t_s == i);
  view.azimuth_rad = 1.0;
  const auto camera = film_camera(draft.film.sources[0], 1.0, Eigen::Vector3d::Zero(), 1280, 720);
  CHECK((camera.X_WC.p - view.camera().X_WC.p).norm() < 1e-12);
  CHECK(camera.X_WC.q.angularDistance(view.camera().X_WC.q) < 1e-9);

  draft.at_s = 1.01;
  view.azimuth_rad = -1.0;
  draft = with_key(std::move(draft), view);
  REQUIRE(draft.film.sources[0].camera.keys.size() == 3);
  CHECK(draft.film.sources[0].camera.keys[1].t_s == 1.01);
}

TEST_CASE("what is shown of a film before it is rendered are the film's own pixels") {
  const auto project = short_project();
  FilmPreviewRequest request{tiny_film(), 0.42, project};
  FilmPreviewMaker maker;
  const auto first = maker.make(request);
  REQUIRE_MESSAGE(first->picture, first->error);
  CHECK(first->frame == 4);
  CHECK(first->length_s == doctest::Approx((first->frames - 1) / 10.0));
  request.at_s = 1e9;
  const auto last = maker.make(request);
  REQUIRE(last->picture);
  CHECK(last->frame == last->frames - 1);
  CHECK(last->number != first->number);
  CHECK(last->picture->rgba != first->picture->rgba);
  request.film.sources[0].of = "nobody";
  const auto none = maker.make(request);
  CHECK(none->picture == nullptr);
  CHECK(none->error.find("nobody") != std::string::npos);
  request.film.sources[0].of = "1";
  CHECK(maker.make(request)->picture->rgba == last->picture->rgba);

  // A renderer of its own, as the film's job has one.
  Diagnostics diagnostics;
  auto renderer = FilmRenderer::create(tiny_film(), *project, diagnostics);
  auto studio = Studio::create();
  REQUIRE(renderer);
  REQUIRE(studio);
  CHECK(renderer->frame(*studio, 4)->rgba == first->picture->rgba);
}

TEST_CASE("a film that is paused is cancelled from there, and leaves no file") {
  const trocar::testing::ScratchFolder folder;
  Progress progress;
  progress.pause(true);
  std::jthread other([&progress] { progress.cancel(); });
  const auto report = render_film({tiny_film(), short_project(), folder / "film.mp4"}, progress);
  REQUIRE_FALSE(report);
  CHECK(report.error().code() == ErrorCode::kCancelled);
  CHECK(std::filesystem::is_empty(folder.path()));
}

TEST_CASE("a pause leaves no trace in a film") {
  const trocar::testing::ScratchFolder folder;
  Progress progress;
  std::jthread other([&progress] {
    while (progress.done() < 3) std::this_thread::yield();
    progress.pause(true);
    progress.pause(false);
  });
  const auto report = render_film({tiny_film(), short_project(), folder / "film.mp4"}, progress);
  REQUIRE(report);
  CHECK(progress.done() == report->frames);
  CHECK(progress.of() == report->frames);
}
