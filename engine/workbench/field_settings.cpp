#include "engine/workbench/field_settings.h"

#include "engine/figure/field_figure.h"

namespace trocar::workbench {

plot::Colouring colouring_of(const learning::Field& field, const FieldSettings& settings) {
  figure::FieldFigureOptions options = figure::suggested_options(field);
  options.scale = settings.scale;
  options.vision = settings.vision;
  if (settings.map) options.map = *settings.map;
  plot::Colouring colouring = figure::colouring_of(field, options);
  if (!settings.limits) return colouring;
  const auto [low, high] = *settings.limits;
  const bool across = colouring.scale.kind == plot::ScaleKind::kLog && (low <= 0.0) != (high < 0.0);
  if (low < high && !across) {
    colouring.scale.low = low;
    colouring.scale.high = high;
  }
  return colouring;
}

plot::Colouring shared_colouring(const learning::Field& a, const learning::Field& b, const FieldSettings& settings) {
  learning::Field both = a;
  both.values.insert(both.values.end(), b.values.begin(), b.values.end());
  return colouring_of(both, settings);
}

bool same_colours(const FieldSettings& a, const FieldSettings& b) {
  return a.layer == b.layer && a.scale == b.scale && a.map == b.map && a.vision == b.vision && a.limits == b.limits;
}

}  // namespace trocar::workbench
