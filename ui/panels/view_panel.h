/// The 3-D picture: turn, shift and zoom with the mouse, choose a camera, move and turn the tools; a banner while a
/// transfer is recorded.
#pragma once

#include <optional>

#include "ui/panel.h"
#include "ui/panels/gizmo_bar.h"
#include "ui/panels/gizmo_overlay.h"
#include "ui/panels/review_bar.h"
#include "ui/panels/slice_overlay.h"
#include "ui/panels/take_overlay.h"

namespace trocar::ui {

class ViewPanel final : public Panel {
 public:
  Requests draw(Ui& ui, const WorkbenchState& state) override;

 private:
  void follow_size(ImVec2 size, Requests& requests);
  void take_mouse(Ui& ui, const WorkbenchState& state, bool hovered, Requests& requests);
  void draw_picture(Ui& ui, const WorkbenchState& state, const Rect& rect) const;
  void draw_halves(Ui& ui, const WorkbenchState& state, const Rect& rect) const;
  void draw_overlays(Ui& ui, const WorkbenchState& state, const Rect& rect, Requests& requests);

  GizmoBar gizmo_bar_;
  ReviewBar review_bar_;
  GizmoOverlay gizmo_;
  SliceOverlay slices_;
  TakeOverlay take_;
  int asked_width_ = 0;
  int asked_height_ = 0;
  int wanted_width_ = 0;
  int wanted_height_ = 0;
  int steady_frames_ = 0;
};

/// The orbit that shows what a preset camera shows, so that turning goes on from there.
scene::OrbitCamera orbit_of(const scene::Camera& camera);

}  // namespace trocar::ui
