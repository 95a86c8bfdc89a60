#include "engine/figure/field_figure.h"

#include "engine/core/ending.h"
#include "engine/figure/field_files.h"
#include "engine/figure/layout.h"

namespace trocar::figure {
namespace {

Status refused(const char* why, const std::filesystem::path& path) {
  return tl::unexpected(Error(ErrorCode::kInvalidArgument, why).at(path.string()));
}

canvas::Canvas page(const std::string& extension, const FieldFigureOptions& options, const Layout& layout) {
  if (extension == ".pdf") return canvas::Canvas::pdf(layout.width, layout.height, layout.pt_per_px);
  if (options.print) return canvas::Canvas::svg_on_paper(layout.width, layout.height, layout.pt_per_px);
  return canvas::Canvas::svg(layout.width, layout.height);
}

}  // namespace

Image draw_field(const learning::Field& field, const FieldFigureOptions& options) {
  const plot::Colouring colouring = colouring_of(field, options);
  const Layout layout = layout_of(field, options, colouring);
  canvas::Canvas canvas(Image(layout.width, layout.height, options.ground));
  draw_figure(canvas, field, options, colouring, layout);
  return canvas.picture();
}

Status save_field(const learning::Field& field, const FieldFigureOptions& options, const std::filesystem::path& path) {
  const std::string extension = ending_of(path);
  if (extension == ".csv") return write_csv(field, options.slice, path);
  if (extension == ".npy") return write_npy(field, options.slice, path);
  if (extension == ".vti") {
    if (!options.slice) return write_vti(field, path);
    return refused("a .vti holds the whole lattice, and no slice", path);
  }
  if (extension != ".svg" && extension != ".pdf") {
    return refused("a field is saved as .png, .svg, .pdf, .csv, .npy or .vti", path);
  }
  const plot::Colouring colouring = colouring_of(field, options);
  const Layout layout = layout_of(field, options, colouring, Medium::kDrawing);
  canvas::Canvas canvas = page(extension, options, layout);
  draw_figure(canvas, field, options, colouring, layout);
  return canvas.save(path);
}

}  // namespace trocar::figure
