#include "engine/figure/print.h"

#include <doctest/doctest.h>
#include <unistd.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "engine/core/file.h"
#include "engine/figure/curve_figure.h"
#include "engine/figure/field_figure.h"
#include "engine/figure/layout.h"

using namespace trocar;
using namespace trocar::figure;
namespace fs = std::filesystem;

namespace {

constexpr Rgba kWhite{255, 255, 255, 255};

learning::Field sloped_field(int n, bool classes = false) {
  learning::Field field;
  field.grid = spatial::Grid::with_cells(n);
  field.title = "HHH";
  field.unit = classes ? "" : "steps";
  if (classes) {
    field.layer = learning::Layer::kBasin;
    field.categorical = true;
    field.categories = {"arrives", "loops", "dead end", "outside the safe set"};
  }
  for (std::int32_t i = 0; i < field.grid.cell_count(); ++i) {
    const spatial::CellCoordinates c = field.grid.coordinates({i});
    const double value = classes ? i % 4 : -0.5 * c.x - c.y + 0.1 * c.z;
    field.values.push_back(i % 7 == 3 ? std::numeric_limits<double>::quiet_NaN() : value);
  }
  return field;
}

FieldFigureOptions printed(const learning::Field& field, const char* preset, double dpi, bool montage) {
  FieldFigureOptions options = suggested_options(field);
  options.print = print_from(preset).value();
  options.print->dpi = dpi;
  if (!montage) options.slice = Slice{2, 3};
  options.subtitle = "A with a long name  ·  segment A  ·  eg-maxent, ε = 0.1, 10,000 episodes, seed 1";
  options.path = {field.grid.index({1, 2, 3})};
  options.safe = spatial::cells_within(field.grid, options.path, 2);
  options.start = field.grid.index({1, 2, 3});
  options.goal = field.grid.index({4, 2, 3});
  return options;
}

std::string file_of(const learning::Field& field, const FieldFigureOptions& options, const char* ending) {
  const fs::path path = fs::temp_directory_path() / ("trocar_print_" + std::to_string(::getpid()) + ending);
  REQUIRE(save_field(field, options, path));
  std::string bytes = read_file(path).value();
  fs::remove(path);
  return bytes;
}

/// The numbers that follow `key`.
std::vector<double> numbers_after(const std::string& text, const std::string& key, int count) {
  const std::size_t at = text.find(key);
  REQUIRE(at != std::string::npos);
  std::vector<double> numbers;
  const char* rest = text.c_str() + at + key.size();
  for (int i = 0; i < count; ++i) {
    char* end = nullptr;
    numbers.push_back(std::strtod(rest, &end));
    rest = end;
  }
  return numbers;
}

bool is_empty(const Image& image, int left, int top, int right, int bottom) {
  for (int y = top; y < bottom; ++y) {
    for (int x = left; x < right; ++x) {
      if (image.at(x, y) != kWhite) return false;
    }
  }
  return true;
}

/// Rows of the first letters of the title that have ink, from the top.
int height_of_capitals(const Image& image, double margin, int letters_px) {
  int rows = 0;
  for (int y = 0; y < image.height; ++y) {
    const bool ink = !is_empty(image, static_cast<int>(margin), y, static_cast<int>(margin) + letters_px, y + 1);
    if (ink) ++rows;
    if (!ink && rows > 0) return rows;
  }
  return rows;
}

CurveFigure curves() {
  std::vector<double> t;
  std::vector<double> v;
  for (int i = 0; i < 400; ++i) {
    t.push_back(0.01 * i);
    v.push_back(-1234.5 * std::sin(0.1 * i));
  }
  const auto curve = std::make_shared<const plot::Curve>(t, v);
  CurveFigure made;
  made.title = std::string(120, 'H');
  made.plots = {{"Acceleration", "mm/s²", {{"Left", curve}, {"Right", curve}}, {}, false},
                {"Jaw", "°", {{"Left", curve}, {"Right", curve}}, {}, false}};
  made.end_s = 3.99;
  made.print = Print{};
  return made;
}

}  // namespace

