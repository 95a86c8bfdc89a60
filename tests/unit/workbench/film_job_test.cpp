// Films as they come out: decoded, counted, and looked at where their overlays are.
#include "engine/workbench/jobs/film_job.h"

#include <doctest/doctest.h>

#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <thread>

#include "engine/core/file.h"
#include "engine/film/property.h"
#include "engine/learning/model.h"
#include "engine/media/picture_file.h"
#include "engine/media/video_writer.h"
#include "engine/plot/colour_map.h"
#include "engine/workbench/jobs/film_renderer.h"
#include "engine/workbench/jobs/film_sink.h"
#include "engine/workbench/studio.h"
#include "tests/support/document_samples.h"
#include "tests/support/lattice_demonstrations.h"
#include "tests/support/scratch_folder.h"

using namespace trocar;
using namespace trocar::workbench;
using demonstration::Authority;
using demonstration::Segment;
using film::Overlay;
using trocar::testing::ScratchFolder;

namespace {

/// A recording whose segments last so many samples of 5 ms each; the agent moves in A and C.
std::shared_ptr<const demonstration::Demonstration> recorded(std::int64_t id, const std::string& name,
                                                             const std::array<int, 5>& lasts,
                                                             const std::string& kind = "scripted") {
  auto recording = std::make_shared<demonstration::Recording>();
  recording->provenance.operator_kind = kind;
  recording->provenance.software = "trocar";
  int index = 0;
  for (int segment = 0; segment < demonstration::kSegmentCount; ++segment) {
    for (int i = 0; i < lasts[static_cast<std::size_t>(segment)]; ++i, ++index) {
      demonstration::Sample sample = trocar::testing::moving_sample(index);
      // Jaws down, as the arms can have them: else nothing would be seen to move.
      for (demonstration::ArmSample& arm : sample.arms) arm.measured.q_wxyz = {0.0F, 1.0F, 0.0F, 0.0F};
      sample.segment = static_cast<Segment>(segment);
      sample.authority = segment == 0 || segment == 2 ? Authority::kAgent : Authority::kOperator;
      if (segment == 4) sample.authority = Authority::kAssistant;
      if (segment > 0 && segment < 4) sample.flags |= demonstration::kLeftHolds;
      recording->samples.push_back(sample);
    }
  }
  auto made = demonstration::make_demonstration({id}, name, recording);
  REQUIRE(made);
  return std::make_shared<const demonstration::Demonstration>(std::move(*made));
}

/// "Long" lasts 5 s, "Short" 2.5 s, "Hand" was made by a person.
std::shared_ptr<const Project> project() {
  auto made = std::make_shared<Project>();
  made->demonstrations[{1}] = recorded(1, "Long", {200, 200, 200, 200, 200});
  made->demonstrations[{2}] = recorded(2, "Short", {100, 60, 240, 60, 40});
  made->demonstrations[{3}] = recorded(3, "Hand", {60, 60, 60, 60, 60}, "person");
  return made;
}

film::Composition small(const std::vector<std::string>& sources) {
  film::Composition film;
  film.width = 640;
  film.height = 360;
  film.fps = 10.0;
  for (const std::string& of : sources) film.sources.push_back(film::recording_of(of));
  film.layout = sources.size() == 2 ? film::Layout::kSideBySide : film::Layout::kSingle;
  return film;
}

FilmReport rendered(const film::Composition& film, const std::filesystem::path& path) {
  Progress progress;
  const auto report = render_film({film, project(), path}, progress);
  REQUIRE_MESSAGE(report, (report ? "" : report.error().text()));
  return *report;
}

/// Frames by their numbers; all without them.
std::vector<Image> frames_of(const film::Composition& film, const Project& of, std::vector<int> numbers = {}) {
  Diagnostics diagnostics;
  auto renderer = FilmRenderer::create(film, of, diagnostics);
  REQUIRE_MESSAGE(renderer, (renderer ? "" : renderer.error().text()));
  auto studio = Studio::create();
  REQUIRE(studio);
  const bool all = numbers.empty();
  for (int i = 0; all && i < renderer->frame_count(); ++i) numbers.push_back(i);
  std::vector<Image> frames;
  for (const int number : numbers) frames.push_back(renderer->frame(*studio, number).value());
  return frames;
}

std::vector<Image> frames_of(const film::Composition& film) {
  return frames_of(film, *project());
}

Image frame_of(const film::Composition& film, int number) {
  return frames_of(film, *project(), {number}).front();
}

/// The ground of the authority band in a cell, in its right end, where no letters are.
Rgba authority_at(const Image& frame, const film::Cell& cell) {
  const film::Band band = film::band_for(film::Overlays::usual(), cell.width, cell.height);
  const double unit = film::unit_of(band, cell.width, cell.height);
  const int top = cell.y + cell.height - film::band_height_of(band, cell.width, cell.height);
  return frame.at(cell.x + static_cast<int>((film::kMargin + 170.0) * unit), top + static_cast<int>(34.0 * unit));
}

/// With the model "A exact", 9, of a descent from the cell 4,4,14 to 9,8,9.
std::shared_ptr<const Project> project_with_model() {
  auto with_model = std::make_shared<Project>(*project());
  auto entry = std::make_shared<ModelEntry>();
  entry->id = {9};
  entry->name = "A exact";
  entry->demonstrations = {{1}};
  learning::TrainOptions options;
  options.method = learning::Method::kExact;
  Progress progress;
  const spatial::Grid grid;
  auto model = learning::train(grid, {trocar::testing::approach_from_above(grid, {4, 4, 14}, {9, 8, 9}, 3, 1)}, options,
                               progress);
  REQUIRE_MESSAGE(model, (model ? "" : model.error().text()));
  entry->model = std::make_shared<const learning::Model>(std::move(*model));
  with_model->models[entry->id] = entry;
  return with_model;
}

std::vector<Image> frames_with_model(const film::Composition& film, const std::vector<int>& numbers) {
  return frames_of(film, *project_with_model(), numbers);
}

/// How many pixels differ.
std::size_t changed_pixels(const Image& a, const Image& b) {
  REQUIRE(a.rgba.size() == b.rgba.size());
  std::size_t changed = 0;
  for (std::size_t i = 0; i < a.rgba.size(); i += 4) {
    changed +=
        std::equal(a.rgba.begin() + static_cast<std::ptrdiff_t>(i), a.rgba.begin() + static_cast<std::ptrdiff_t>(i + 4),
                   b.rgba.begin() + static_cast<std::ptrdiff_t>(i))
            ? 0
            : 1;
  }
  return changed;
}

std::ptrdiff_t files_in(const std::filesystem::path& folder) {
  return std::distance(std::filesystem::directory_iterator(folder), std::filesystem::directory_iterator{});
}

}  // namespace

