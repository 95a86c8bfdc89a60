#include "engine/figure/field_figure.h"

#include "engine/figure/field_files.h"
#include "engine/figure/layout.h"

namespace trocar::figure {

Image draw_field(const learning::Field& field, const FieldFigureOptions& options) {
  const plot::Colouring colouring = colouring_of(field, options);
  const Layout layout = layout_of(field, options, colouring);
  canvas::Canvas canvas(Image(layout.width, layout.height, {255, 255, 255, 255}));
  draw_figure(canvas, field, options, colouring, layout);
  return canvas.picture();
}

Status save_field(const learning::Field& field, const FieldFigureOptions& options, const std::filesystem::path& path) {
  const std::string extension = path.extension().string();
  if (extension == ".csv") return write_csv(field, options.slice, path);
  if (extension == ".npy") return write_npy(field, options.slice, path);
  if (extension != ".svg") {
    return tl::unexpected(
        Error(ErrorCode::kInvalidArgument, "a field is saved as .png, .svg, .csv or .npy").at(path.string()));
  }
  const plot::Colouring colouring = colouring_of(field, options);
  const Layout layout = layout_of(field, options, colouring);
  canvas::Canvas canvas = canvas::Canvas::svg(layout.width, layout.height);
  draw_figure(canvas, field, options, colouring, layout);
  return canvas.save_svg(path);
}

}  // namespace trocar::figure
