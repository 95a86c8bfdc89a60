#include "engine/canvas/canvas.h"

#include <cairo-pdf.h>
#include <cairo-svg.h>
#include <cairo.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>

#include "engine/canvas/fonts.h"
#include "engine/canvas/pixels.h"
#include "engine/core/check.h"
#include "engine/core/file.h"

namespace trocar::canvas {
namespace {

using Surface = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;
using Context = std::unique_ptr<cairo_t, decltype(&cairo_destroy)>;

cairo_status_t append_bytes(void* closure, const unsigned char* data, unsigned int length) {
  static_cast<std::string*>(closure)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

/// Cairo numbers its surfaces and images through the whole life of the process; numbered through each document instead,
/// the same drawing gives the same file.
std::string renumbered(std::string_view svg) {
  std::map<std::string, std::string, std::less<>> names;
  std::string out;
  while (!svg.empty()) {
    const std::size_t by_id = svg.find(" id=\"");
    const std::size_t by_use = svg.find('#');
    const std::size_t at = std::min(by_id == std::string_view::npos ? by_id : by_id + 5,
                                    by_use == std::string_view::npos ? by_use : by_use + 1);
    if (at == std::string_view::npos) return out.append(svg);
    out.append(svg.substr(0, at));
    svg.remove_prefix(at);
    const std::size_t letters = std::min(svg.find_first_not_of("abcdefghijklmnopqrstuvwxyz"), svg.size());
    const std::size_t end = std::min(svg.find_first_not_of("0123456789", letters), svg.size());
    const std::string_view name = svg.substr(0, end);
    if (letters == 0 || end == letters || end == svg.size() || svg[end] == '-') continue;
    auto known = names.find(name);
    if (known == names.end()) {
      known = names.emplace(name, std::string(name.substr(0, letters)) + std::to_string(names.size() + 1)).first;
    }
    out += known->second;
    svg.remove_prefix(end);
  }
  return out;
}

void set_colour(cairo_t* context, Rgba c) {
  cairo_set_source_rgba(context, c.r / 255.0, c.g / 255.0, c.b / 255.0, c.a / 255.0);
}

void trace_rectangle(cairo_t* context, double x, double y, double w, double h, double radius) {
  cairo_new_path(context);
  const double r = std::min({radius, w / 2.0, h / 2.0});
  if (!(r > 0.0)) {
    cairo_rectangle(context, x, y, w, h);
    return;
  }
  constexpr double kQuarter = std::numbers::pi / 2.0;
  cairo_arc(context, x + w - r, y + r, r, -kQuarter, 0.0);
  cairo_arc(context, x + w - r, y + h - r, r, 0.0, kQuarter);
  cairo_arc(context, x + r, y + h - r, r, kQuarter, 2 * kQuarter);
  cairo_arc(context, x + r, y + r, r, 2 * kQuarter, 3 * kQuarter);
  cairo_close_path(context);
}

void trace(cairo_t* context, const std::vector<Point>& points) {
  cairo_new_path(context);
  for (const Point& p : points) cairo_line_to(context, p.x, p.y);
}

void stroke(cairo_t* context, Rgba colour, double width) {
  set_colour(context, colour);
  cairo_set_line_width(context, width);
  cairo_stroke(context);
}

}  // namespace

struct Canvas::Impl {
  std::shared_ptr<std::string> vector_bytes;  ///< Null for a picture; outlives the surface that writes to it.
  bool is_svg = false;
  Surface surface{nullptr, &cairo_surface_destroy};
  Context context{nullptr, &cairo_destroy};