TEST_CASE("the film that was written has the frames that it should, and a reader finds nothing wrong") {
  const ScratchFolder folder;
  const FilmReport report = rendered(small({"Long"}), folder / "film.mp4");
  CHECK(report.frames == 50);
  CHECK(report.subtitles.empty());
  CHECK(report.web_subtitles.empty());
  const auto info = media::probe_video(folder / "film.mp4");
  REQUIRE(info);
  CHECK(info->frames == 50);
  CHECK(info->width == 640);
  CHECK(info->fps == doctest::Approx(10.0));
  CHECK(files_in(folder.path()) == 1);
  if (std::system("command -v ffprobe > /dev/null") != 0) return;
  const std::string errors = (folder / "errors").string();
  const std::string probe = "ffprobe -v warning -count_frames -show_entries stream=nb_read_frames -of csv=p=0 '" +
                            (folder / "film.mp4").string() + "' > '" + (folder / "count").string() + "' 2> '" + errors +
                            "'";
  CHECK(std::system(probe.c_str()) == 0);
  std::stringstream count;
  count << std::ifstream(folder / "count").rdbuf();
  CHECK(std::stoi(count.str()) == 50);
  CHECK(std::filesystem::file_size(errors) == 0);
}

TEST_CASE("the same job twice gives the same frames, in whatever order they are asked for") {
  const film::Composition film = small({"Short", "Long"});
  const ScratchFolder folder;
  film::Composition pictures = film;
  rendered(pictures, folder / "a_%03d.png");
  const std::vector<Image> again = frames_of(film);
  for (const int number : {0, 17, 49}) {
    char name[16];
    std::snprintf(name, sizeof name, "a_%03d.png", number);
    const auto read = media::read_picture(folder / name);
    REQUIRE(read);
    CHECK(*read == again[static_cast<std::size_t>(number)]);
    CHECK(frame_of(film, number) == again[static_cast<std::size_t>(number)]);
  }
  CHECK(files_in(folder.path()) == static_cast<std::ptrdiff_t>(again.size()));
  rendered(film, folder / "one.mp4");
  rendered(film, folder / "two.mp4");
  for (const int number : {3, 30}) {
    CHECK(media::read_video_frame(folder / "one.mp4", number).value() ==
          media::read_video_frame(folder / "two.mp4", number).value());
  }
}

