#include "engine/workbench/jobs/film_panels.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/canvas/canvas.h"
#include "engine/film/property.h"
#include "engine/plot/colour_map.h"
#include "engine/workbench/insight.h"
#include "engine/workbench/jobs/field_job.h"

namespace trocar::workbench {
namespace {

using canvas::Align;
using canvas::Canvas;
using canvas::Weight;
using film::Overlay;

constexpr Rgba kWhitePaper{255, 255, 255, 255};
constexpr Rgba kDarkInk{28, 30, 34, 255};
constexpr Rgba kQuietInk{96, 101, 109, 255};
constexpr Rgba kThinInk{214, 217, 222, 255};

/// `inner` on white paper of the pane's size, in the middle of what is below the titles; cut where it is wider.
Image on_paper(const Image& inner, int width, int height, int titles) {
  Image outer(width, height, kWhitePaper);
  const int left = (width - inner.width) / 2;
  const int top = titles + (height - titles - inner.height) / 2;
  const int columns = std::min(width, inner.width);
  for (int y = std::max(0, top); y < std::min(height, top + inner.height); ++y) {
    const auto from = 4 * (static_cast<std::size_t>(y - top) * static_cast<std::size_t>(inner.width) +
                           static_cast<std::size_t>(std::max(0, -left)));
    const auto to = 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                         static_cast<std::size_t>(std::max(0, left)));
    std::copy_n(inner.rgba.begin() + static_cast<std::ptrdiff_t>(from), 4 * static_cast<std::size_t>(columns),
                outer.rgba.begin() + static_cast<std::ptrdiff_t>(to));
  }
  return outer;
}

/// Rows at the top in which a title stands.
int titles_height(const PaneLook& look) {
  return static_cast<int>(2.6 * film::kMargin * film::unit_of(film::Band::kNone, look.width, look.height));
}

/// Title and, where it was made by a script, that it was.
void write_titles(Image& frame, const FilmSource& source, const PaneLook& look) {
  film::FrameCaption caption;
  caption.title = look.overlays.has(Overlay::kTitle) ? source.title : "";
  caption.scripted = source.scripted;
  film::FilmOverlay(frame.width, frame.height, film::Band::kNone).draw(frame, caption);
}

}  // namespace

Result<std::unique_ptr<FilmPane>> FieldPane::create(const FilmSource& source, const PaneLook& look) {
  TROCAR_ASSIGN_OR_RETURN(const learning::Layer layer, learning::layer_from(source.said.layer));
  learning::Field field = field_of(*source.model->model, layer);
  TROCAR_ASSIGN_OR_RETURN(const figure::Slice slice, figure::slice_from(source.said.slice, field.grid));
  figure::FieldFigureOptions options = figure_options(*source.model, field);
  options.slice = slice;
  return std::unique_ptr<FilmPane>(new FieldPane(source, look, std::move(field), std::move(options)));
}

Image FieldPane::bare(const figure::FieldFigureOptions& options) const {
  const Image cells = figure::slice_pixels(field_, *options.slice, figure::colouring_of(field_, options));
  Canvas canvas(Image(look_.width, look_.height, kWhitePaper));
  const double below = titles_height(look_);
  const double room = std::min(std::max(1.0, look_.width - 2.0 * film::kMargin) / cells.width,
                               std::max(1.0, look_.height - below - 10.0) / cells.height);
  const double wide = room * cells.width;
  const double tall = room * cells.height;
  canvas.image(cells, (look_.width - wide) / 2.0, below + (look_.height - below - 10.0 - tall) / 2.0, wide, tall);
  return canvas.picture();
}

Image FieldPane::drawn(int index) const {
  figure::FieldFigureOptions options = options_;
  options.slice->index = index;
  Image frame;
  if (look_.overlays.has(Overlay::kColourBar)) {
    // Its height follows from its width: as wide as lets it stand below the title.
    const int titles = titles_height(look_);
    const int room = look_.height - titles;
    options.width_px = std::max(320, look_.width);
    Image figure = figure::draw_field(field_, options);
    for (int i = 0; i < 6 && figure.height > room && options.width_px > 320; ++i) {
      options.width_px = std::max(320, options.width_px * room / figure.height);
      figure = figure::draw_field(field_, options);
    }
    frame = figure.height <= room ? on_paper(figure, look_.width, look_.height, titles) : bare(options);
  } else {
    frame = bare(options);
  }
  return frame;
}

Result<Image> FieldPane::frame(Studio&, const PaneMoment& moment) {
  const int wanted = static_cast<int>(std::lround(film::value_of(source_.said, "slice", moment.film_s)));
  const int index = std::clamp(wanted, 0, field_.grid.n - 1);
  if (index != last_index_) {
    last_ = drawn(index);
    write_titles(last_, source_, look_);
    last_index_ = index;
  }
  return last_;
}

Result<std::unique_ptr<FilmPane>> CurvePane::create(const FilmSource& source, const PaneLook& look) {
  TROCAR_ASSIGN_OR_RETURN(const CurveKind kind, demonstration::curve_kind_from(source.said.curve));
  if (kind == CurveKind::kClearance) {
    return fail(ErrorCode::kInvalidArgument, "the clearance cannot be shown in a film: plot it with demo plot");
  }
  return std::unique_ptr<FilmPane>(new CurvePane(source, look, kind));
}

