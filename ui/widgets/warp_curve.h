/// A curve from old to new time that is drawn by its knots: with the mouse, or from the keyboard.
#pragma once

#include <Eigen/Core>
#include <string_view>
#include <vector>

#include "ui/widgets/widgets.h"

namespace trocar::ui {

/// Keeps which knot is meant, and a drag. Threads: that of the window.
class WarpCurve {
 public:
  /// As wide as what is left of the region. `knots` are those of `demonstration::warp_knots` but for the begin; the
  /// last one's old time is `end_s`, and stays. Returns true while they change. Drag a knot, double-click for a new
  /// one; with the keyboard on the curve the up and down arrows shift the chosen one. Its item has the role "plot";
  /// each knot is a "mark" ("Knot 1", "1.50 → 2.00 s").
  bool draw(Ui& ui, std::string_view label, double begin_s, double end_s, std::vector<Eigen::Vector2d>& knots);

 private:
  struct Ground;
  bool take_mouse(const Ui& ui, const Ground& ground, std::vector<Eigen::Vector2d>& knots);
  bool take_keys(Ui& ui, const Ground& ground, std::vector<Eigen::Vector2d>& knots) const;
  bool draw_buttons(Ui& ui, const Ground& ground, std::vector<Eigen::Vector2d>& knots);

  std::size_t chosen_ = 0;
  bool dragging_ = false;
  double high_s_ = 0.0;  ///< The latest new time that is shown; rests while a knot is dragged.
};

}  // namespace trocar::ui
