#include <doctest/doctest.h>
#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>

#include "engine/core/file.h"
#include "engine/media/video_writer.h"

using namespace trocar;
using namespace trocar::media;
namespace fs = std::filesystem;

namespace {

/// A folder that is gone at the end of the test.
struct Scratch {
  fs::path folder;
  explicit Scratch(const char* name) {
    folder = fs::temp_directory_path() / ("trocar_video_" + std::string(name) + std::to_string(::getpid()));
    fs::remove_all(folder);
    fs::create_directories(folder);
  }
  ~Scratch() { fs::remove_all(folder); }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  std::ptrdiff_t files() const { return std::distance(fs::directory_iterator(folder), fs::directory_iterator{}); }
};

/// A bright square that moves right by eight pixels a frame, on a ramp.
Image frame(int width, int height, int number) {
  Image image(width, height, {30, 60, 90, 255});
  for (int y = height / 4; y < height / 2; ++y) {
    for (int x = 8 * number % (width - 16); x < 8 * number % (width - 16) + 16; ++x) {
      image.set(x, y, {230, 200, 40, 255});
    }
  }
  return image;
}

/// Texture that compresses badly, so that a file grows.
Image noise(int width, int height, std::uint32_t seed) {
  Image image(width, height);
  for (std::size_t i = 0; i < image.rgba.size(); ++i) {
    seed = seed * 1664525U + 1013904223U;
    image.rgba[i] = i % 4 == 3 ? 255 : static_cast<std::uint8_t>(seed >> 24U);
  }
  return image;
}

Status write_film(const fs::path& path, const VideoOptions& options, int frames, const VideoDetails& details = {}) {
  TROCAR_ASSIGN_OR_RETURN(VideoWriter writer, VideoWriter::open(path, options, details));
  for (int i = 0; i < frames; ++i) TROCAR_RETURN_IF_ERROR(writer.add(frame(options.width, options.height, i)));
  return writer.finish();
}

}  // namespace

TEST_CASE("every codec of this machine writes a film of the right size, rate and number of frames") {
  const Scratch scratch("codecs");
  const std::vector<Codec> codecs = available_codecs();
  REQUIRE(std::find(codecs.begin(), codecs.end(), Codec::kH264) != codecs.end());
  for (const Codec codec : codecs) {
    CAPTURE(to_string(codec));
    const fs::path path = scratch.folder / (std::string(to_string(codec)) + std::string(usual_ending(codec)));
    const Status written = write_film(path, {160, 96, 25.0, codec}, 40);
    REQUIRE_MESSAGE(written, (written ? "" : written.error().text()));
    const VideoInfo info = probe_video(path).value();
    CHECK(info.width == 160);
    CHECK(info.height == 96);
    CHECK(info.fps == doctest::Approx(25.0).epsilon(1e-3));
    CHECK(info.frames == 40);
  }
  CHECK(scratch.files() == static_cast<std::ptrdiff_t>(codecs.size()));
}

TEST_CASE("H.264 is the default of an MP4, and its frames look like the pictures they came from") {
  const Scratch scratch("auto");
  const fs::path path = scratch.folder / "a.mp4";
  auto writer = VideoWriter::open(path, {320, 180, 30.0, Codec::kAuto}).value();
  CHECK(writer.codec() == Codec::kH264);
  for (int i = 0; i < 30; ++i) REQUIRE(writer.add(frame(320, 180, i)));
  REQUIRE(writer.finish());
  for (const int k : {0, 13, 29}) {
    const ImageDifference apart = difference(read_video_frame(path, k).value(), frame(320, 180, k));
    CAPTURE(k);
    CHECK(apart.mean < 6.0);
  }
  // The neighbour is a different picture: frames are in order, none twice.
  CHECK(difference(read_video_frame(path, 13).value(), read_video_frame(path, 14).value()).mean > 0.2);
}