CurvePane::CurvePane(FilmSource source, const PaneLook& look, CurveKind kind)
    : source_(std::move(source)), look_(look), kind_(kind) {
  const demonstration::Demonstration& shown = *source_.shown;
  std::optional<plot::Extent> all;
  for (int arm = 0; arm < 2; ++arm) {
    auto& curve = curves_[static_cast<std::size_t>(arm)];
    curve = plotted(shown.samples, shown.first_tick(), kind, arm);
    const std::optional<plot::Extent> own = curve->extent(source_.in_s, source_.out_s);
    if (!own) continue;
    all = all ? plot::Extent{std::min(all->low, own->low), std::max(all->high, own->high)} : *own;
  }
  extent_ = all.value_or(plot::Extent{0.0, 1.0});
  if (look_of(kind).from_zero) extent_.low = std::min(0.0, extent_.low);
  if (!(extent_.high > extent_.low)) extent_.high = extent_.low + 1.0;
  unit_ = film::unit_of(film::Band::kNone, look.width, look.height);
}

double CurvePane::x_of(double at_s) const {
  const double left = 90.0 * unit_;
  const double right = look_.width - film::kMargin * unit_;
  return left + (right - left) * (at_s - source_.in_s) / (source_.out_s - source_.in_s);
}

double CurvePane::y_of(double value) const {
  const double top = (source_.scripted ? 150.0 : 110.0) * unit_;
  const double bottom = look_.height - 70.0 * unit_;
  return bottom - (bottom - top) * (value - extent_.low) / (extent_.high - extent_.low);
}

Image CurvePane::ground() const {
  Canvas canvas(Image(look_.width, look_.height, kWhitePaper));
  const auto letters = [&](Rgba colour, Align align) {
    return canvas::TextStyle{15.0 * unit_, Weight::kRegular, colour, align};
  };
  const double left = x_of(source_.in_s);
  const double right = x_of(source_.out_s);
  const double bottom = y_of(extent_.low);
  const double top = y_of(extent_.high);
  const std::vector<double> values = plot::ticks(extent_.low, extent_.high, 5);
  const double step = values.size() > 1 ? values[1] - values[0] : 1.0;
  for (const double value : values) {
    canvas.line({left, y_of(value)}, {right, y_of(value)}, kThinInk, 1.0);
    canvas.text({left - 8.0 * unit_, y_of(value) + 5.0 * unit_}, plot::format_tick(value, step),
                letters(kDarkInk, Align::kRight));
  }
  const std::vector<double> times = plot::ticks(0.0, source_.out_s - source_.in_s, 6);
  const double time_step = times.size() > 1 ? times[1] - times[0] : 1.0;
  for (const double t : times) {
    const double x = x_of(source_.in_s + t);
    canvas.line({x, bottom}, {x, bottom + 6.0 * unit_}, kQuietInk, 1.0);
    canvas.text({x, bottom + 24.0 * unit_}, plot::format_tick(t, time_step), letters(kDarkInk, Align::kCentre));
  }
  canvas.line({left, bottom}, {right, bottom}, kQuietInk, 1.0);
  canvas.text({(left + right) / 2, bottom + 46.0 * unit_}, "time, s", letters(kQuietInk, Align::kCentre));
  const CurveLook& look = look_of(kind_);
  canvas.text({left, top - 14.0 * unit_}, fmt::format("{}, {}", look.title, look.unit),
              {17.0 * unit_, Weight::kSemiBold, kDarkInk, Align::kLeft});
  for (int arm = 0; arm < 2; ++arm) {
    const Rgba colour = plot::category(arm == 0 ? 4 : 5);
    for (const auto& line : curves_[static_cast<std::size_t>(arm)]->lines(source_.in_s, source_.out_s, look_.width)) {
      std::vector<canvas::Point> points;
      for (const plot::CurvePoint& point : line) {
        points.push_back({std::clamp(x_of(point.x), left, right), y_of(point.y)});
      }
      canvas.polyline(points, colour, 2.0 * unit_);
    }
    const double x = right - (arm == 0 ? 110.0 : 0.0) * unit_;
    canvas.text({x, top - 14.0 * unit_}, arm_title(arm), {15.0 * unit_, Weight::kBold, colour, Align::kRight});
  }
  return canvas.picture();
}

Result<Image> CurvePane::frame(Studio&, const PaneMoment& moment) {
  if (ground_.empty()) {
    ground_ = ground();
    write_titles(ground_, source_, look_);
  }
  Canvas canvas(ground_);
  const double x = x_of(std::clamp(moment.instant.at_s, source_.in_s, source_.out_s));
  canvas.line({x, y_of(extent_.high)}, {x, y_of(extent_.low)}, kDarkInk, 2.0 * unit_);
  for (int arm = 0; arm < 2; ++arm) {
    const auto value = curves_[static_cast<std::size_t>(arm)]->value_at(moment.instant.at_s);
    if (value) canvas.circle({x, y_of(*value)}, 5.0 * unit_, plot::category(arm == 0 ? 4 : 5));
  }
  return canvas.picture();
}

}  // namespace trocar::workbench
