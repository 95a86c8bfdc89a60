#include "engine/workbench/field_settings.h"

#include "engine/figure/field_figure.h"

namespace trocar::workbench {

plot::Colouring colouring_of(const learning::Field& field, const FieldSettings& settings) {
  figure::FieldFigureOptions options = figure::suggested_options(field);
  options.scale = settings.scale;
  options.vision = settings.vision;
  if (settings.map) options.map = *settings.map;
  options.limits = settings.limits;
  return figure::colouring_of(field, options);
}

plot::Colouring shared_colouring(const learning::Field& a, const learning::Field& b, const FieldSettings& settings) {
  learning::Field both = a;
  both.values.insert(both.values.end(), b.values.begin(), b.values.end());
  return colouring_of(both, settings);
}

std::string_view to_string(FieldContrast contrast) {
  if (contrast == FieldContrast::kPolicy) return "policy";
  return contrast == FieldContrast::kOutcomes ? "outcomes" : "difference";
}

Result<FieldContrast> field_contrast_from(std::string_view text) {
  for (const auto contrast : {FieldContrast::kDifference, FieldContrast::kPolicy, FieldContrast::kOutcomes}) {
    if (to_string(contrast) == text) return contrast;
  }
  return fail(ErrorCode::kInvalidArgument,
              "models are contrasted by difference, policy or outcomes, not by " + std::string(text));
}

bool same_colours(const FieldSettings& a, const FieldSettings& b) {
  return a.layer == b.layer && a.scale == b.scale && a.map == b.map && a.vision == b.vision && a.limits == b.limits;
}

}  // namespace trocar::workbench