TEST_CASE("a WebM is VP9, and its frames look like the pictures they came from") {
  const Scratch scratch("webm");
  const fs::path path = scratch.folder / "a.webm";
  auto writer = VideoWriter::open(path, {320, 180, 30.0, Codec::kAuto}).value();
  CHECK(writer.codec() == Codec::kVp9);
  for (int i = 0; i < 20; ++i) REQUIRE(writer.add(frame(320, 180, i)));
  REQUIRE(writer.finish());
  for (const int k : {0, 13, 19}) CHECK(difference(read_video_frame(path, k).value(), frame(320, 180, k)).mean < 6.0);
}

TEST_CASE("FFV1 gives back the very picture, whatever is in it") {
  const Scratch scratch("ffv1");
  for (const char* name : {"a.mkv", "a.avi"}) {
    const fs::path path = scratch.folder / name;
    auto writer = VideoWriter::open(path, {64, 48, 30.0, Codec::kFfv1}).value();
    for (int i = 0; i < 5; ++i) REQUIRE(writer.add(noise(64, 48, static_cast<std::uint32_t>(i))));
    REQUIRE(writer.finish());
    for (int i = 0; i < 5; ++i) {
      CHECK(read_video_frame(path, i).value() == noise(64, 48, static_cast<std::uint32_t>(i)));
    }
  }
}

TEST_CASE("colours come back as they were, from every codec that players take") {
  const Scratch scratch("colours");
  for (const Codec codec : {Codec::kH264, Codec::kMpeg4, Codec::kMotionJpeg, Codec::kVp9, Codec::kAv1}) {
    CAPTURE(to_string(codec));
    const fs::path path = scratch.folder / (std::string(to_string(codec)) + std::string(usual_ending(codec)));
    for (const Rgba colour : {Rgba{230, 60, 40, 255}, Rgba{40, 160, 90, 255}, Rgba{30, 60, 200, 255}}) {
      const Image flat(128, 96, colour);
      auto writer = VideoWriter::open(path, {128, 96, 30.0, codec}).value();
      for (int i = 0; i < 3; ++i) REQUIRE(writer.add(flat));
      REQUIRE(writer.finish());
      CHECK(difference(read_video_frame(path, 1).value(), flat).mean < 3.0);
    }
  }
}

TEST_CASE("the same frames give the same file, in every codec") {
  const Scratch scratch("twice");
  for (const Codec codec : available_codecs()) {
    CAPTURE(to_string(codec));
    const std::string ending(usual_ending(codec));
    REQUIRE(write_film(scratch.folder / ("a" + ending), {160, 96, 30.0, codec}, 40));
    REQUIRE(write_film(scratch.folder / ("b" + ending), {160, 96, 30.0, codec}, 40));
    CHECK(read_file(scratch.folder / ("a" + ending)).value() == read_file(scratch.folder / ("b" + ending)).value());
  }
}

TEST_CASE("a larger crf makes a smaller file that looks worse") {
  const Scratch scratch("crf");
  for (const Codec codec : {Codec::kH264, Codec::kVp9, Codec::kAv1}) {
    CAPTURE(to_string(codec));
    std::vector<std::uintmax_t> sizes;
    std::vector<double> errors;
    for (const std::optional<int> crf :
         {std::optional(Crf::kLeast), std::optional<int>(), std::optional(crf_of(codec).most)}) {
      const fs::path path = scratch.folder / ("a" + std::string(usual_ending(codec)));
      auto writer = VideoWriter::open(path, {160, 96, 30.0, codec}, {crf, "", ""}).value();
      for (int i = 0; i < 8; ++i) REQUIRE(writer.add(noise(160, 96, static_cast<std::uint32_t>(i))));
      REQUIRE(writer.finish());
      sizes.push_back(fs::file_size(path));
      errors.push_back(difference(read_video_frame(path, 4).value(), noise(160, 96, 4)).mean);
    }
    CHECK(std::is_sorted(sizes.rbegin(), sizes.rend()));
    CHECK(errors.front() < errors.back());
  }
  const auto beyond = VideoWriter::open(scratch.folder / "b.mp4", {160, 96, 30.0, Codec::kAuto}, {52, "", ""});
  REQUIRE_FALSE(beyond);
  CHECK(beyond.error().text() == "the crf of h264 is 1 to 51, not 52");
  const auto without = VideoWriter::open(scratch.folder / "b.mkv", {160, 96, 30.0, Codec::kFfv1}, {20, "", ""});
  REQUIRE_FALSE(without);
  CHECK(without.error().text() == "a film in ffv1 has no crf");
}

