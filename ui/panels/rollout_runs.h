/// Rollouts that take a while: erring at random, in the simulator; and the file of what was found.
#pragma once

#include <string>

#include "ui/panel.h"

namespace trocar::ui {

class RolloutRuns {
 public:
  void draw(Ui& ui, const WorkbenchState& state, Requests& requests);

 private:
  void draw_erring(Ui& ui, const WorkbenchState& state, Requests& requests);
  void draw_physics(Ui& ui, const WorkbenchState& state, Requests& requests);
  trial::PhysicsOptions physics_options() const;
  void draw_export(Ui& ui, const WorkbenchState& state, Requests& requests);
  /// Why such rows cannot be written; "" if they can.
  std::string no_rows(const WorkbenchState& state) const;

  float epsilon_ = 0.1F;
  std::int64_t runs_ = 100;
  std::int64_t seed_ = 1;
  std::int64_t world_seed_ = 1;
  bool continuous_ = false;
  float errs_ = 0.0F;  ///< Share of the actions, in the simulator.
  std::int64_t delay_ms_ = 0;
  float noise_mm_ = 0.0F;
  int rows_ = 0;  ///< As `workbench::RolloutRows`.
  std::string file_ = "rollouts.csv";
};

}  // namespace trocar::ui