TEST_CASE("a column is 88 mm wide with letters of 8 points, a page 180 mm") {
  CHECK(print_from("column").value().width_mm == 88.0);
  CHECK(print_from("column").value().text_pt == 8.0);
  CHECK(print_from("page").value().width_mm == 180.0);
  CHECK(print_from("poster").error().code() == ErrorCode::kInvalidArgument);
}

TEST_CASE("a printed picture has the pixels of its width and resolution") {
  const learning::Field field = sloped_field(22);
  for (const bool montage : {true, false}) {
    CHECK(draw_field(field, printed(field, "column", 300.0, montage)).width == 1039);  // 88 / 25.4 · 300
    CHECK(draw_field(field, printed(field, "column", 600.0, montage)).width == 2079);
    CHECK(draw_field(field, printed(field, "page", 150.0, montage)).width == 1063);
  }
}

TEST_CASE("a printed drawing has its width on paper") {
  const learning::Field field = sloped_field(22);
  for (const bool montage : {true, false}) {
    const FieldFigureOptions options = printed(field, "column", 300.0, montage);
    const std::string pdf = file_of(field, options, ".pdf");
    CHECK(pdf.starts_with("%PDF-1."));
    const std::vector<double> box = numbers_after(pdf, "/MediaBox [", 4);
    CHECK(box[2] == doctest::Approx(88.0 / 25.4 * 72.0).epsilon(1e-6));
    CHECK((file_of(field, options, ".pdf") == pdf));
    const std::string svg = file_of(field, options, ".svg");
    CHECK(numbers_after(svg, "<svg ", 0).empty());
    CHECK(numbers_after(svg, " width=\"", 1)[0] == doctest::Approx(88.0 / 25.4 * 72.0).epsilon(1e-6));
    CHECK(svg.find("pt\" height=") != std::string::npos);
  }
}

TEST_CASE("every letter is 8 points, at any resolution and in drawings") {
  const learning::Field field = sloped_field(22);
  const auto points_of = [&](double dpi, Medium medium) {
    const FieldFigureOptions options = printed(field, "column", dpi, true);
    const Layout layout = layout_of(field, options, colouring_of(field, options), medium);
    const Letters& letters = layout.letters;
    CHECK(letters.title == letters.text);
    CHECK(letters.tick == letters.text);
    CHECK(letters.heading == letters.text);
    return letters.text * layout.pt_per_px;
  };
  CHECK(points_of(300.0, Medium::kPicture) == doctest::Approx(8.0));
  CHECK(points_of(97.0, Medium::kPicture) == doctest::Approx(8.0));
  CHECK(points_of(300.0, Medium::kDrawing) == doctest::Approx(8.0));
  // Measured: Inter's capitals are 0.727 of the em high.
  for (const double dpi : {300.0, 600.0}) {
    const FieldFigureOptions options = printed(field, "column", dpi, false);
    const Layout layout = layout_of(field, options, colouring_of(field, options));
    const double em = 8.0 / 72.0 * dpi;
    const int rows = height_of_capitals(draw_field(field, options), layout.margin, static_cast<int>(1.5 * em));
    CHECK(rows == doctest::Approx(0.727 * em).epsilon(0.06));
  }
}