TEST_CASE("a film's title and comment are in the file, for whoever reads it") {
  if (std::system("command -v ffprobe >/dev/null 2>&1") != 0) return;
  const Scratch scratch("tags");
  for (const char* name : {"a.mp4", "a.mov", "a.mkv", "a.webm"}) {
    CAPTURE(name);
    const fs::path path = scratch.folder / name;
    REQUIRE(write_film(path, {160, 96, 30.0, Codec::kAuto}, 5, {{}, "MT ‖ SC", "model 0123abcd"}));
    const fs::path said = scratch.folder / "said";
    const std::string command = "ffprobe -v warning -of default=nw=1 -show_entries format_tags=title,comment '" +
                                path.string() + "' >'" + said.string() + "' 2>&1";
    REQUIRE(std::system(command.c_str()) == 0);
    const std::string tags = read_file(said).value();
    CHECK(tags.find("itle=MT ‖ SC\n") != std::string::npos);
    CHECK(tags.find("model 0123abcd\n") != std::string::npos);
  }
}

TEST_CASE("odd, empty and huge sizes, and rates that are no rate, are refused before a file is made") {
  const Scratch scratch("sizes");
  const fs::path path = scratch.folder / "a.mp4";
  for (const VideoOptions& options :
       {VideoOptions{161, 96, 30.0, Codec::kAuto}, VideoOptions{160, 97, 30.0, Codec::kAuto},
        VideoOptions{0, 0, 30.0, Codec::kAuto}, VideoOptions{20000, 96, 30.0, Codec::kAuto},
        VideoOptions{160, 96, 0.0, Codec::kAuto}, VideoOptions{160, 96, std::nan(""), Codec::kAuto}}) {
    const auto writer = VideoWriter::open(path, options);
    REQUIRE_FALSE(writer);
    CHECK(writer.error().code() == ErrorCode::kInvalidArgument);
  }
  CHECK(scratch.files() == 0);
}

TEST_CASE("an extension that does not fit the codec is refused and the fitting ones are named") {
  const auto wrong = VideoWriter::open("/tmp/a.mp4", {160, 96, 30.0, Codec::kFfv1});
  REQUIRE_FALSE(wrong);
  CHECK(wrong.error().code() == ErrorCode::kInvalidArgument);
  CHECK(wrong.error().text().find(".mkv") != std::string::npos);
  const auto unknown = VideoWriter::open("/tmp/a.txt", {160, 96, 30.0, Codec::kAuto});
  REQUIRE_FALSE(unknown);
  CHECK(unknown.error().text() == "a film's name ends in .mp4, .mov, .mkv, .avi, .webm or .gif: /tmp/a.txt");
  CHECK_FALSE(VideoWriter::open("/tmp/a.mp4", {160, 96, 30.0, Codec::kVp9}));
  CHECK_FALSE(VideoWriter::open("/tmp/a.webm", {160, 96, 30.0, Codec::kH264}));
  CHECK_FALSE(VideoWriter::open("/tmp/a", {160, 96, 30.0, Codec::kAuto}));
}

TEST_CASE("a film that its codec cannot have says what it can") {
  const auto large = VideoWriter::open("/tmp/a.avi", {8192, 64, 30.0, Codec::kMpeg4});
  REQUIRE_FALSE(large);
  CHECK(large.error().text() == "a film in mpeg4 is at most 8190 pixels wide and high, not 8192 × 64");
  const auto small = VideoWriter::open("/tmp/a.mkv", {128, 48, 30.0, Codec::kAv1});
  REQUIRE_FALSE(small);
  CHECK(small.error().text() == "a film in av1 is at least 64 pixels wide and high, not 128 × 48");
}

