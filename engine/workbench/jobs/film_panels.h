/// What stands beside the scene in a film: a field of a model, cut open, and curves of a recording as it goes on.
#pragma once

#include <memory>

#include "engine/figure/field_figure.h"
#include "engine/learning/field.h"
#include "engine/plot/curve.h"
#include "engine/workbench/curves.h"
#include "engine/workbench/jobs/film_pane.h"

namespace trocar::workbench {

/// A slice of a field with the model's marks; with a colour bar if the overlay asks for it.
class FieldPane final : public FilmPane {
 public:
  /// Errors: kInvalidArgument for a layer or slice that there is not.
  static Result<std::unique_ptr<FilmPane>> create(const FilmSource& source, const PaneLook& look);
  Result<Image> frame(Studio& studio, const PaneMoment& moment) override;
  std::string caption_at(const film::Instant&) const override { return {}; }

 private:
  FieldPane(FilmSource source, const PaneLook& look, learning::Field field, figure::FieldFigureOptions options)
      : source_(std::move(source)), look_(look), field_(std::move(field)), options_(std::move(options)) {}
  Image drawn(int index) const;
  /// Without letters and bar.
  Image bare(const figure::FieldFigureOptions& options) const;

  FilmSource source_;
  PaneLook look_;
  learning::Field field_;
  figure::FieldFigureOptions options_;
  int last_index_ = -1;
  Image last_;
};

/// One kind of curve of both tools, with a line at the instant.
class CurvePane final : public FilmPane {
 public:
  /// Errors: kInvalidArgument for a curve that there is not, or cannot be had in a film (the clearance).
  static Result<std::unique_ptr<FilmPane>> create(const FilmSource& source, const PaneLook& look);
  Result<Image> frame(Studio& studio, const PaneMoment& moment) override;
  std::string caption_at(const film::Instant&) const override { return {}; }

 private:
  CurvePane(FilmSource source, const PaneLook& look, CurveKind kind);
  /// All but the line.
  Image ground() const;
  double x_of(double at_s) const;
  double y_of(double value) const;

  FilmSource source_;
  PaneLook look_;
  CurveKind kind_;
  std::array<std::shared_ptr<const plot::Curve>, 2> curves_;
  plot::Extent extent_;
  double unit_ = 1.0;
  Image ground_;
};

}  // namespace trocar::workbench
