/// What colour a value of a field has in a figure. Private to the module.
#pragma once

#include "engine/figure/field_figure.h"

namespace trocar::figure {

/// One scale for the whole field, so that slices can be compared.
struct FieldLook {
  plot::ColourMap map = plot::ColourMap::kViridis;
  plot::Scale scale;
  std::vector<Rgba> categories;  ///< Not empty: values are class numbers.

  /// Alpha 0 for a value that is not finite, or a class without a name.
  Rgba colour(double value) const;
};

FieldLook look_of(const learning::Field& field, plot::ColourMap map, const plot::Scale& scale);
FieldLook look_of(const learning::Field& field, const FieldFigureOptions& options);

}  // namespace trocar::figure
