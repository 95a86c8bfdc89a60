#include <doctest/doctest.h>
#include <unistd.h>

#include <string>

#include "engine/core/file.h"
#include "engine/media/picture_file.h"
#include "engine/media/png_check.h"

using namespace trocar;
using namespace trocar::media;
namespace fs = std::filesystem;

namespace {

bool opencv_is_loaded() {
  return read_file("/proc/self/maps").value_or("").find("libopencv") != std::string::npos;
}
const bool loaded_at_start = opencv_is_loaded();

fs::path scratch(const char* name) {
  return fs::temp_directory_path() / ("trocar_picture_" + std::to_string(::getpid()) + name);
}

Image gradient(bool opaque) {
  Image image(37, 21);
  for (int y = 0; y < 21; ++y) {
    for (int x = 0; x < 37; ++x) {
      image.set(x, y,
                {static_cast<std::uint8_t>(7 * x), static_cast<std::uint8_t>(12 * y), 200,
                 static_cast<std::uint8_t>(opaque ? 255 : 10 + 6 * x)});
    }
  }
  return image;
}

}  // namespace

TEST_CASE("OpenCV is not in memory until a picture needs it") {
  CHECK_FALSE(loaded_at_start);
  const fs::path path = scratch("lazy.png");
  REQUIRE(write_png(path, Image(2, 2)));
  CHECK(opencv_is_loaded());
  fs::remove(path);
}

TEST_CASE("a PNG gives back every pixel, opaque or not") {
  for (const bool opaque : {true, false}) {
    const fs::path path = scratch("round.png");
    REQUIRE(write_png(path, gradient(opaque)));
    CHECK(read_picture(path).value() == gradient(opaque));
    fs::remove(path);
  }
}

TEST_CASE("a PNG says how many pixels an inch has, and is the same picture") {
  const fs::path path = scratch("dpi.png");
  REQUIRE(write_png(path, gradient(true), 300.0));
  const std::string bytes = read_file(path).value();
  CHECK(check_png(bytes));
  CHECK(read_picture(path).value() == gradient(true));
  const std::size_t at = bytes.find("pHYs");
  REQUIRE(at != std::string::npos);
  CHECK(at < bytes.find("IDAT"));
  // 300 / 0.0254 = 11811 = 0x2E23 pixels a metre, along both.
  CHECK((bytes.substr(at - 4, 17) == std::string("\0\0\0\x09pHYs\0\0\x2E\x23\0\0\x2E\x23\x01", 17)));
  REQUIRE(write_png(path, gradient(true)));
  CHECK(read_file(path).value().find("pHYs") == std::string::npos);
  fs::remove(path);
}

TEST_CASE("a PNG cut short anywhere, or with one bit turned, is corrupt") {
  const fs::path path = scratch("whole.png");
  const fs::path damaged = scratch("damaged.png");
  REQUIRE(write_png(path, gradient(true)));
  const std::string bytes = read_file(path).value();
  CHECK(check_png(bytes));
  for (std::size_t n = 0; n < bytes.size(); n += 1 + n / 8) CHECK_FALSE(check_png(bytes.substr(0, n)));
  for (std::size_t n = 0; n + 12 < bytes.size(); ++n) {
    std::string turned = bytes;
    turned[n] = static_cast<char>(turned[n] ^ 4);
    CHECK_FALSE(check_png(turned));
  }
  REQUIRE(write_file(damaged, bytes.substr(0, bytes.size() / 2)));
  const auto picture = read_picture(damaged);
  REQUIRE_FALSE(picture);
  CHECK(picture.error().code() == ErrorCode::kCorrupt);
  CHECK(picture.error().text().ends_with(damaged.string()));
  fs::remove(path);
  fs::remove(damaged);
}

TEST_CASE("text is no picture, and a missing file is not found") {
  const fs::path path = scratch("text.png");
  REQUIRE(write_file(path, "hello"));
  CHECK(read_picture(path).error().code() == ErrorCode::kCorrupt);
  fs::remove(path);
  CHECK(read_picture(path).error().code() == ErrorCode::kIo);
}

TEST_CASE("an empty picture is refused, a bad folder is an I/O error, and neither leaves a file") {
  CHECK(write_png(scratch("empty.png"), Image()).error().code() == ErrorCode::kInvalidArgument);
  CHECK_FALSE(fs::exists(scratch("empty.png")));
  CHECK(write_png("/nowhere/at/all.png", Image(2, 2)).error().code() == ErrorCode::kIo);
}
