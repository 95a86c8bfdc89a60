/// What a cloud hides by the place of a value on the scale: a curve over the histogram that is drawn by its knots.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "engine/plot/opacity_curve.h"
#include "ui/panel.h"
#include "ui/panels/field_shading.h"

namespace trocar::ui {

/// Keeps which knot is meant, and a drag.
class OpacityEditor {
 public:
  /// `curve` none: fitted to the field; it becomes the user's own when a knot is moved. Returns true while it changes.
  /// Drag a knot, double-click for a new one, or on one to take it away; with the keyboard on the curve up and
  /// down shift the chosen one. The curve's item has the role "plot"; each knot is a "mark" ("Knot 1", "0.5 → 0.25").
  bool draw(Ui& ui, const FieldShading& shading, std::optional<plot::OpacityCurve>& curve);

 private:
  struct Ground;
  using Knots = std::vector<plot::OpacityKnot>;
  void follow(const FieldShading& shading);
  bool take_mouse(const Ui& ui, const Ground& ground, Knots& knots);
  bool take_keys(Ui& ui, Knots& knots) const;
  void draw_curve(Ui& ui, const FieldShading& shading, const Ground& ground, const plot::OpacityCurve& shown) const;
  bool draw_buttons(Ui& ui, Knots& knots);
  bool draw_typed(Ui& ui, plot::OpacityCurve& shown);

  std::uint64_t revision_ = 0;  ///< Of the shading that the next two are of.
  plot::OpacityCurve fitted_;
  std::vector<float> histogram_;  ///< By place on the scale of the colours, as shares of the fullest.
  std::size_t chosen_ = 0;
  bool dragging_ = false;
  std::string error_;  ///< Why what was typed is none.
};

}  // namespace trocar::ui