TEST_CASE("a frame of another size is refused and the film goes on") {
  const Scratch scratch("frame");
  auto writer = VideoWriter::open(scratch.folder / "a.mp4", {160, 96, 30.0, Codec::kAuto}).value();
  const Status wrong = writer.add(frame(160, 98, 0));
  REQUIRE_FALSE(wrong);
  CHECK(wrong.error().code() == ErrorCode::kInvalidArgument);
  REQUIRE(writer.add(frame(160, 96, 0)));
  REQUIRE(writer.finish());
  CHECK(probe_video(scratch.folder / "a.mp4").value().frames == 1);
}

TEST_CASE("a path that cannot be written is an I/O error that ends with the path") {
  const auto writer = VideoWriter::open("/nowhere/at/all.mp4", {160, 96, 30.0, Codec::kAuto});
  REQUIRE_FALSE(writer);
  CHECK(writer.error().code() == ErrorCode::kIo);
  CHECK(writer.error().text().ends_with(": /nowhere/at/all.mp4"));
  const Scratch scratch("folder");
  fs::create_directory(scratch.folder / "b.mp4");
  CHECK_FALSE(VideoWriter::open(scratch.folder / "b.mp4", {160, 96, 30.0, Codec::kAuto}));
  CHECK(scratch.files() == 1);
}

TEST_CASE("a film goes to the end of a link, which stays a link") {
  const Scratch scratch("link");
  fs::create_symlink("target.mp4", scratch.folder / "a.mp4");
  auto writer = VideoWriter::open(scratch.folder / "a.mp4", {160, 96, 30.0, Codec::kAuto}).value();
  for (int i = 0; i < 5; ++i) REQUIRE(writer.add(frame(160, 96, i)));
  REQUIRE(writer.finish());
  CHECK(fs::is_symlink(scratch.folder / "a.mp4"));
  CHECK(probe_video(scratch.folder / "target.mp4").value().frames == 5);
}

TEST_CASE("a film that is not finished leaves nothing, and the old file as it was") {
  for (const char* name : {"a.mp4", "a.webm", "a.gif"}) {
    CAPTURE(name);
    const Scratch scratch("cancel");
    const fs::path path = scratch.folder / name;
    REQUIRE(write_file(path, "what was there"));
    {
      auto writer = VideoWriter::open(path, {160, 96, 30.0, Codec::kAuto}).value();
      for (int i = 0; i < 20; ++i) REQUIRE(writer.add(frame(160, 96, i)));
      CHECK(scratch.files() == 2);
    }
    CHECK(scratch.files() == 1);
    CHECK(read_file(path).value() == "what was there");
  }
}

TEST_CASE("a film without frames is an error and no file") {
  const Scratch scratch("none");
  auto writer = VideoWriter::open(scratch.folder / "a.mp4", {160, 96, 30.0, Codec::kAuto}).value();
  CHECK_FALSE(writer.finish());
  CHECK(scratch.files() == 0);
}

TEST_CASE("a disk that fills up is an I/O error and leaves nothing") {
  const Scratch scratch("full");
  rlimit before{};
  ::getrlimit(RLIMIT_FSIZE, &before);
  // A limit on the size of files gives the same failing writes as a full disk.
  const auto old_handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit limit{30000, before.rlim_max};
  for (const char* name : {"a.mp4", "a.mkv", "a.avi", "a.webm", "a.gif"}) {
    CAPTURE(name);
    auto writer = VideoWriter::open(scratch.folder / name, {160, 96, 30.0, Codec::kAuto}).value();
    ::setrlimit(RLIMIT_FSIZE, &limit);
    Status status;
    for (int i = 0; i < 60 && status; ++i) status = writer.add(noise(160, 96, static_cast<std::uint32_t>(i)));
    if (status) status = writer.finish();
    ::setrlimit(RLIMIT_FSIZE, &before);
    REQUIRE_FALSE(status);
    CHECK(status.error().code() == ErrorCode::kIo);
  }
  std::signal(SIGXFSZ, old_handler);
  CHECK(scratch.files() == 0);
}

