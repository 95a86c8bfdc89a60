/// How a field is shown in the window: its layer, colours, and what is drawn of it in the 3-D view.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "engine/core/result.h"
#include "engine/learning/field.h"
#include "engine/learning/field_mask.h"
#include "engine/learning/slab.h"
#include "engine/plot/colouring.h"
#include "engine/plot/opacity_curve.h"
#include "engine/stage/glyphs.h"

namespace trocar::workbench {

using stage::Glyphs;

struct FieldSettings {
  bool visible = true;
  learning::Layer layer = learning::Layer::kReward;
  learning::FieldMask mask = learning::FieldMask::kNone;
  std::array<int, 3> slices{-1, -1, -1};                    ///< −1: none.
  std::array<int, 3> slabs{1, 1, 1};                        ///< Cells that each slice is thick, at least 1.
  learning::Through through = learning::Through::kLargest;  ///< What is shown of a thick slice.
  bool voxels = false;
  double voxel_threshold = 0.9;  ///< Position on the scale, 0 … 1, from which on a voxel is drawn.
  bool iso_surface = false;
  double iso_level = 0.5;  ///< Position on the scale, 0 … 1.
  bool volume = false;
  std::optional<plot::OpacityCurve> opacity_curve;  ///< Of the volume; none: `plot::fitted_opacity`.
  Glyphs glyphs = Glyphs::kNone;                    ///< On the slices that are shown.
  bool streamlines = false;                         ///< Where the greedy policy leads …
  std::string streamline_starts = "around:2";       ///< … from here, as `learning::starts_from` reads it.
  plot::ScaleKind scale = plot::ScaleKind::kLinear;
  std::optional<plot::ColourMap> map;  ///< None: what suits the layer.
  plot::ColourVision vision = plot::ColourVision::kFull;
  std::optional<std::array<double, 2>> limits;  ///< Of the colours, low < high; none: fitted to the field.
  float opacity = 0.8F;
  bool operator==(const FieldSettings&) const = default;
};

/// What two models say about each other, cell by cell.
enum class FieldContrast : std::uint8_t {
  kDifference,  ///< B − A of the layer.
  kPolicy,      ///< Where the greedy action is another.
  kOutcomes,    ///< From where either arrives.
};
std::string_view to_string(FieldContrast contrast);  ///< "difference", "policy", "outcomes"
/// Errors: kInvalidArgument with the names that there are.
Result<FieldContrast> field_contrast_from(std::string_view text);

/// How a field is drawn in a file; what holds numbers heeds none of it.
struct FieldFileLook {
  std::optional<plot::ScaleKind> scale;         ///< None: what suits the layer.
  std::optional<plot::ColourMap> map;           ///< None: what suits the layer.
  std::optional<std::array<double, 2>> limits;  ///< None: fitted to what is written.
  plot::ColourVision vision = plot::ColourVision::kFull;
  int width_px = 1000;        ///< Without a preset.
  std::string preset;         ///< As `figure::print_from`; empty: for a screen.
  std::optional<double> dpi;  ///< Of a picture: what it says of itself and, with a preset, its pixels.
  bool transparent = false;   ///< Without the white ground.
  bool operator==(const FieldFileLook&) const = default;
};

/// Limits that the kind of scale cannot have (log across zero) are not heeded. Classes keep their own colours.
plot::Colouring colouring_of(const learning::Field& field, const FieldSettings& settings);
/// Of the values of both, so that a colour means one value in either. Precondition: the same layer.
plot::Colouring shared_colouring(const learning::Field& a, const learning::Field& b, const FieldSettings& settings);
/// The same colours: all else may differ.
bool same_colours(const FieldSettings& a, const FieldSettings& b);

}  // namespace trocar::workbench
