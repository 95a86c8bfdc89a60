#include "ui/panels/field_shading.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace trocar::ui {

void FieldShading::update(std::shared_ptr<const learning::Field> field, plot::ScaleKind kind) {
  if (field_ == field && kind_ == kind) return;
  field_ = std::move(field);
  kind_ = kind;
  map_ = figure::suggested_options(*field_).map;
  scale_ = plot::fit_scale(kind_, field_->values, map_ == plot::ColourMap::kDiverging);
  categories_ = figure::category_colours(*field_);
  indices_.fill(-1);
}

Rgba FieldShading::colour(double value) const {
  if (!categories_.empty()) {
    const long last = static_cast<long>(categories_.size()) - 1;
    return categories_[static_cast<std::size_t>(std::clamp(std::lround(value), 0L, last))];
  }
  return plot::colour(map_, scale_.position(value));
}

const Image& FieldShading::slice(int axis, int index) {
  const auto i = static_cast<std::size_t>(axis);
  if (indices_[i] != index) {
    slices_[i] = figure::slice_pixels(*field_, figure::Slice{axis, index}, map_, scale_);
    indices_[i] = index;
    versions_[i] = next_version_++;
  }
  return slices_[i];
}

SliceAxes slice_axes(int axis) {
  if (axis == 0) return {1, 2};
  if (axis == 1) return {0, 2};
  return {1, 0};
}

}  // namespace trocar::ui