TEST_CASE("the authority band has the colour of who moves the tool") {
  const std::vector<Image> frames = frames_of(small({"Long"}));
  const film::Cell whole{0, 0, 640, 360};
  CHECK(authority_at(frames[5], whole) == plot::category(4));   // A: the agent.
  CHECK(authority_at(frames[15], whole) == plot::category(0));  // B: the operator.
  CHECK(authority_at(frames[25], whole) == plot::category(4));
  CHECK(authority_at(frames[45], whole) == plot::category(2));  // E: the assistant.
}

TEST_CASE("synchronised by segment, both sides come to each segment in the same frame, and the faster one waits") {
  film::Composition film = small({"Short", "Long"});
  film.pace.sync = film::Sync::kSegment;
  const std::vector<Image> frames = frames_of(film);
  // The longer ones: 1, 1, 1.2, 1 and 1 s.
  CHECK(frames.size() == doctest::Approx(52).epsilon(0.03));
  const std::vector<film::Cell> cells = film::cells_of(film, 640, 360);
  int changes = 0;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    CAPTURE(i);
    CHECK(authority_at(frames[i], cells[0]) == authority_at(frames[i], cells[1]));
    if (i > 0 && !(authority_at(frames[i], cells[0]) == authority_at(frames[i - 1], cells[0]))) ++changes;
  }
  CHECK(changes == 4);
  // "Short" comes to the end of A after half a second: what is seen of it stands still until the other is there.
  const auto left = [&](std::size_t frame) {
    Image half(320, 180);
    for (int y = 0; y < 180; ++y) {
      for (int x = 0; x < 318; ++x) half.set(x, y, frames[frame].at(x, y));
    }
    return half;
  };
  CHECK(left(7) == left(9));
  CHECK_FALSE(left(2) == left(4));
  film.pace.sync = film::Sync::kClock;
  CHECK(frames_of(film).size() == 50);
}

TEST_CASE("by grasp, both grippers close in the same frame") {
  film::Composition film = small({"Short", "Long"});
  film.pace.sync = film::Sync::kGrasp;
  Diagnostics diagnostics;
  const auto renderer = FilmRenderer::create(film, *project(), diagnostics);
  REQUIRE(renderer);
  CHECK(renderer->map().stage_begin_s(1) == doctest::Approx(1.0));
  const film::Moment moment = renderer->map().at(10);
  CHECK(moment.sources[0].at_s == doctest::Approx(0.5));
  CHECK(moment.sources[1].at_s == doctest::Approx(1.0));
}

