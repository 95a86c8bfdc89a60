/// A curve of many samples: what of it a picture of few columns shows, its extent, and its value at a place.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace trocar::plot {

struct CurvePoint {
  double x = 0.0;
  double y = 0.0;
};

/// Least and greatest.
struct Extent {
  double low = 0.0;
  double high = 0.0;
};

/// Immutable value. A y that is not finite is a gap. Threads: any.
class Curve {
 public:
  Curve() = default;
  /// Preconditions: equally long; x is finite and does not decrease.
  Curve(std::vector<double> x, std::vector<double> y);

  const std::vector<double>& x() const { return x_; }
  const std::vector<double>& y() const { return y_; }
  bool empty() const { return x_.empty(); }

  /// Of the finite samples with x in [begin, end]; nothing if there are none.
  std::optional<Extent> extent(double begin, double end) const;
  /// On the line between the samples before and after; nothing in a gap, and before the first and after the last.
  std::optional<double> value_at(double x) const;
  /// One line for each stretch without a gap over [begin, end]. Where one of the equal columns holds more than four
  /// samples, its first, lowest, highest and last stay, in their order: no spike is lost. The neighbours just outside
  /// are there, too, so that lines go on to the edges. Preconditions: begin < end, columns > 0.
  /// Time: by the columns; only columns with gaps are gone through sample by sample.
  std::vector<std::vector<CurvePoint>> lines(double begin, double end, int columns) const;

 private:
  /// Where a stretch of samples is lowest and highest.
  struct Summary {
    bool gap = false;  ///< One of them is not finite.
    std::size_t low = 0;
    std::size_t high = 0;
  };
  class Pen;
  Summary summary(std::size_t first, std::size_t end) const;
  void widen(Summary& summary, std::size_t index) const;
  void draw(std::size_t first, std::size_t end, Pen& pen) const;

  std::vector<double> x_;
  std::vector<double> y_;
  std::vector<Summary> blocks_;  ///< Of 64 samples each, as far as they go.
};

}  // namespace trocar::plot
