/// Text and flat shapes on a picture, in an SVG or a PDF: captions of films, colour bars, figures. (Cairo, FreeType.)
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/image.h"
#include "engine/core/result.h"

namespace trocar::canvas {

struct Point {
  double x = 0.0;
  double y = 0.0;
};
enum class Align { kLeft, kCentre, kRight };
enum class Weight { kRegular, kSemiBold, kBold };

struct TextStyle {
  double size_px = 14.0;  ///< Em size.
  Weight weight = Weight::kRegular;
  Rgba colour{255, 255, 255, 255};
  Align align = Align::kLeft;
};

/// Draws with Inter (DejaVu Sans where it is missing). Units are pixels from the top left, y down. Threads: one at a
/// time; several canvases may live in several threads.
class Canvas {
 public:
  /// Draws over a copy of `background`.
  explicit Canvas(const Image& background);
  /// A vector drawing of that size in pixels, written by `save`; its pixels are those of a browser.
  static Canvas svg(double width, double height);
  /// The same on paper, each pixel `pt_per_px` points of 1/72 inch wide; text stays text in the PDF.
  static Canvas svg_on_paper(double width, double height, double pt_per_px);
  static Canvas pdf(double width, double height, double pt_per_px);
  ~Canvas();
  Canvas(Canvas&&) noexcept;
  Canvas& operator=(Canvas&&) noexcept;

  void rectangle(double x, double y, double w, double h, Rgba fill, double radius = 0.0);
  void outline(double x, double y, double w, double h, Rgba stroke, double width = 1.0, double radius = 0.0);
  void line(Point a, Point b, Rgba stroke, double width = 1.0);
  void polyline(const std::vector<Point>& points, Rgba stroke, double width = 1.0);
  void polygon(const std::vector<Point>& points, Rgba fill);
  void circle(Point centre, double radius, Rgba fill);
  /// Diagonal lines clipped to the rectangle: what is unknown.
  void hatch(double x, double y, double w, double h, Rgba stroke, double spacing = 4.0, double width = 1.0);
  /// A picture scaled to the rectangle without smoothing.
  void image(const Image& picture, double x, double y, double w, double h);
  /// `at` is the baseline's start, middle or end as `style.align` says.
  void text(Point at, std::string_view utf8, const TextStyle& style);
  double text_width(std::string_view utf8, const TextStyle& style) const;

  /// The picture so far; precondition: no vector drawing.
  Image picture() const;
  /// The same drawing gives the same bytes. Precondition: a vector drawing. Errors: kIo.
  Status save(const std::filesystem::path& path);

 private:
  struct Impl;
  explicit Canvas(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace trocar::canvas