TEST_CASE("captions are in the file beside the film, in order, and only if they are asked for") {
  const ScratchFolder folder;
  film::Composition film = small({"Short", "Long"});
  film.pace.sync = film::Sync::kSegment;
  film.overlays.set(Overlay::kCaptions);
  const FilmReport report = rendered(film, folder / "film.mp4");
  CHECK(report.subtitles == folder / "film.srt");
  CHECK(report.web_subtitles == folder / "film.vtt");
  CHECK(read_file(report.web_subtitles).value().starts_with("WEBVTT\n\n00:00:00.000 --> "));
  std::ifstream file(report.subtitles);
  std::string line;
  int number = 0;
  long before_ms = 0;
  std::string words;
  while (std::getline(file, line)) {
    REQUIRE(std::stoi(line) == ++number);
    REQUIRE(std::getline(file, line));
    std::array<int, 8> t{};
    REQUIRE(std::sscanf(line.c_str(), "%d:%d:%d,%d --> %d:%d:%d,%d", &t[0], &t[1], &t[2], &t[3], &t[4], &t[5], &t[6],
                        &t[7]) == 8);
    const long from_ms = ((t[0] * 60L + t[1]) * 60 + t[2]) * 1000 + t[3];
    const long to_ms = ((t[4] * 60L + t[5]) * 60 + t[6]) * 1000 + t[7];
    CHECK(from_ms >= before_ms);
    CHECK(to_ms > from_ms);
    before_ms = to_ms;
    int lines = 0;
    while (std::getline(file, line) && !line.empty()) {
      words += line + "\n";
      ++lines;
    }
    CHECK(lines == 2);
  }
  CHECK(number >= 5);
  CHECK(before_ms <= report.frames * 100L);
  CHECK(words.find("Short: A: approach (waiting)") != std::string::npos);
  CHECK(words.find("Long: E: place on the goal peg") != std::string::npos);
}

TEST_CASE("cancelled in the middle, a film leaves nothing, neither a row of pictures nor subtitles") {
  film::Composition film = small({"Long"});
  film.width = 320;
  film.height = 180;
  film.fps = 50.0;
  film.overlays.set(Overlay::kCaptions);
  for (const char* name : {"film.mp4", "film.gif", "f_%04d.png"}) {
    const ScratchFolder folder;
    Progress progress;
    std::jthread other([&progress] {
      while (progress.fraction() < 0.5) std::this_thread::sleep_for(std::chrono::milliseconds(1));
      progress.cancel();
    });
    const auto report = render_film({film, project(), folder / name}, progress);
    REQUIRE_FALSE(report);
    CHECK(report.error().code() == ErrorCode::kCancelled);
    CHECK(progress.fraction() >= 0.5);
    CHECK(files_in(folder.path()) == 0);
  }
}

TEST_CASE("an odd size becomes even, with a warning") {
  const ScratchFolder folder;
  film::Composition film = small({"Hand"});
  film.width = 161;
  film.height = 91;
  const FilmReport report = rendered(film, folder / "film.mp4");
  CHECK(report.width == 162);
  CHECK(report.height == 92);
  REQUIRE_FALSE(report.warnings.empty());
  CHECK(report.warnings.front().find("161×91 became 162×92") != std::string::npos);
  CHECK(media::probe_video(folder / "film.mp4").value().width == 162);
}

TEST_CASE("what a script made says so, also in a film without any overlay") {
  film::Composition scripted = small({"Long"});
  scripted.overlays = {};
  film::Composition by_hand = small({"Hand"});
  by_hand.overlays = {};
  // The letters are the only lit ones in the corner.
  const auto lit = [](const Image& frame) {
    int count = 0;
    for (int y = 10; y < 60; ++y) {
      for (int x = 10; x < 140; ++x) {
        const Rgba c = frame.at(x, y);
        if (c.r > 200 && c.g > 190 && c.b < 110) ++count;
      }
    }
    return count;
  };
  CHECK(lit(frame_of(scripted, 3)) > 30);
  CHECK(lit(frame_of(by_hand, 3)) == 0);
}

TEST_CASE("each overlay changes the picture, and leaves the others where they are") {
  film::Composition film = small({"Long", "Short"});
  film.pace.speed = 2.0;
  const Image plain = frame_of(film, 20);
  for (const Overlay overlay :
       {Overlay::kTitle, Overlay::kTimer, Overlay::kSegment, Overlay::kAuthority, Overlay::kPedals, Overlay::kJaws,
        Overlay::kMetrics, Overlay::kScaleBar, Overlay::kTrail, Overlay::kGhost, Overlay::kCaptions,
        Overlay::kProvenance, Overlay::kSpeed}) {
    CAPTURE(static_cast<int>(overlay));
    film::Composition other = film;
    other.overlays.set(overlay, !film.overlays.has(overlay));
    CHECK_FALSE(frame_of(other, 20) == plain);
  }
}

