// What a whole film costs: each frame staged, rendered, captioned and encoded, as `trocar video render` does it.
#include <benchmark/benchmark.h>
#include <unistd.h>

#include <filesystem>
#include <memory>

#include "engine/demonstration/demonstration.h"
#include "engine/media/video_writer.h"
#include "engine/trial/transfer_session.h"
#include "engine/workbench/jobs/film_renderer.h"

namespace {

using namespace trocar;

/// Ten seconds of a scripted transfer.
std::shared_ptr<const demonstration::Demonstration> short_demonstration() {
  auto session = trial::TransferSession::create({});
  if (!session) return nullptr;
  auto recording = std::make_shared<demonstration::Recording>();
  recording->provenance = session->provenance();
  while (!session->done() && session->state().tick.seconds() < 10.0) session->step();
  recording->samples = session->take_samples();
  auto made = demonstration::make_demonstration({1}, "Expert 1", recording);
  return made ? std::make_shared<const demonstration::Demonstration>(std::move(*made)) : nullptr;
}

void film_frame(benchmark::State& state) {
  const std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("trocar_film_bench_" + std::to_string(::getpid()) + ".mp4");
  const auto shown = short_demonstration();
  auto studio = workbench::Studio::create();
  auto writer = media::VideoWriter::open(path, {1280, 720, 30.0, media::Codec::kAuto});
  workbench::Project project;
  if (shown) project.demonstrations[shown->id] = shown;
  film::Composition film;
  film.sources.push_back(film::recording_of("1"));
  Diagnostics diagnostics;
  auto renderer = workbench::FilmRenderer::create(film, project, diagnostics);
  if (!shown || !studio || !writer || !renderer) {
    state.SkipWithError("the demonstration, the renderer or the encoder could not be had");
    return;
  }
  int number = 0;
  for (auto _ : state) {
    auto frame = renderer->frame(*studio, number++ % renderer->frame_count());
    if (!frame || !writer->add(std::move(*frame))) state.SkipWithError("a frame could not be made");
  }
  if (!writer->finish()) state.SkipWithError("the film could not be finished");
  state.counters["frames_per_s"] =
      benchmark::Counter(static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
  std::error_code ignored;
  std::filesystem::remove(path, ignored);
}
// Long enough that the encoder's queue is full and the slower of the two threads sets the pace.
BENCHMARK(film_frame)->Name("video_frame_1280x720")->Unit(benchmark::kMillisecond)->UseRealTime()->MinTime(6.0);

}  // namespace
