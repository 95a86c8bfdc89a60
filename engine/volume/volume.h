/// A field as a cloud: rays through the lattice, laid over a picture of the scene that it stands in.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "engine/core/image.h"
#include "engine/learning/field.h"
#include "engine/plot/colouring.h"
#include "engine/plot/opacity_curve.h"
#include "engine/scene/scene.h"

namespace trocar::volume {

struct MarchOptions {
  int divisor = 1;  ///< One ray for so many pixels each way, smoothed between; at least 1.
  int threads = 2;  ///< At least 1. The picture does not depend on it.
  /// 0 … 1: how much of what is behind a cell is hidden by one where the curve is highest.
  float opacity = 0.8F;
  std::optional<plot::OpacityCurve> curve;  ///< By place on the scale; none: `plot::fitted_opacity`.
  /// The slices that are drawn too, by cell; −1: none. What is behind one is left out, as if slices let nothing
  /// through.
  std::array<int, 3> slices{-1, -1, -1};
};

/// Draws volumes. A value has the colour that `colouring` gives it, and hides as much as the curve says. Positions on
/// the scale are interpolated between the centres of the known cells (trilinear); where nothing is known there is
/// nothing.
///
/// Threads: one at a time; it uses others while `draw` runs.
class Marcher {
 public:
  /// Over `picture`, whose depth along the camera's z is `depth_m`, metres, by pixel. Precondition: as many of them as
  /// pixels; the field has one value for each cell and is not of classes.
  void draw(Image& picture, const std::vector<float>& depth_m, const scene::Camera& camera,
            const std::shared_ptr<const learning::Field>& field, const plot::Colouring& colouring,
            const MarchOptions& options);

 private:
  /// One for each cell, with a border of unknown ones.
  struct Cell {
    float weighted = 0.0F;  ///< Position on the scale times `known`.
    float known = 0.0F;     ///< 1 or 0.
  };
  void prepare(const std::shared_ptr<const learning::Field>& field, const plot::Colouring& colouring);
  void leave_out(const plot::OpacityCurve& curve);

  std::shared_ptr<const learning::Field> field_;
  plot::Colouring colouring_;
  int side_ = 0;
  std::vector<Cell> cells_;
  plot::OpacityCurve fitted_;
  std::optional<plot::OpacityCurve> of_empty_;  ///< What `empty_` was found with.
  std::vector<std::uint8_t> empty_;             ///< By lower corner of eight cells: nothing between them is seen.
};

}  // namespace trocar::volume