  void open(cairo_surface_t* made) {
    surface.reset(made);
    context.reset(cairo_create(made));
    cairo_set_line_join(context.get(), CAIRO_LINE_JOIN_ROUND);
    const std::unique_ptr<cairo_font_options_t, decltype(&cairo_font_options_destroy)> options(
        cairo_font_options_create(), &cairo_font_options_destroy);
    // Grey, so that letters look the same on any ground; unhinted widths, so that text scales evenly.
    cairo_font_options_set_antialias(options.get(), CAIRO_ANTIALIAS_GRAY);
    cairo_font_options_set_hint_style(options.get(), CAIRO_HINT_STYLE_SLIGHT);
    cairo_font_options_set_hint_metrics(options.get(), CAIRO_HINT_METRICS_OFF);
    cairo_set_font_options(context.get(), options.get());
  }

  void open_svg(double width, double height, cairo_svg_unit_t unit) {
    vector_bytes = std::make_shared<std::string>();
    is_svg = true;
    cairo_surface_t* made = cairo_svg_surface_create_for_stream(append_bytes, vector_bytes.get(), width, height);
    cairo_svg_surface_set_document_unit(made, unit);
    open(made);
  }

  double run_width(const FontRun& run, double size) const {
    cairo_set_font_face(context.get(), run.face);
    cairo_set_font_size(context.get(), size);
    cairo_text_extents_t extents;
    cairo_text_extents(context.get(), run.utf8.c_str(), &extents);
    return extents.x_advance;
  }