TEST_CASE("in print nothing runs out of the figure, and headings of a montage do not touch") {
  for (const bool classes : {false, true}) {
    for (const char* preset : {"column", "page"}) {
      for (const int n : {22, 44}) {
        CAPTURE(preset);
        CAPTURE(n);
        const learning::Field field = sloped_field(n, classes);
        const FieldFigureOptions options = printed(field, preset, 300.0, true);
        const Layout layout = layout_of(field, options, colouring_of(field, options));
        const Image image = draw_field(field, options);
        const int margin = 5;
        CHECK(is_empty(image, 0, 0, margin, image.height));
        CHECK(is_empty(image, image.width - margin, 0, image.width, image.height));
        CHECK(is_empty(image, 0, 0, image.width, margin));
        CHECK(is_empty(image, 0, image.height - margin, image.width, image.height));
        // Right of the last letter of a heading, before the next panel begins, there is paper.
        for (int k = 0; k + 1 < layout.columns; ++k) {
          const int next = layout.left + (k + 1) * (layout.panel_px + layout.gap_x);
          CHECK(is_empty(image, next - 6, layout.top - static_cast<int>(22 * layout.unit), next - 1, layout.top - 2));
        }
      }
    }
  }
}

TEST_CASE("curves for print are as wide, with the same letters, and a long title stays inside") {
  const CurveFigure made = curves();
  const Image image = draw_curves(made);
  CHECK(image.width == 1039);
  CHECK(is_empty(image, 0, 0, 5, image.height));
  CHECK(is_empty(image, image.width - 5, 0, image.width, image.height));
  CHECK_FALSE(is_empty(image, 0, 0, image.width, image.height));
  const fs::path path = fs::temp_directory_path() / ("trocar_print_" + std::to_string(::getpid()) + "curves.pdf");
  REQUIRE(save_curves(made, path));
  const std::string pdf = read_file(path).value();
  fs::remove(path);
  CHECK(pdf.starts_with("%PDF-1."));
  CHECK(numbers_after(pdf, "/MediaBox [", 4)[2] == doctest::Approx(88.0 / 25.4 * 72.0).epsilon(1e-6));
  CHECK(save_curves(made, "/tmp/curves.xyz").error().code() == ErrorCode::kInvalidArgument);
}

TEST_CASE("a .vti has VTK's order, the cells' place in millimetres, and the same numbers") {
  const learning::Field field = sloped_field(5);
  const std::string text = file_of(field, {}, ".vti");
  CHECK(text.find("type=\"ImageData\"") != std::string::npos);
  CHECK(text.find("WholeExtent=\"0 5 0 5 0 5\" Origin=\"-37.5 -52.5 2.5\" Spacing=\"11 11 11\"") != std::string::npos);
  CHECK(text.find("<CellData Scalars=\"reward\">") != std::string::npos);
  const std::size_t begin = text.find("format=\"binary\">") + 16;
  const std::string digits = text.substr(begin, text.find('<', begin) - begin);
  std::string raw;
  const std::string alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  for (std::size_t i = 0; i + 3 < digits.size(); i += 4) {
    std::uint32_t three = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      three = three << 6U | (digits[i + k] == '=' ? 0U : static_cast<std::uint32_t>(alphabet.find(digits[i + k])));
    }
    for (const unsigned shift : {16U, 8U, 0U}) raw += static_cast<char>(three >> shift & 0xFFU);
  }
  std::uint32_t bytes = 0;
  std::memcpy(&bytes, raw.data(), 4);
  REQUIRE(bytes == 125 * 8);
  REQUIRE(raw.size() >= 4 + bytes);
  CHECK(digits.size() == (4 + bytes + 2) / 3 * 4);
  std::size_t at = 4;
  for (int z = 0; z < 5; ++z) {
    for (int y = 0; y < 5; ++y) {
      for (int x = 0; x < 5; ++x, at += 8) {
        double value = 0.0;
        std::memcpy(&value, raw.data() + at, 8);
        const double expected = field.values[static_cast<std::size_t>(field.grid.index({x, y, z}).value)];
        CHECK((std::isnan(expected) ? std::isnan(value) : value == expected));
      }
    }
  }
  FieldFigureOptions one;
  one.slice = Slice{2, 1};
  CHECK(save_field(field, one, "/tmp/a.vti").error().code() == ErrorCode::kInvalidArgument);
}
