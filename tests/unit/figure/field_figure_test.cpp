#include "engine/figure/field_figure.h"

#include <doctest/doctest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <sstream>

#include "engine/core/file.h"
#include "engine/figure/layout.h"
#include "engine/figure/legend.h"

using namespace trocar;
using namespace trocar::figure;
namespace fs = std::filesystem;

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// The value of a cell is 10000 x + 100 y + z, and some cells are unknown.
learning::Field numbered(int n) {
  learning::Field field;
  field.grid = spatial::Grid::with_cells(n);
  field.title = "Reward θ";
  for (std::int32_t i = 0; i < field.grid.cell_count(); ++i) {
    const spatial::CellCoordinates c = field.grid.coordinates({i});
    field.values.push_back(i % 7 == 3 ? kNan : 10000.0 * c.x + 100.0 * c.y + c.z);
  }
  return field;
}

learning::Field classes(int n) {
  learning::Field field = numbered(n);
  field.layer = learning::Layer::kExplored;
  field.categorical = true;
  field.categories = {"no action", "some actions", "all six actions"};
  for (std::size_t i = 0; i < field.values.size(); ++i) field.values[i] = static_cast<double>(i % 3);
  return field;
}

fs::path scratch(const char* name) {
  return fs::temp_directory_path() / ("trocar_figure_" + std::to_string(::getpid()) + name);
}

std::string saved(const learning::Field& field, const FieldFigureOptions& options, const char* name) {
  const fs::path path = scratch(name);
  REQUIRE(save_field(field, options, path));
  std::string bytes = read_file(path).value();
  fs::remove(path);
  return bytes;
}

/// True if the outermost `margin` pixels on every side are white: nothing runs out of the figure.
bool has_clear_margin(const Image& image, int margin) {
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const bool inner = x >= margin && y >= margin && x < image.width - margin && y < image.height - margin;
      if (!inner && image.at(x, y) != Rgba{255, 255, 255, 255}) return false;
    }
  }
  return true;
}

}  // namespace

TEST_CASE("slices are read as they are written, and others refused") {
  const spatial::Grid grid;
  const Slice slice = slice_from("y=21", grid).value();
  CHECK(slice.axis == 1);
  CHECK(slice.index == 21);
  for (const char* text : {"", "z", "z=", "z=22", "z=-1", "w=3", "z=3x", "3=z", "z =3"}) {
    CAPTURE(text);
    CHECK(slice_from(text, grid).error().code() == ErrorCode::kInvalidArgument);
  }
}

TEST_CASE("a slice's pixels are its cells, the largest vertical coordinate on top") {
  const learning::Field field = numbered(5);
  plot::Colouring colouring;
  colouring.map = plot::ColourMap::kMagma;
  colouring.scale.high = 50000.0;
  const auto expected = [&](int x, int y, int z) {
    const double value = field.values[static_cast<std::size_t>(field.grid.index({x, y, z}).value)];
    return std::isfinite(value) ? plot::colour(plot::ColourMap::kMagma, value / 50000.0) : Rgba{0, 0, 0, 0};
  };
  const Image z_slice = slice_pixels(field, {2, 1}, colouring);
  const Image x_slice = slice_pixels(field, {0, 3}, colouring);
  const Image y_slice = slice_pixels(field, {1, 2}, colouring);
  for (int row = 0; row < 5; ++row) {
    for (int column = 0; column < 5; ++column) {
      CHECK(z_slice.at(column, row) == expected(4 - row, column, 1));
      CHECK(x_slice.at(column, row) == expected(3, column, 4 - row));
      CHECK(y_slice.at(column, row) == expected(column, 2, 4 - row));
    }
  }
}

TEST_CASE("the suggested map is diverging for signed values, classes for classes, sequential else") {
  learning::Field field = numbered(4);
  CHECK(suggested_options(field).map == plot::ColourMap::kViridis);
  field.values[0] = -5.0;
  CHECK(suggested_options(field).map == plot::ColourMap::kDiverging);
  CHECK(suggested_options(classes(4)).map == plot::ColourMap::kCategorical);
  CHECK(category_colours(classes(4)).size() == 3);
}

TEST_CASE("figures of every kind keep a clear margin and the width asked for") {
  learning::Field field = numbered(22);
  field.unit = "steps";
  for (const learning::Field& shown : {field, classes(22)}) {
    for (const int width : {600, 1000}) {
      FieldFigureOptions options = suggested_options(shown);
      options.width_px = width;
      options.subtitle = "exact";
      options.path = {shown.grid.index({3, 4, 5}), shown.grid.index({3, 4, 6})};
      options.safe = spatial::cells_within(shown.grid, options.path, 4);
      const Image montage = draw_field(shown, options);
      CHECK(montage.width == width);
      CHECK(has_clear_margin(montage, width / 60));
      options.slice = Slice{0, 3};
      const Image single = draw_field(shown, options);
      CHECK(single.width == width);
      CHECK(has_clear_margin(single, width / 60));
      CHECK_FALSE(single == montage);
    }
  }
}

