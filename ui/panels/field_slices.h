/// A field as three slices through one cell, which the mouse moves; and all slices along z side by side.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "ui/panel.h"
#include "ui/panels/field_shading.h"

namespace trocar::ui {

class FieldSlices {
 public:
  /// Begins a frame: takes the slices in the view over, within the lattice; of another model than before, through its
  /// goal. Precondition: there is an insight with a field, which `shading` has.
  void update(const WorkbenchState& state);
  /// The slices, below or beside each other; room is left for the probe at `probe_at()`.
  void draw(Ui& ui, const WorkbenchState& state, FieldShading& shading, Requests& requests);
  /// True when a tile was chosen: its slice is the one along z now.
  bool draw_montage(Ui& ui, const WorkbenchState& state, FieldShading& shading, Requests& requests);

  /// Where the slices meet.
  spatial::CellCoordinates at() const { return {index_[0], index_[1], index_[2]}; }
  /// Under the mouse, if it is over a slice.
  const std::optional<spatial::CellCoordinates>& hovered() const { return hovered_; }
  /// Clicked with Shift held in this frame.
  const std::optional<spatial::CellCoordinates>& pinned() const { return pinned_; }
  /// Only this one is shown, large; the same once more: all three.
  void focus(int axis) { focus_ = focus_ == axis ? -1 : axis; }
  /// The large one, or else that along z: "z=11"; "" before any was shown.
  std::string focused() const;
  /// What is left beside the last slice; false: the probe goes below.
  bool beside() const { return beside_; }

 private:
  /// A slice with its slider in a cell of the given size.
  void draw_slice(Ui& ui, const WorkbenchState& state, FieldShading& shading, int axis, ImVec2 size,
                  Requests& requests);
  void draw_below(Ui& ui, const WorkbenchState& state, int axis, float right, Requests& requests);
  void take_mouse(int axis, const Rect& rect, bool hovered, const WorkbenchState& state, Requests& requests);
  void take_wheel(int axis, const WorkbenchState& state, Requests& requests);
  void draw_marks(Ui& ui, const WorkbenchState& state, int axis, const Rect& rect) const;
  void move_to(const spatial::CellCoordinates& cell, const WorkbenchState& state, Requests& requests);

  workbench::ModelId placed_for_;
  int n_ = 0;
  std::array<int, 3> index_{11, 11, 11};
  int focus_ = -1;
  bool beside_ = false;
  std::optional<spatial::CellCoordinates> hovered_;
  std::optional<spatial::CellCoordinates> pinned_;
};

}  // namespace trocar::ui
