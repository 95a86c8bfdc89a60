/// How the shown field becomes colours: its map and scale, worked out once for each field, and its slices as pictures.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "engine/core/image.h"
#include "engine/figure/field_figure.h"
#include "engine/learning/field.h"
#include "engine/workbench/field_settings.h"

namespace trocar::ui {

/// How thick a slice is, in cells, and what it shows across them.
struct Slab {
  int thickness = 1;
  learning::Through through = learning::Through::kLargest;
  bool operator==(const Slab&) const = default;
};

class FieldShading {
 public:
  /// Cheap when neither the field nor its colours changed.
  void update(std::shared_ptr<const learning::Field> field, const workbench::FieldSettings& settings);

  /// With colours that are given: a scale that two fields share.
  void update(std::shared_ptr<const learning::Field> field, const workbench::FieldSettings& settings,
              const plot::Colouring& colouring);

  const learning::Field& field() const { return *field_; }
  const plot::Colouring& colouring() const { return colouring_; }
  /// One pixel a cell, as `figure::slice_pixels`, of a slab so many cells thick; kept until the slice or the shading
  /// changes.
  const Image& slice(int axis, int index, Slab slab = {});
  /// All slices along z, one below the other, the lowest first; kept likewise.
  const Image& montage(Slab slab = {});
  std::uint64_t montage_version() const { return montage_version_; }
  /// The scale of the colours over all values, whatever limits were set and values clipped: what a colour bar runs
  /// along. Not for classes.
  const plot::Scale& axis() const { return axis_; }
  /// How many known cells there are by place on `axis`, as shares of the fullest place.
  const std::vector<float>& histogram() const { return histogram_; }
  /// Changes with every field and colouring, unique among all shadings.
  std::uint64_t revision() const { return revision_; }
  /// Changes with what `slice` of that axis returns.
  std::uint64_t version(int axis) const { return versions_[static_cast<std::size_t>(axis)]; }

 private:
  /// Once field, settings and colouring are new.
  void begin_anew();
  void count_values();

  std::shared_ptr<const learning::Field> field_;
  workbench::FieldSettings settings_;
  plot::Colouring colouring_;
  std::array<Image, 3> slices_;
  std::array<int, 3> indices_{-1, -1, -1};
  std::array<Slab, 3> slabs_;
  Image montage_;
  std::optional<Slab> montage_slab_;  ///< None: there is no montage.
  std::uint64_t montage_version_ = 0;
  plot::Scale axis_;
  std::vector<float> histogram_;
  std::array<std::uint64_t, 3> versions_{};
  std::uint64_t next_version_ = 1;
  std::uint64_t revision_ = 0;
};

/// Which board axes run right and up in a slice across `axis` (0 x, 1 y, 2 z), as `figure::slice_pixels`.
struct SliceAxes {
  int right = 0;
  int up = 1;
};
SliceAxes slice_axes(int axis);

}  // namespace trocar::ui