  double width_of(const std::vector<FontRun>& runs, double size) const {
    double width = 0.0;
    for (const FontRun& run : runs) width += run_width(run, size);
    return width;
  }
};

Canvas::Canvas(const Image& background) : impl_(std::make_unique<Impl>()) {
  impl_->open(surface_from(background));
}

Canvas Canvas::svg(double width, double height) {
  Canvas canvas(std::make_unique<Impl>());
  canvas.impl_->open_svg(width, height, CAIRO_SVG_UNIT_PX);
  return canvas;
}

Canvas Canvas::svg_on_paper(double width, double height, double pt_per_px) {
  Canvas canvas(std::make_unique<Impl>());
  canvas.impl_->open_svg(width * pt_per_px, height * pt_per_px, CAIRO_SVG_UNIT_PT);
  cairo_scale(canvas.impl_->context.get(), pt_per_px, pt_per_px);
  return canvas;
}

Canvas Canvas::pdf(double width, double height, double pt_per_px) {
  Canvas canvas(std::make_unique<Impl>());
  Impl& impl = *canvas.impl_;
  impl.vector_bytes = std::make_shared<std::string>();
  cairo_surface_t* surface =
      cairo_pdf_surface_create_for_stream(append_bytes, impl.vector_bytes.get(), width * pt_per_px, height * pt_per_px);
  // No time of writing, so that the same drawing gives the same file.
  cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATE_DATE, "");
  impl.open(surface);
  cairo_scale(impl.context.get(), pt_per_px, pt_per_px);
  return canvas;
}

Canvas::Canvas(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Canvas::~Canvas() = default;
Canvas::Canvas(Canvas&&) noexcept = default;
Canvas& Canvas::operator=(Canvas&&) noexcept = default;

void Canvas::rectangle(double x, double y, double w, double h, Rgba fill, double radius) {
  if (fill.a == 0) return;
  trace_rectangle(impl_->context.get(), x, y, w, h, radius);
  set_colour(impl_->context.get(), fill);
  cairo_fill(impl_->context.get());
}

void Canvas::outline(double x, double y, double w, double h, Rgba colour, double width, double radius) {
  trace_rectangle(impl_->context.get(), x, y, w, h, radius);
  stroke(impl_->context.get(), colour, width);
}

void Canvas::line(Point a, Point b, Rgba colour, double width) {
  trace(impl_->context.get(), {a, b});
  stroke(impl_->context.get(), colour, width);
}

void Canvas::polyline(const std::vector<Point>& points, Rgba colour, double width) {
  trace(impl_->context.get(), points);
  stroke(impl_->context.get(), colour, width);
}

void Canvas::polygon(const std::vector<Point>& points, Rgba fill) {
  trace(impl_->context.get(), points);
  cairo_close_path(impl_->context.get());
  set_colour(impl_->context.get(), fill);
  cairo_fill(impl_->context.get());
}

void Canvas::circle(Point centre, double radius, Rgba fill) {
  cairo_new_path(impl_->context.get());
  cairo_arc(impl_->context.get(), centre.x, centre.y, radius, 0.0, 2.0 * std::numbers::pi);
  set_colour(impl_->context.get(), fill);
  cairo_fill(impl_->context.get());
}

void Canvas::hatch(double x, double y, double w, double h, Rgba colour, double spacing, double width) {
  if (!(w > 0.0 && h > 0.0 && spacing > 0.0)) return;
  cairo_t* context = impl_->context.get();
  cairo_save(context);
  cairo_rectangle(context, x, y, w, h);
  cairo_clip(context);
  cairo_new_path(context);
  // Lines x + y = k · spacing, counted from the origin, so that neighbouring rectangles join without a seam.
  const double reach = spacing * std::numbers::sqrt2;
  const auto last = static_cast<std::int64_t>(std::floor((x + y + w + h) / reach));
  for (auto k = static_cast<std::int64_t>(std::floor((x + y) / reach)); k <= last; ++k) {
    const double top = static_cast<double>(k) * reach - y;
    cairo_move_to(context, top, y);
    cairo_line_to(context, top - h, y + h);
  }
  stroke(context, colour, width);
  cairo_restore(context);
}

void Canvas::image(const Image& picture, double x, double y, double w, double h) {
  if (picture.empty() || !(w > 0.0 && h > 0.0)) return;
  cairo_t* context = impl_->context.get();
  const Surface source(surface_from(picture), &cairo_surface_destroy);
  cairo_save(context);
  cairo_translate(context, x, y);
  cairo_scale(context, w / picture.width, h / picture.height);
  cairo_set_source_surface(context, source.get(), 0.0, 0.0);
  cairo_pattern_set_filter(cairo_get_source(context), CAIRO_FILTER_NEAREST);
  cairo_rectangle(context, 0.0, 0.0, picture.width, picture.height);
  cairo_fill(context);
  cairo_restore(context);
}

void Canvas::text(Point at, std::string_view utf8, const TextStyle& style) {
  cairo_t* context = impl_->context.get();
  const std::vector<FontRun> runs = font_runs(utf8, style.weight);
  double x = at.x;
  if (style.align != Align::kLeft) {
    x -= impl_->width_of(runs, style.size_px) * (style.align == Align::kCentre ? 0.5 : 1.0);
  }
  set_colour(context, style.colour);
  for (const FontRun& run : runs) {
    const double width = impl_->run_width(run, style.size_px);
    cairo_move_to(context, x, at.y);
    cairo_show_text(context, run.utf8.c_str());
    x += width;
  }
  cairo_new_path(context);
}

double Canvas::text_width(std::string_view utf8, const TextStyle& style) const {
  return impl_->width_of(font_runs(utf8, style.weight), style.size_px);
}

Image Canvas::picture() const {
  TROCAR_CHECK(impl_->vector_bytes == nullptr);
  return image_from(impl_->surface.get());
}

Status Canvas::save(const std::filesystem::path& path) {
  TROCAR_CHECK(impl_->vector_bytes != nullptr);
  const cairo_status_t drawn = cairo_status(impl_->context.get());
  cairo_surface_finish(impl_->surface.get());
  if (drawn != CAIRO_STATUS_SUCCESS || cairo_surface_status(impl_->surface.get()) != CAIRO_STATUS_SUCCESS) {
    return tl::unexpected(Error(ErrorCode::kIo, "could not draw the figure").at(path.string()));
  }
  return write_file(path, impl_->is_svg ? renumbered(*impl_->vector_bytes) : *impl_->vector_bytes);
}

}  // namespace trocar::canvas