TEST_CASE("a field with nothing known, one value only, or another lattice still makes a figure") {
  learning::Field nothing = numbered(4);
  std::fill(nothing.values.begin(), nothing.values.end(), kNan);
  learning::Field flat = numbered(4);
  std::fill(flat.values.begin(), flat.values.end(), 3.0);
  for (const learning::Field& field : {nothing, flat, numbered(1), numbered(44)}) {
    for (const plot::ScaleKind kind :
         plot::all_scale_kinds()) {
      FieldFigureOptions options = suggested_options(field);
      options.scale = kind;
      CHECK_FALSE(draw_field(field, options).empty());
    }
  }
}

TEST_CASE("the expert's cells change the picture where they are") {
  const learning::Field field = numbered(22);
  FieldFigureOptions options;
  options.slice = Slice{2, 5};
  const Image plain = draw_field(field, options);
  options.path = {field.grid.index({3, 4, 6})};
  const Image elsewhere = draw_field(field, options);
  options.path = {field.grid.index({3, 4, 5})};
  CHECK_FALSE(draw_field(field, options) == elsewhere);
  CHECK_FALSE(elsewhere == plain);  // The key names the mark.
}

TEST_CASE("start and goal are marked in their slices, and only there") {
  const learning::Field field = numbered(22);
  FieldFigureOptions options;
  const auto drawn = [&](int z) {
    options.slice = Slice{2, z};
    FieldFigureOptions plain = options;
    plain.start.reset();
    plain.goal.reset();
    // The key names the marks in every slice; the cells are left of it.
    const Image with = draw_field(field, options);
    const Image without = draw_field(field, plain);
    const int cells = with.width * 3 / 5;
    int changed = 0;
    for (int y = 0; y < std::min(with.height, without.height); ++y) {
      for (int x = 0; x < cells; ++x) changed += with.at(x, y) == without.at(x, y) ? 0 : 1;
    }
    return changed;
  };
  options.path = {field.grid.index({1, 1, 1})};  // the key is as wide with and without the two marks
  options.safe = spatial::cells_within(field.grid, options.path, 1);
  options.start = field.grid.index({3, 4, 5});
  options.goal = field.grid.index({9, 2, 7});
  CHECK(drawn(5) > 20);
  CHECK(drawn(7) > 20);
  CHECK(drawn(6) == 0);
}

TEST_CASE("the two texts over a panel of a montage never touch; where both do not fit, the index stands alone") {
  for (const int n : {22, 30, 44}) {
    for (const bool wide_key : {false, true}) {
      learning::Field field = classes(n);
      if (wide_key) field.categories[0] = "reaches no goal within the steps that it has";
      const FieldFigureOptions options = suggested_options(field);
      const Layout layout = layout_of(field, options, colouring_of(field, options));
      const Image picture = draw_field(field, options);
      const int last = layout.panels - 1;  // it has the longest texts
      const int left = layout.left + last % layout.columns * (layout.panel_px + layout.gap_x);
      const int top = layout.top + last / layout.columns * (layout.panel_px + layout.gap_y);
      std::vector<int> inked;
      for (int x = left; x < left + layout.panel_px; ++x) {
        for (int y = top - static_cast<int>(18 * layout.unit); y < top - 2; ++y) {
          if (picture.at(x, y) == Rgba{255, 255, 255, 255}) continue;
          inked.push_back(x);
          break;
        }
      }
      REQUIRE_FALSE(inked.empty());
      int widest_gap = left + layout.panel_px - inked.back();
      for (std::size_t i = 1; i < inked.size(); ++i) widest_gap = std::max(widest_gap, inked[i] - inked[i - 1]);
      CAPTURE(n);
      CAPTURE(wide_key);
      CHECK(widest_gap >= static_cast<int>(8 * layout.unit));
    }
  }
}

TEST_CASE("a long name of whose field it is neither leaves the figure nor widens it") {
  learning::Field field = numbered(22);
  FieldFigureOptions options = suggested_options(field);
  options.subtitle = std::string(300, 'W');
  const Image picture = draw_field(field, options);
  CHECK(picture.width == 1000);
  CHECK(has_clear_margin(picture, 16));
}

TEST_CASE("a legend covers the upper right corner of a picture and nothing else") {
  const Image picture(960, 540, {40, 50, 60, 255});
  for (const learning::Field& field : {numbered(22), classes(22)}) {
    const FieldFigureOptions options = suggested_options(field);
    const Image with = with_legend(picture, field, colouring_of(field, options), "A exact");
    CHECK(with.width == 960);
    int corner = 0;
    int elsewhere = 0;
    for (int y = 0; y < 540; ++y) {
      for (int x = 0; x < 960; ++x) {
        if (with.at(x, y) == picture.at(x, y)) continue;
        (x > 640 && y < 360 ? corner : elsewhere) += 1;
      }
    }
    CHECK(corner > 5000);
    CHECK(elsewhere == 0);
  }
}

