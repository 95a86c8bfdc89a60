#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <set>

#include "engine/core/file.h"
#include "engine/media/palette.h"
#include "engine/media/video_writer.h"
#include "tests/support/scratch_folder.h"

using namespace trocar;
using namespace trocar::media;
using trocar::testing::ScratchFolder;

namespace {

/// A smooth ground of many colours, a square that moves over it, and a mark that comes only later.
Image frame(int number) {
  Image image(160, 96);
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      image.set(x, y, {static_cast<std::uint8_t>(x), static_cast<std::uint8_t>(2 * y), 90, 255});
      const int from = 5 * number % 140;
      if (x >= from && x < from + 16 && y >= 20 && y < 36) image.set(x, y, {230, 200, 40, 255});
      if (number >= 6 && x < 10 && y > 80) image.set(x, y, {255, 0, 255, 255});
    }
  }
  return image;
}

std::filesystem::path written(const ScratchFolder& folder, double fps, int frames) {
  const std::filesystem::path path = folder / "a.gif";
  auto writer = VideoWriter::open(path, {160, 96, fps, Codec::kAuto}).value();
  CHECK(writer.codec() == Codec::kGif);
  for (int i = 0; i < frames; ++i) REQUIRE(writer.add(frame(i)));
  REQUIRE(writer.finish());
  return path;
}

/// The delays of all frames: what follows the four bytes that begin a graphic control.
std::vector<int> delays_cs(const std::string& gif) {
  constexpr std::string_view kControl("\x21\xF9\x04", 3);
  std::vector<int> out;
  for (std::size_t at = gif.find(kControl); at != std::string::npos; at = gif.find(kControl, at + 1)) {
    if (at + 8 > gif.size() || gif[at + 7] != 0) continue;
    out.push_back(static_cast<unsigned char>(gif[at + 4]) + 256 * static_cast<unsigned char>(gif[at + 5]));
  }
  return out;
}

}  // namespace

TEST_CASE("each frame of a GIF looks like its picture, with colours that come late and over what stays") {
  const ScratchFolder folder;
  const std::filesystem::path path = written(folder, 25.0, 12);
  for (const int k : {0, 5, 6, 11}) {
    CAPTURE(k);
    const Image shown = read_video_frame(path, k).value();
    CHECK(difference(shown, frame(k)).mean < 3.0);
    // What is of one colour keeps it: colours are means, not the middles of boxes.
    const ImageDifference mark = difference(Image(1, 1, shown.at(5 * k + 8, 28)), Image(1, 1, {230, 200, 40, 255}));
    CHECK(mark.worst <= 1);
    if (k >= 6) CHECK(shown.at(4, 90) == Rgba{255, 0, 255, 255});
  }
}

TEST_CASE("a GIF loops for ever and is as long as the film, also at a rate that hundredths do not divide") {
  const ScratchFolder folder;
  for (const double fps : {1.0, 7.0, 12.5, 29.97, 30.0, 50.0}) {
    CAPTURE(fps);
    const std::filesystem::path path = written(folder, fps, 40);
    const std::string bytes = read_file(path).value();
    CHECK(bytes.starts_with("GIF89a"));
    CHECK(bytes.find(std::string("NETSCAPE2.0\x03\x01\x00\x00\x00", 16)) != std::string::npos);
    const std::vector<int> delays = delays_cs(bytes);
    REQUIRE(delays.size() == 40);
    int length_cs = 0;
    for (const int delay : delays) {
      CHECK(std::abs(delay - 100.0 / fps) < 1.0);
      length_cs += delay;
    }
    CHECK(std::abs(length_cs - 100.0 * 40 / fps) <= 0.5);
    CHECK(probe_video(path).value().frames == 40);
  }
}

TEST_CASE("more frames a second than players show are refused before a file is made") {
  const ScratchFolder folder;
  const auto writer = VideoWriter::open(folder / "a.gif", {160, 96, 60.0, Codec::kAuto});
  REQUIRE_FALSE(writer);
  CHECK(writer.error().code() == ErrorCode::kInvalidArgument);
  CHECK(writer.error().text() == "a GIF has at most 50 frames a second, not 60");
  CHECK(std::filesystem::is_empty(folder.path()));
}

TEST_CASE("what does not move costs next to nothing") {
  const ScratchFolder folder;
  const std::filesystem::path path = folder / "still.gif";
  auto writer = VideoWriter::open(path, {160, 96, 10.0, Codec::kAuto}).value();
  for (int i = 0; i < 2; ++i) REQUIRE(writer.add(frame(0)));
  REQUIRE(writer.finish());
  const auto two_bytes = std::filesystem::file_size(path);
  auto longer = VideoWriter::open(path, {160, 96, 10.0, Codec::kAuto}).value();
  for (int i = 0; i < 102; ++i) REQUIRE(longer.add(frame(0)));
  REQUIRE(longer.finish());
  CHECK(probe_video(path).value().frames == 102);
  CHECK(std::filesystem::file_size(path) - two_bytes < 100 * 40);
  CHECK(read_video_frame(path, 101).value() == read_video_frame(path, 0).value());
}

TEST_CASE("the same frames give the same bytes") {
  const ScratchFolder folder;
  const std::string first = read_file(written(folder, 30.0, 8)).value();
  CHECK(read_file(written(folder, 30.0, 8)).value() == first);
}

TEST_CASE("a palette has no more colours than asked for, and each pixel's is near") {
  std::vector<Rgba> pixels;
  for (int i = 0; i < 4096; ++i) {
    pixels.push_back({static_cast<std::uint8_t>(i % 16 * 17), static_cast<std::uint8_t>(i / 16 % 16 * 17),
                      static_cast<std::uint8_t>(i / 256 * 17), 255});
  }
  for (const std::size_t most : {std::size_t{1}, std::size_t{2}, std::size_t{255}}) {
    CAPTURE(most);
    const Palette palette = palette_of(pixels, most);
    CHECK(palette.colours.size() == most);
    REQUIRE(palette.indices.size() == pixels.size());
    CHECK(std::set<int>(palette.indices.begin(), palette.indices.end()).size() == most);
    if (most < 255) continue;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
      const Rgba got = palette.colours[palette.indices[i]];
      // 255 boxes of a cube 256 wide are about 40 wide.
      const std::array<int, 3> apart{got.r - pixels[i].r, got.g - pixels[i].g, got.b - pixels[i].b};
      CHECK(std::all_of(apart.begin(), apart.end(), [](int a) { return std::abs(a) <= 40; }));
    }
  }
}

TEST_CASE("few colours stay what they are, and no pixels need none") {
  const std::vector<Rgba> pixels{{1, 2, 3, 255}, {250, 128, 7, 255}, {1, 2, 3, 255}};
  const Palette palette = palette_of(pixels, 255);
  REQUIRE(palette.colours.size() == 2);
  for (std::size_t i = 0; i < pixels.size(); ++i) CHECK(palette.colours[palette.indices[i]] == pixels[i]);
  CHECK(palette_of({}, 255).colours.empty());
}
