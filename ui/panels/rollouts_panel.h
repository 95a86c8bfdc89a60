/// What the agent does from perturbed starts: shares that arrive, where the others end, and single rollouts.
#pragma once

#include "ui/panel.h"
#include "ui/panels/rollout_arrivals.h"
#include "ui/panels/rollout_axes.h"
#include "ui/panels/rollout_boxes.h"
#include "ui/panels/rollout_list.h"
#include "ui/panels/rollout_map.h"
#include "ui/panels/rollout_play.h"
#include "ui/panels/rollout_runs.h"
#include "ui/panels/rollout_starts.h"

namespace trocar::ui {

class RolloutsPanel final : public Panel {
 public:
  Requests draw(Ui& ui, const WorkbenchState& state) override;
  /// The keys that play, while all rollouts are to be played here.
  bool claims(const Ui& ui, const Chord& chord, const WorkbenchState& state) const override;

 private:
  void draw_ghosts(Ui& ui, const WorkbenchState& state, Requests& requests);
  void draw_spread(Ui& ui, const WorkbenchState& state, Requests& requests);
  /// Other ranges than those that are known are so everywhere, in the 3-D view too.
  void show_brushed(const WorkbenchState& state, Requests& requests) const;
  void draw_outcomes(Ui& ui, const WorkbenchState& state, Requests& requests);

  RolloutStarts starts_;
  RolloutMap map_;
  RolloutArrivals arrivals_;
  RolloutBoxes boxes_;
  RolloutBrush brush_;
  RolloutAxes axes_;
  RolloutTable table_;
  RolloutPlay play_;
  RolloutMultiples multiples_;
  RolloutRuns runs_;
  int page_ = 0;
};

}  // namespace trocar::ui