TEST_CASE("the colour bar ends in a point where values lie beyond the scale, and is flat where none do") {
  learning::Field field = numbered(6);
  FieldFigureOptions options;
  options.slice = Slice{2, 2};
  options.scale = plot::ScaleKind::kPercentile;
  const auto narrow_rows = [&] {
    // Rows with a few pixels of the map's last colour right of the slice: a point, narrower than the bar.
    const Image image = draw_field(field, options);
    int narrow = 0;
    for (int y = 0; y < image.height; ++y) {
      int count = 0;
      for (int x = image.width * 87 / 100; x < image.width; ++x) {
        count += image.at(x, y) == plot::colour(plot::ColourMap::kViridis, 1.0) ? 1 : 0;
      }
      narrow += count > 0 && count < 8 ? 1 : 0;
    }
    return narrow;
  };
  CHECK(narrow_rows() > 2);
  options.scale = plot::ScaleKind::kLinear;
  CHECK(narrow_rows() == 0);
}

TEST_CASE("the CSV has a row for each cell, and its numbers read back as the same numbers") {
  learning::Field field = numbered(4);
  field.values[0] = 0.1 + 0.2;
  std::istringstream text(saved(field, {}, "a.csv"));
  std::string line;
  REQUIRE(std::getline(text, line));
  CHECK(line == "i,j,k,x_mm,y_mm,z_mm,value");
  std::size_t rows = 0;
  while (std::getline(text, line) && rows < 64) {
    const std::string value = line.substr(line.rfind(',') + 1);
    CHECK((value.empty() ? std::isnan(field.values[rows]) : std::strtod(value.c_str(), nullptr) == field.values[rows]));
    ++rows;
  }
  CHECK(rows == 64);
  CHECK(text.eof());
}

TEST_CASE("positions in the CSV are the middles of the cells in millimetres") {
  const std::string text = saved(numbered(22), {}, "b.csv");
  CHECK(text.find("\n0,0,0,-36.25,-51.25,3.75,0\n") != std::string::npos);
}

TEST_CASE("the CSV of a slice has the cells of the slice only") {
  FieldFigureOptions options;
  options.slice = Slice{1, 2};
  const std::string text = saved(numbered(4), options, "c.csv");
  CHECK(std::count(text.begin(), text.end(), '\n') == 17);
  CHECK(text.find("\n0,2,0,") != std::string::npos);
  CHECK(text.find("\n0,1,0,") == std::string::npos);
}

TEST_CASE("the NPY has NumPy's header, a multiple of 64 long, and the values in C order") {
  const learning::Field field = numbered(5);
  const std::string bytes = saved(field, {}, "a.npy");
  REQUIRE(bytes.substr(0, 8) == std::string("\x93NUMPY\x01\x00", 8));
  const std::size_t header = 10 + static_cast<std::uint8_t>(bytes[8]) + 256U * static_cast<std::uint8_t>(bytes[9]);
  CHECK(header % 64 == 0);
  CHECK(bytes[header - 1] == '\n');
  CHECK(bytes.substr(10).starts_with("{'descr': '<f8', 'fortran_order': False, 'shape': (5, 5, 5), }"));
  REQUIRE(bytes.size() == header + 8 * 125);
  for (std::size_t i = 0; i < 125; ++i) {
    double value = 0.0;
    std::memcpy(&value, bytes.data() + header + 8 * i, 8);
    CHECK((std::isnan(field.values[i]) ? std::isnan(value) : value == field.values[i]));
  }
  FieldFigureOptions options;
  options.slice = Slice{2, 0};
  CHECK(saved(field, options, "b.npy").find("'shape': (5, 5), }") != std::string::npos);
}

TEST_CASE("the SVG is one document that xmllint, where there is one, takes") {
  const fs::path path = scratch("a.svg");
  REQUIRE(save_field(numbered(6), {}, path));
  const std::string text = read_file(path).value();
  CHECK(text.find("width=\"1000px\"") != std::string::npos);
  CHECK(text.find("</svg>") != std::string::npos);
  if (std::system("command -v xmllint >/dev/null 2>&1") == 0) {
    CHECK(std::system(("xmllint --noout '" + path.string() + "'").c_str()) == 0);
  }
  fs::remove(path);
}

TEST_CASE("another extension is refused, and a folder that is not there is an I/O error") {
  CHECK(save_field(numbered(2), {}, "/tmp/a.xyz").error().code() == ErrorCode::kInvalidArgument);
  for (const char* path : {"/nowhere/a.csv", "/nowhere/a.npy", "/nowhere/a.svg"}) {
    CHECK(save_field(numbered(2), {}, path).error().code() == ErrorCode::kIo);
  }
}
