/// What was learned, cell by cell: a layer as three slices through the lattice, its colours, and a probe.
#pragma once

#include <array>
#include <optional>

#include "ui/panel.h"
#include "ui/panels/field_shading.h"

namespace trocar::ui {

class FieldsPanel final : public Panel {
 public:
  Requests draw(Ui& ui, const WorkbenchState& state) override;

 private:
  void draw_controls(Ui& ui, const WorkbenchState& state, Requests& requests);
  void draw_slices(Ui& ui, const WorkbenchState& state, Requests& requests);
  /// A slice with its slider in a cell of the given size.
  void draw_slice(Ui& ui, const WorkbenchState& state, int axis, ImVec2 size, Requests& requests);
  void take_mouse(int axis, const Rect& rect, bool hovered, const WorkbenchState& state, Requests& requests);
  void draw_marks(Ui& ui, const WorkbenchState& state, int axis, const Rect& rect) const;
  void move_to(const spatial::CellCoordinates& cell, const WorkbenchState& state, Requests& requests);
  void draw_probe(Ui& ui, const WorkbenchState& state);

  FieldShading shading_;
  workbench::ModelId placed_for_;
  std::array<int, 3> index_{11, 11, 11};
  std::optional<spatial::CellCoordinates> hovered_;  ///< Under the mouse in this frame.
};

}  // namespace trocar::ui
