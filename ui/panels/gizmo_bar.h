/// The row above the 3-D view while a tool is moved or turned: what, which arm, how far in numbers, and how far in
/// time.
#pragma once

#include <array>
#include <memory>
#include <string>

#include "engine/workbench/waypoint_draft.h"
#include "ui/panel.h"

namespace trocar::ui {

class GizmoBar {
 public:
  /// Nothing where no gizmo is shown.
  void draw(Ui& ui, const WorkbenchState& state, Requests& requests);

 private:
  void draw_choices(Ui& ui, const WorkbenchState& state, Requests& requests);
  void draw_displacement(Ui& ui, const WorkbenchState& state, const workbench::WaypointDraft& draft,
                         Requests& requests);
  void draw_reach(Ui& ui, const WorkbenchState& state, const workbench::WaypointDraft& draft, Requests& requests);
  void draw_facts(Ui& ui, const WorkbenchState& state, const workbench::WaypointDraft& draft);
  bool number(Ui& ui, std::string_view label, std::size_t field, double shown, double& typed, std::string_view help,
              bool focus);

  std::array<std::string, 4> texts_;  ///< x, y, z and the radius, as they are typed.
  std::array<bool, 4> typing_{};
  int axis_ = -1;         ///< For which the keyboard was put into its field.
  int frames_to_go_ = 0;  ///< Until it is, so that the key that asked for it is not typed there.
  float height_ = 0.0F;
};

}  // namespace trocar::ui
