// What encoding costs: one 1280 × 720 frame handed to the encoder, which works in its own thread.
#include <benchmark/benchmark.h>
#include <unistd.h>

#include <filesystem>

#include "engine/media/video_writer.h"

namespace {

using namespace trocar;

Image frame(int number) {
  Image image(1280, 720);
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const bool inside = (x - 8 * number % 1000) * (x - 8 * number % 1000) + (y - 360) * (y - 360) < 14400;
      image.set(x, y,
                inside ? Rgba{220, 170, 60, 255}
                       : Rgba{static_cast<std::uint8_t>(x / 6), static_cast<std::uint8_t>(y / 4), 80, 255});
    }
  }
  return image;
}

void video_frame(benchmark::State& state) {
  const std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("trocar_bench_" + std::to_string(::getpid()) + ".mp4");
  std::vector<Image> frames;
  for (int i = 0; i < 16; ++i) frames.push_back(frame(i));
  auto writer = media::VideoWriter::open(path, {1280, 720, 30.0, media::Codec::kAuto});
  if (!writer) {
    state.SkipWithError(writer.error().text().c_str());
    return;
  }
  std::size_t next = 0;
  for (auto _ : state) {
    if (!writer->add(frames[next++ % frames.size()])) state.SkipWithError("the frame was refused");
  }
  state.counters["frames_per_s"] =
      benchmark::Counter(static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
  const Status finished = writer->finish();
  if (!finished) state.SkipWithError(finished.error().text().c_str());
  std::error_code ignored;
  std::filesystem::remove(path, ignored);
}
BENCHMARK(video_frame)->Name("video_encode_1280x720")->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
