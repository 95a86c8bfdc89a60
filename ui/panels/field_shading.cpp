#include "ui/panels/field_shading.h"

#include <utility>

namespace trocar::ui {
namespace {

// All shadings belong to the window's thread.
std::uint64_t last_revision = 0;

}  // namespace

void FieldShading::update(std::shared_ptr<const learning::Field> field, const workbench::FieldSettings& settings) {
  workbench::FieldSettings colours = settings;
  colours.slices = settings_.slices;  // and what else does not change the colours
  colours.voxels = settings_.voxels;
  colours.opacity = settings_.opacity;
  colours.visible = settings_.visible;
  if (field_ == field && settings_ == colours) return;
  field_ = std::move(field);
  settings_ = colours;
  colouring_ = workbench::colouring_of(*field_, settings_);
  revision_ = ++last_revision;
  indices_.fill(-1);
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
  revision_ = ++last_revision;
  indices_.fill(-1);
}

const Image& FieldShading::slice(int axis, int index) {
  const auto i = static_cast<std::size_t>(axis);
  if (indices_[i] != index) {
    slices_[i] = figure::slice_pixels(*field_, figure::Slice{axis, index}, colouring_);
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
