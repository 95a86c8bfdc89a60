#include "engine/canvas/canvas.h"

#include <doctest/doctest.h>
#include <unistd.h>

#include <thread>

#include "engine/core/file.h"

using namespace trocar;
using namespace trocar::canvas;
namespace fs = std::filesystem;

namespace {

Image transparent(int w, int h) {
  return Image(w, h, {0, 0, 0, 0});
}

/// Pixels that differ from `background`.
int ink(const Image& image, Rgba background) {
  int count = 0;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) count += image.at(x, y) == background ? 0 : 1;
  }
  return count;
}

std::string drawn_svg(const char* name) {
  const fs::path path = fs::temp_directory_path() / (std::string(name) + std::to_string(::getpid()) + ".svg");
  Canvas canvas = Canvas::svg(120.0, 80.0);
  canvas.rectangle(10, 10, 30, 20, {255, 0, 0, 255}, 4.0);
  canvas.text({60, 40}, "θ < 5 & q", {14.0, Weight::kBold, {0, 0, 0, 255}, Align::kCentre});
  canvas.image(Image(2, 2, {1, 2, 3, 255}), 50, 50, 20, 20);
  REQUIRE(canvas.save(path));
  const std::string text = read_file(path).value();
  fs::remove(path);
  return text;
}

}  // namespace

TEST_CASE("a picture that is not drawn on comes back unchanged, channels in their places") {
  Image image(3, 2, {10, 20, 30, 255});
  image.set(1, 1, {200, 100, 50, 255});
  image.set(2, 0, {0, 0, 0, 0});
  CHECK(Canvas(image).picture() == image);
}

TEST_CASE("a half transparent colour comes back straight, to within rounding") {
  Image image = transparent(2, 1);
  image.set(0, 0, {200, 100, 50, 128});
  const Rgba c = Canvas(image).picture().at(0, 0);
  CHECK(c.a == 128);
  CHECK(std::abs(c.r - 200) <= 1);
  CHECK(std::abs(c.g - 100) <= 1);
  CHECK(std::abs(c.b - 50) <= 1);
}

TEST_CASE("a rectangle fills its pixels and no others") {
  Canvas canvas(Image(8, 8, {255, 255, 255, 255}));
  canvas.rectangle(2, 3, 4, 2, {255, 128, 0, 255});
  const Image image = canvas.picture();
  CHECK(image.at(2, 3) == Rgba{255, 128, 0, 255});
  CHECK(image.at(5, 4) == Rgba{255, 128, 0, 255});
  CHECK(ink(image, {255, 255, 255, 255}) == 8);
}

TEST_CASE("drawing over a picture mixes by alpha") {
  Canvas canvas(Image(2, 2, {0, 0, 0, 255}));
  canvas.rectangle(0, 0, 2, 2, {255, 255, 255, 51});
  CHECK(canvas.picture().at(1, 1) == Rgba{51, 51, 51, 255});
}

TEST_CASE("text has ink where it is aligned to, and a width that grows with it") {
  const Rgba white{255, 255, 255, 255};
  TextStyle style{20.0, Weight::kRegular, {0, 0, 0, 255}, Align::kRight};
  Canvas canvas(Image(200, 40, white));
  canvas.text({190, 28}, "Reward θ", style);
  const Image image = canvas.picture();
  const double width = canvas.text_width("Reward θ", style);
  CHECK(width > 60.0);
  CHECK(width < 120.0);
  CHECK(canvas.text_width("Reward θ θ", style) > width);
  CHECK(canvas.text_width("", style) == 0.0);
  CHECK(ink(image, white) > 200);
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      if (x < 190 - width - 1 || x > 191) CHECK(image.at(x, y) == white);
    }
  }
}

TEST_CASE("weights differ, and a letter that Inter lacks is drawn from the second face") {
  const Canvas canvas(Image(4, 4));
  CHECK(canvas.text_width("Segment", {20.0, Weight::kBold, {}, Align::kLeft}) >
        canvas.text_width("Segment", {20.0, Weight::kRegular, {}, Align::kLeft}));
  const Rgba white{255, 255, 255, 255};
  const auto drawn = [&](const char* text) {
    Canvas c(Image(60, 40, white));
    c.text({5, 30}, text, {24.0, Weight::kRegular, {0, 0, 0, 255}, Align::kLeft});
    return c.picture();
  };
  // A braille letter and a private-use one: the first is in DejaVu Sans only, the second in neither.
  CHECK_FALSE(drawn("\u2801") == drawn("\uF8F0"));
}

