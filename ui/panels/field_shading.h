/// How the shown field becomes colours: its map and scale, worked out once for each field, and its slices as pictures.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "engine/core/image.h"
#include "engine/figure/field_figure.h"
#include "engine/learning/field.h"
#include "engine/plot/colour_map.h"

namespace trocar::ui {

class FieldShading {
 public:
  /// Cheap when neither the field nor the kind of scale changed.
  void update(std::shared_ptr<const learning::Field> field, plot::ScaleKind kind);

  const learning::Field& field() const { return *field_; }
  plot::ColourMap map() const { return map_; }
  const plot::Scale& scale() const { return scale_; }
  /// The colour of a value; of a category by its number.
  Rgba colour(double value) const;
  /// One pixel a cell, as `figure::slice_pixels`; kept until the slice or the shading changes.
  const Image& slice(int axis, int index);
  /// Changes with what `slice` of that axis returns.
  std::uint64_t version(int axis) const { return versions_[static_cast<std::size_t>(axis)]; }

 private:
  std::shared_ptr<const learning::Field> field_;
  plot::ScaleKind kind_ = plot::ScaleKind::kLinear;
  plot::ColourMap map_ = plot::ColourMap::kViridis;
  plot::Scale scale_;
  std::vector<Rgba> categories_;  ///< Empty unless the field has classes.
  std::array<Image, 3> slices_;
  std::array<int, 3> indices_{-1, -1, -1};
  std::array<std::uint64_t, 3> versions_{};
  std::uint64_t next_version_ = 1;
};

/// Which board axes run right and up in a slice across `axis` (0 x, 1 y, 2 z), as `figure::slice_pixels`.
struct SliceAxes {
  int right = 0;
  int up = 1;
};
SliceAxes slice_axes(int axis);

}  // namespace trocar::ui
