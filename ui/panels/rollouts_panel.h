/// What the agent does from perturbed starts: shares that arrive, where the others end, and single rollouts.
#pragma once

#include "ui/panel.h"

namespace trocar::ui {

class RolloutsPanel final : public Panel {
 public:
  Requests draw(Ui& ui, const WorkbenchState& state) override;

 private:
  void draw_controls(Ui& ui, const WorkbenchState& state, Requests& requests);
  int sort_column_ = 0;
  bool descending_ = false;
};

}  // namespace trocar::ui
