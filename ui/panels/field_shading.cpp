#include "ui/panels/field_shading.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/learning/slab.h"

namespace trocar::ui {
namespace {

// All shadings belong to the window's thread.
std::uint64_t last_revision = 0;
constexpr std::size_t kBins = 64;

}  // namespace

void FieldShading::update(std::shared_ptr<const learning::Field> field, const workbench::FieldSettings& settings) {
  if (field_ == field && workbench::same_colours(settings_, settings)) return;
  field_ = std::move(field);
  settings_ = settings;
  colouring_ = workbench::colouring_of(*field_, settings_);
  begin_anew();
  workbench::FieldSettings whole = settings_;
  whole.limits.reset();
  if (whole.scale == plot::ScaleKind::kPercentile) whole.scale = plot::ScaleKind::kLinear;
  axis_ = workbench::colouring_of(*field_, whole).scale;
  count_values();
}

void FieldShading::update(std::shared_ptr<const learning::Field> field, const workbench::FieldSettings& settings,
                          const plot::Colouring& colouring) {
  const bool same = field_ == field && colouring_.map == colouring.map && colouring_.vision == colouring.vision &&
                    colouring_.scale.kind == colouring.scale.kind && colouring_.scale.low == colouring.scale.low &&
                    colouring_.scale.high == colouring.scale.high && colouring_.scale.linear == colouring.scale.linear;
  if (same) return;
  field_ = std::move(field);
  settings_ = settings;
  colouring_ = colouring;
  begin_anew();
  axis_ = colouring_.scale;
  count_values();
}

void FieldShading::begin_anew() {
  revision_ = ++last_revision;
  indices_.fill(-1);
  montage_slab_.reset();
}

void FieldShading::count_values() {
  histogram_.assign(kBins, 0.0F);
  for (const double value : field_->values) {
    if (!std::isfinite(value)) continue;
    const auto bin = static_cast<std::size_t>(axis_.position(value) * static_cast<double>(kBins));
    histogram_[std::min(bin, kBins - 1)] += 1.0F;
  }
  const float most = *std::max_element(histogram_.begin(), histogram_.end());
  if (most > 0.0F) {
    for (float& bin : histogram_) bin /= most;
  }
}

const Image& FieldShading::slice(int axis, int index, Slab slab) {
  const auto i = static_cast<std::size_t>(axis);
  if (indices_[i] != index || slabs_[i] != slab) {
    slices_[i] = figure::slice_pixels(learning::with_slab(*field_, axis, index, slab.thickness, slab.through),
                                      figure::Slice{axis, index}, colouring_);
    indices_[i] = index;
    slabs_[i] = slab;
    versions_[i] = next_version_++;
  }
  return slices_[i];
}

const Image& FieldShading::montage(Slab slab) {
  if (montage_slab_ == slab) return montage_;
  const int n = field_->grid.n;
  montage_ = Image(n, n * n);
  for (int z = 0; z < n; ++z) {
    const Image one = figure::slice_pixels(learning::with_slab(*field_, 2, z, slab.thickness, slab.through),
                                           figure::Slice{2, z}, colouring_);
    const auto offset = static_cast<std::ptrdiff_t>(one.rgba.size()) * z;
    std::copy(one.rgba.begin(), one.rgba.end(), montage_.rgba.begin() + offset);
  }
  montage_slab_ = slab;
  montage_version_ = next_version_++;
  return montage_;
}

SliceAxes slice_axes(int axis) {
  if (axis == 0) return {1, 2};
  if (axis == 1) return {0, 2};
  return {1, 0};
}

}  // namespace trocar::ui
