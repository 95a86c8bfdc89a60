/// How a field is shown in the window: its layer, colours, and what is drawn of it in the 3-D view.
#pragma once

#include <array>
#include <optional>

#include "engine/learning/field.h"
#include "engine/plot/colouring.h"

namespace trocar::workbench {

struct FieldSettings {
  bool visible = true;
  learning::Layer layer = learning::Layer::kReward;
  std::array<int, 3> slices{-1, -1, -1};  ///< −1: none.
  bool voxels = false;
  plot::ScaleKind scale = plot::ScaleKind::kLinear;
  std::optional<plot::ColourMap> map;  ///< None: what suits the layer.
  plot::ColourVision vision = plot::ColourVision::kFull;
  std::optional<std::array<double, 2>> limits;  ///< Of the colours, low < high; none: fitted to the field.
  float opacity = 0.8F;
  bool operator==(const FieldSettings&) const = default;
};

/// Limits that the kind of scale cannot have (log across zero) are not heeded. Classes keep their own colours.
plot::Colouring colouring_of(const learning::Field& field, const FieldSettings& settings);

}  // namespace trocar::workbench