TEST_CASE("cameras move as they are told") {
  film::Composition film = small({"Long"});
  film.overlays = {};
  const Image paper = frame_of(film, 10);
  film.sources[0].camera.view = film::View::kTurntable;
  CHECK_FALSE(frame_of(film, 0) == frame_of(film, 10));
  film.sources[0].camera.view = film::View::kFollow;
  CHECK_FALSE(frame_of(film, 10) == paper);
  film.sources[0].camera.view = film::View::kOrbit;
  const Image still = frame_of(film, 10);
  film.sources[0].tracks = {{"orbit.yaw", {{0.0, 0.5, film::Ease::kSmooth}, {2.0, 1.5}}}};
  CHECK_FALSE(frame_of(film, 10) == still);
  film.sources[0].tracks.clear();
  film.sources[0].camera.view = film::View::kPoses;
  film.sources[0].camera.keys = {{0.0, {0.1, 0.0, 0.1}, {0, 0, 0}}, {2.0, {0.0, 0.1, 0.1}, {0, 0, 0}}};
  CHECK_FALSE(frame_of(film, 0) == frame_of(film, 10));
}

TEST_CASE("fields and curves stand beside the scene, and a picture lies in another") {
  const std::shared_ptr<const Project> with_model = project_with_model();
  film::Composition film = small({"Long", "Long", "Long"});
  film.layout = film::Layout::kTwoByTwo;
  film.sources[1].kind = film::SourceKind::kCurve;
  film.sources[2].kind = film::SourceKind::kField;
  film.sources[2].of = "A exact";
  film.sources[2].slice = "z=9";
  film.sources[2].tracks = {{"slice", {{0.0, 9.0}, {2.0, 12.0}}}};
  CHECK(needs_models(film));
  Diagnostics diagnostics;
  auto renderer = FilmRenderer::create(film, *with_model, diagnostics);
  REQUIRE_MESSAGE(renderer, (renderer ? "" : renderer.error().text()));
  auto studio = Studio::create();
  REQUIRE(studio);
  const Image first = renderer->frame(*studio, 0).value();
  const Image later = renderer->frame(*studio, 20).value();
  CHECK(first.at(640 - 4, 90) == Rgba{255, 255, 255, 255});  // The curve's paper.
  CHECK(first.at(4, 270) == Rgba{255, 255, 255, 255});       // The field's.
  const auto changed = [&](int x0, int y0) {
    for (int y = y0; y < y0 + 170; ++y) {
      for (int x = x0; x < x0 + 310; ++x) {
        if (!(first.at(x, y) == later.at(x, y))) return true;
      }
    }
    return false;
  };
  CHECK(changed(325, 5));
  CHECK(changed(5, 185));
  CHECK_FALSE(changed(325, 185));  // Nobody is in the fourth.

  film.layout = film::Layout::kPictureInPicture;
  film.sources.resize(2);
  const Image inside = frame_of(film, 0);
  const film::Cell inset = film::cells_of(film, 640, 360)[1];
  CHECK(inside.at(inset.x + inset.width - 4, inset.y + inset.height / 2) == Rgba{255, 255, 255, 255});
  CHECK_FALSE(inside.at(inset.x + inset.width + 8, inset.y + inset.height / 2) == Rgba{255, 255, 255, 255});
}

