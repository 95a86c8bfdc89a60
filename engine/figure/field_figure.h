/// Fields over the lattice as flat figures: one slice or a montage of all, with a colour bar and its unit.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "engine/canvas/canvas.h"
#include "engine/core/image.h"
#include "engine/core/result.h"
#include "engine/figure/print.h"
#include "engine/learning/field.h"
#include "engine/plot/colouring.h"

namespace trocar::figure {

/// Cells with x = 7, say. Axis 0 x, 1 y, 2 z.
struct Slice {
  int axis = 2;
  int index = 11;
};
/// "z=11". Errors: kInvalidArgument.
Result<Slice> slice_from(std::string_view text, const spatial::Grid& grid);

struct FieldFigureOptions {
  std::optional<Slice> slice;  ///< None: a montage of all slices along z.
  plot::ColourMap map = plot::ColourMap::kViridis;
  plot::ScaleKind scale = plot::ScaleKind::kLinear;
  /// Values at which the colours end, low < high; none: fitted to the field. What a log scale cannot have is not
  /// heeded.
  std::optional<std::array<double, 2>> limits;
  plot::ColourVision vision = plot::ColourVision::kFull;  ///< The colours as this reader sees them.
  int width_px = 1000;          ///< At least 320; the figure grows where letters or cells would be too small to see.
  std::optional<Print> print;   ///< For paper: in place of `width_px`; grows only where a cell has less than a pixel.
  Rgba ground = kPaper;         ///< Of drawings, too.
  std::string subtitle;         ///< Whose field it is, below the title. Empty: none.
  learning::CellSequence path;  ///< Cells with a dot: the expert's. Empty: none.
  spatial::CellSet safe;        ///< Outlined. Empty: none.
  std::optional<spatial::CellIndex> start;  ///< With a square. None: not known.
  std::optional<spatial::CellIndex> goal;   ///< With a diamond. None: not known.
};

/// The colour map and scale that suit the layer (diverging for signed, categorical for classes).
FieldFigureOptions suggested_options(const learning::Field& field);
/// With the model's start, goal, expert's cells and safe set, and a subtitle that names its method.
FieldFigureOptions suggested_options(const learning::Field& field, const learning::Model& model);

/// One colour for each of `field.categories`: pale grey for a class that means "nothing here".
std::vector<Rgba> category_colours(const learning::Field& field);

/// The limits of its scale are fitted to the field.
plot::Colouring colouring_of(const learning::Field& field, const FieldFigureOptions& options);

/// The cells of one slice as a small picture, one pixel a cell, row 0 the largest vertical coordinate; unknown cells
/// have alpha 0. Horizontal and vertical axes: x-slice y,z; y-slice x,z; z-slice y,x.
Image slice_pixels(const learning::Field& field, const Slice& slice, const plot::Colouring& colouring);

/// Preconditions: the slice is one of the grid's, `path` and `safe` are of the same grid.
Image draw_field(const learning::Field& field, const FieldFigureOptions& options);

/// By the extension of `path`: .png is the caller's; .svg and .pdf draw; .csv (header row: i,j,k,x_mm,y_mm,z_mm,value;
/// unknown empty) and .npy (float64, n×n×n, C order, NaN unknown) hold numbers, with a slice the CSV of its cells only
/// and the NPY n×n, as `values[first axis][second axis]` in the order x, y, z; .vti is the whole lattice as VTK's
/// ImageData, in millimetres of W, the values as data of the cells. Errors: kInvalidArgument for another extension, and
/// for a slice of a .vti; kIo.
Status save_field(const learning::Field& field, const FieldFigureOptions& options, const std::filesystem::path& path);

}  // namespace trocar::figure