TEST_CASE("text that is no UTF-8 is drawn all the same") {
  Canvas canvas(Image(100, 30, {255, 255, 255, 255}));
  canvas.text({5, 20}, "a\xFF\xC3(\xE2\x82", {14.0, Weight::kRegular, {0, 0, 0, 255}, Align::kLeft});
  canvas.text({50, 20}, "ok", {14.0, Weight::kRegular, {0, 0, 0, 255}, Align::kLeft});
  CHECK(ink(canvas.picture(), {255, 255, 255, 255}) > 30);
}

TEST_CASE("a hatch stays inside its rectangle and leaves gaps") {
  Canvas canvas(Image(40, 40, {255, 255, 255, 255}));
  canvas.hatch(10, 10, 20, 20, {0, 0, 0, 255});
  const Image image = canvas.picture();
  const int inside = ink(image, {255, 255, 255, 255});
  CHECK(inside > 60);
  CHECK(inside < 400);
  for (int i = 0; i < 40; ++i) {
    CHECK(image.at(i, 9) == Rgba{255, 255, 255, 255});
    CHECK(image.at(30, i) == Rgba{255, 255, 255, 255});
  }
}

TEST_CASE("an enlarged picture keeps hard edges") {
  Image two(2, 1);
  two.set(0, 0, {255, 0, 0, 255});
  two.set(1, 0, {0, 0, 255, 255});
  Canvas canvas(Image(20, 10));
  canvas.image(two, 0, 0, 20, 10);
  const Image image = canvas.picture();
  CHECK(image.at(9, 5) == Rgba{255, 0, 0, 255});
  CHECK(image.at(10, 5) == Rgba{0, 0, 255, 255});
  CHECK(image.at(19, 9) == Rgba{0, 0, 255, 255});
}

TEST_CASE("an SVG is one document of the size asked for, the same each time") {
  const std::string text = drawn_svg("trocar_canvas_");
  const Canvas between = Canvas::svg(5, 5);
  CHECK(text.find("<svg") != std::string::npos);
  CHECK(text.find("viewBox=\"0 0 120 80\"") != std::string::npos);
  CHECK(text.find("</svg>") != std::string::npos);
  CHECK((drawn_svg("trocar_canvas_again_") == text));
}

TEST_CASE("on paper a drawing is as large as its points say, and the same each time") {
  const auto drawn = [](Canvas canvas, const char* name) {
    canvas.rectangle(10, 10, 50, 20, {20, 60, 90, 200});
    canvas.text({10, 60}, "Reward θ", {33.0, Weight::kBold, {0, 0, 0, 255}, Align::kLeft});
    const fs::path path = fs::temp_directory_path() / (std::string(name) + std::to_string(::getpid()));
    REQUIRE(canvas.save(path));
    std::string bytes = read_file(path).value();
    fs::remove(path);
    return bytes;
  };
  const std::string pdf = drawn(Canvas::pdf(120, 80, 0.24), "trocar_canvas_pdf_");
  CHECK(pdf.starts_with("%PDF-1."));
  CHECK(pdf.find("/MediaBox [ 0 0 28.8 19.2 ]") != std::string::npos);
  CHECK(pdf.find("/FontFile") != std::string::npos);  // text is text
  CHECK(pdf.find("CreationDate") == std::string::npos);
  CHECK((drawn(Canvas::pdf(120, 80, 0.24), "trocar_canvas_pdf_again_") == pdf));
  const std::string svg = drawn(Canvas::svg_on_paper(120, 80, 0.24), "trocar_canvas_paper_");
  CHECK(svg.find("width=\"28.8pt\" height=\"19.2pt\" viewBox=\"0 0 28.8 19.2\"") != std::string::npos);
}

TEST_CASE("an SVG for a folder that does not exist is an I/O error") {
  Canvas canvas = Canvas::svg(10, 10);
  const Status status = canvas.save("/nowhere/at/all.svg");
  REQUIRE_FALSE(status);
  CHECK(status.error().code() == ErrorCode::kIo);
}

TEST_CASE("two canvases in two threads draw what one draws alone") {
  const auto draw = [] {
    Canvas canvas(Image(160, 60, {240, 240, 240, 255}));
    for (int i = 0; i < 40; ++i) {
      canvas.text({4.0, 30.0}, "Agent, 12.4 s – θ ⠁", {8.0 + i % 7, Weight::kSemiBold, {0, 0, 0, 255}, Align::kLeft});
    }
    return canvas.picture();
  };
  const Image alone = draw();
  Image a;
  Image b;
  {
    const std::jthread first([&] { a = draw(); });
    const std::jthread second([&] { b = draw(); });
  }
  CHECK(a == alone);
  CHECK(b == alone);
}