TEST_CASE("a rollout is filmed in the simulator, with its field in the scene and how it ended") {
  film::Composition film = small({"A exact"});
  film.sources[0].kind = film::SourceKind::kRollout;
  CHECK(needs_models(film));
  Diagnostics diagnostics;
  RolloutShelf shelf;
  auto renderer = FilmRenderer::create(film, *project_with_model(), diagnostics, &shelf);
  REQUIRE_MESSAGE(renderer, (renderer ? "" : renderer.error().text()));
  REQUIRE(renderer->spans_s().size() == 1);
  CHECK(renderer->spans_s()[0][1] > 1.0);
  auto studio = Studio::create();
  REQUIRE(studio);
  const Image begins = renderer->frame(*studio, 0).value();
  const Image ends = renderer->frame(*studio, renderer->frame_count() - 1).value();
  CHECK(changed_pixels(begins, ends) > 500);
  // Taken from the shelf it is the same film.
  auto again = FilmRenderer::create(film, *project_with_model(), diagnostics, &shelf);
  REQUIRE(again);
  CHECK(again->frame(*studio, 0).value() == begins);

  film.sources[0].field = film::SceneField{"9", "value", "z=9"};
  const Image with_field = frames_with_model(film, {0})[0];
  CHECK(changed_pixels(begins, with_field) > 2000);
  film.sources[0].start = {5, 5, 14};
  CHECK(changed_pixels(frames_with_model(film, {0})[0], with_field) > 200);
  film.sources[0].start = {5, 5, 99};
  CHECK_FALSE(FilmRenderer::create(film, *project_with_model(), diagnostics));
  film.sources[0].start.reset();
  film.sources[0].field->layer = "colour";
  CHECK_FALSE(FilmRenderer::create(film, *project_with_model(), diagnostics));
}

TEST_CASE("a film that is given up before its first frame runs no rollout") {
  film::Composition film = small({"A exact"});
  film.sources[0].kind = film::SourceKind::kRollout;
  Progress progress;
  progress.cancel();
  RolloutShelf shelf(progress);
  const auto sources = film_sources(*project_with_model(), film, shelf);
  REQUIRE_FALSE(sources);
  CHECK(sources.error().code() == ErrorCode::kCancelled);
  const trocar::testing::ScratchFolder folder;
  const auto report = render_film({film, project_with_model(), folder.path() / "a.mp4"}, progress);
  REQUIRE_FALSE(report);
  CHECK(report.error().code() == ErrorCode::kCancelled);
  CHECK(std::filesystem::is_empty(folder.path()));
}

TEST_CASE("two models have rollouts of their own on one shelf, and the film says whose they are by their hashes") {
  auto both = std::make_shared<Project>(*project_with_model());
  auto other = std::make_shared<ModelEntry>(*both->models.at({9}));
  other->id = {10};
  other->name = "Another";
  learning::TrainOptions options;
  options.method = learning::Method::kExact;
  Progress progress;
  const spatial::Grid grid;
  auto model = learning::train(grid, {trocar::testing::approach_from_above(grid, {4, 4, 14}, {12, 12, 10}, 3, 1)},
                               options, progress);
  REQUIRE_MESSAGE(model, (model ? "" : model.error().text()));
  other->model = std::make_shared<const learning::Model>(std::move(*model));
  both->models[other->id] = other;
  film::Composition film = small({"A exact", "Another", "Hand"});
  film.layout = film::Layout::kTwoByTwo;
  film.sources[0].kind = film::SourceKind::kRollout;
  film.sources[1].kind = film::SourceKind::kRollout;
  film.sources[2].field = film::SceneField{"A exact"};
  RolloutShelf shelf;
  const auto sources = film_sources(*both, film, shelf);
  REQUIRE_MESSAGE(sources, (sources ? "" : sources.error().text()));
  CHECK((*sources)[0].shown != (*sources)[1].shown);
  CHECK((*sources)[0].out_s != (*sources)[1].out_s);
  CHECK((*sources)[1].title.find("Another from") == 0);
  for (const FilmSource& source : *sources) {
    CHECK(source.provenance.find("0000000000000000") == std::string::npos);
    // The person's recording too: what is seen in its scene was learned from a script.
    CHECK(source.scripted);
  }
}

TEST_CASE("a slice that moves is called what it is, and its colours stand where no inset lies") {
  film::Composition film = small({"Long", "Short"});
  film.layout = film::Layout::kPictureInPicture;
  film.sources[0].field = film::SceneField{"A exact", "value", "z=9"};
  film.overlays = {};
  film.overlays.set(Overlay::kColourBar);
  for (const film::Corner corner : {film::Corner::kTopRight, film::Corner::kTopLeft, film::Corner::kBottomLeft}) {
    film.corner = corner;
    film::Composition without = film;
    without.overlays = {};
    const Image with_key = frames_with_model(film, {0})[0];
    CHECK(changed_pixels(with_key, frames_with_model(without, {0})[0]) > 300);
  }
  // Beyond the lattice it is the last one: label and picture alike.
  film.sources[0].tracks = {{"slice", {{0.0, 300.0}}}};
  film::Composition last = film;
  last.sources[0].tracks = {{"slice", {{0.0, 21.0}}}};
  CHECK(frames_with_model(film, {0})[0] == frames_with_model(last, {0})[0]);
}

