/// The selected model beside trainings with other seeds: mean and spread of the field, what each seed gave, and what of
/// the paper's section V.A holds.
#pragma once

#include <array>

#include "ui/panel.h"
#include "ui/panels/field_shading.h"

namespace trocar::ui {

class SeedPage {
 public:
  /// `axis`: that the slices are cut across.
  void draw(Ui& ui, const WorkbenchState& state, int axis, Requests& requests);

 private:
  void draw_fields(Ui& ui, const WorkbenchState& state, int axis, Requests& requests);

  std::array<FieldShading, 2> shadings_;  ///< Mean, spread.
};

}  // namespace trocar::ui