TEST_CASE("what is no film says so") {
  const Scratch scratch("nofilm");
  REQUIRE(write_file(scratch.folder / "a.mp4", "this is not a film"));
  CHECK(probe_video(scratch.folder / "a.mp4").error().code() == ErrorCode::kCorrupt);
  CHECK(probe_video(scratch.folder / "b.mp4").error().code() == ErrorCode::kIo);
  REQUIRE(write_film(scratch.folder / "c.mp4", {64, 48, 30.0, Codec::kAuto}, 3));
  CHECK(read_video_frame(scratch.folder / "c.mp4", 3).error().code() == ErrorCode::kNotFound);
}

TEST_CASE("libraries write nothing to standard error") {
  const Scratch scratch("silent");
  REQUIRE(write_file(scratch.folder / "a.mp4", "this is not a film"));
  const fs::path said = scratch.folder / "said";
  const int before = ::dup(STDERR_FILENO);
  const int file = ::open(said.c_str(), O_WRONLY | O_CREAT, 0666);
  ::dup2(file, STDERR_FILENO);
  const bool film = probe_video(scratch.folder / "a.mp4").has_value();
  bool written = true;
  for (const char* name : {"b.mp4", "b.webm", "b.mkv"}) {
    const Codec codec = fs::path(name).extension() == ".mkv" ? Codec::kAv1 : Codec::kAuto;
    written = write_film(scratch.folder / name, {128, 96, 30.0, codec}, 3).has_value() && written;
  }
  std::fputs("heard again\n", stderr);
  ::dup2(before, STDERR_FILENO);
  ::close(before);
  ::close(file);
  CHECK_FALSE(film);
  CHECK(written);
  CHECK(read_file(said).value() == "heard again\n");
}

TEST_CASE("ffprobe, where there is one, finds nothing to complain about") {
  if (std::system("command -v ffprobe >/dev/null 2>&1") != 0) return;
  const Scratch scratch("ffprobe");
  const std::array<std::array<const char*, 2>, 3> films{{{"a.mp4", "h264,160,96,yuv420p,30\n"},
                                                         {"a.webm", "vp9,160,96,yuv420p,30\n"},
                                                         {"a.gif", "gif,160,96,bgra,30\n"}}};
  for (const auto& [name, expected] : films) {
    const fs::path path = scratch.folder / name;
    REQUIRE(write_film(path, {160, 96, 30.0, Codec::kAuto}, 30));
    const fs::path said = scratch.folder / "said";
    const std::string command =
        "ffprobe -v warning -count_frames -select_streams v -of csv=p=0 -show_entries "
        "stream=codec_name,width,height,pix_fmt,nb_read_frames '" +
        path.string() + "' >'" + said.string() + "' 2>&1";
    REQUIRE(std::system(command.c_str()) == 0);
    CHECK(read_file(said).value() == expected);
  }
}

TEST_CASE("the rates of television are what is meant by them") {
  if (std::system("command -v ffprobe >/dev/null 2>&1") != 0) return;
  const Scratch scratch("rates");
  for (const auto& [fps, expected] : {std::pair{29.97, "30000/1001\n"}, std::pair{23.976, "24000/1001\n"},
                                      std::pair{25.0, "25/1\n"}, std::pair{12.5, "25/2\n"}}) {
    CAPTURE(fps);
    const fs::path path = scratch.folder / "a.mp4";
    REQUIRE(write_film(path, {160, 96, fps, Codec::kAuto}, 30));
    const fs::path said = scratch.folder / "said";
    const std::string command = "ffprobe -v warning -of csv=p=0 -show_entries stream=avg_frame_rate '" + path.string() +
                                "' >'" + said.string() + "' 2>&1";
    REQUIRE(std::system(command.c_str()) == 0);
    CHECK(read_file(said).value() == expected);
  }
}

TEST_CASE("names of codecs are read back") {
  CHECK(codec_from(to_string(Codec::kAuto)).value() == Codec::kAuto);
  for (const Codec codec : all_codecs()) CHECK(codec_from(to_string(codec)).value() == codec);
  const auto unknown = codec_from("paint");
  REQUIRE_FALSE(unknown);
  CHECK(unknown.error().text().find("auto, h264, mpeg4, mjpeg, ffv1, vp9, av1, gif") != std::string::npos);
}