TEST_CASE("whatever number of a source has keys, what is seen changes with it") {
  film::Composition film = small({"Long", "Short"});
  film.pace.holds = {{2.0, 3.0}};
  film.overlays.set(Overlay::kTrail);
  film.overlays.set(Overlay::kGhost);
  film::Source& source = film.sources[0];
  source.camera.view = film::View::kOrbit;
  source.field = film::SceneField{"A exact", "value", "z=9"};
  // In the hold nothing moves but what the keys move.
  const std::vector<int> held{21, 49};
  const std::vector<Image> still = frames_with_model(film, held);
  CHECK(still[0] == still[1]);
  for (const film::Property& property : film::all_source_properties()) {
    CAPTURE(property.name);
    film::Composition moving = film;
    const double from = property.name == "slice" ? 5.0 : film::fixed_value(source, property.name);
    const double to = property.name == "slice" ? 12.0 : property.name == "zoom" ? 2.0 : from > 0.05 ? 0.1 * from : 0.5;
    film::set_keys(moving.sources[0], property.name, {{2.1, from}, {4.9, to}});
    const std::vector<Image> frames = frames_with_model(moving, held);
    // Of the trail little: the tool is slow.
    CHECK(changed_pixels(frames[0], frames[1]) > 10);
  }
}

TEST_CASE("a film can come from black, and an inset can grow") {
  film::Composition film = small({"Long", "Short"});
  film.layout = film::Layout::kPictureInPicture;
  film.overlays = {};
  film.sources[0].tracks = {{"brightness", {{0.0, 0.0}, {1.0, 1.0}}}};
  film.sources[1].tracks = film.sources[0].tracks;
  const std::vector<Image> fade = frames_with_model(film, {0, 20});
  CHECK(fade[0].at(20, 20) == Rgba{0, 0, 0, 255});
  CHECK_FALSE(fade[1].at(20, 20) == Rgba{0, 0, 0, 255});
  for (film::Source& each : film.sources) each.tracks.clear();
  film.share_keys = {{0.0, 0.2}, {2.0, 0.5}};
  film::Composition fixed = film;
  fixed.share_keys.clear();
  fixed.share = 0.5;
  const std::vector<Image> grown = frames_with_model(film, {20, 0, 20});
  CHECK(grown[0] == frames_with_model(fixed, {20})[0]);
  CHECK(grown[0] == grown[2]);
  fixed.share = 0.2;
  CHECK(grown[1] == frames_with_model(fixed, {0})[0]);
}

TEST_CASE("keys that change nothing are told") {
  film::Composition film = small({"Long"});
  film.sources[0].tracks = {{"slice", {{0.0, 3.0}}}};
  Diagnostics diagnostics;
  REQUIRE(FilmRenderer::create(film, *project(), diagnostics));
  REQUIRE(diagnostics.warnings().size() == 1);
  CHECK(diagnostics.warnings()[0].find("slice") != std::string::npos);
}

TEST_CASE("what is not there, and what leaves nothing, is refused before a file is made") {
  const ScratchFolder folder;
  Progress progress;
  const auto refused = [&](const film::Composition& film) {
    const auto report = render_film({film, project(), folder / "film.mp4"}, progress);
    return !report && files_in(folder.path()) == 0;
  };
  CHECK(refused(small({"Nobody"})));
  film::Composition film = small({"Long"});
  film.sources[0].in_s = 80.0;
  CHECK(refused(film));
  film = small({"Long"});
  film.sources[0].kind = film::SourceKind::kCurve;
  film.sources[0].curve = "clearance";
  CHECK(refused(film));
  film = small({"Long"});
  film.codec = "paint";
  CHECK(refused(film));
}
