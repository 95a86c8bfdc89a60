/// What was learned, cell by cell: a layer as slices through the lattice, its colours, and a probe.
#pragma once

#include "ui/panel.h"
#include "ui/panels/field_probe.h"
#include "ui/panels/field_shading.h"
#include "ui/panels/field_slices.h"
#include "ui/panels/opacity_editor.h"

namespace trocar::ui {

class FieldsPanel final : public Panel {
 public:
  Requests draw(Ui& ui, const WorkbenchState& state) override;
  std::string shown_slice() const override { return slices_.focused(); }
  /// Keys that are this panel's while the pointer is over it and a field is shown: X, Y, Z and Ctrl+C.
  bool claims(const Ui& ui, const Chord& chord, const WorkbenchState& state) const override;

 private:
  void take_keys(Ui& ui, const WorkbenchState& state, Requests& requests);
  void draw_slices(Ui& ui, const WorkbenchState& state, Requests& requests);

  FieldShading shading_;
  FieldSlices slices_;
  FieldProbe probe_;
  OpacityEditor opacity_;
  bool montage_ = false;
  workbench::ModelId pinned_of_;
};

}  // namespace trocar::ui
