/// The trials of the project, one a row, and what is said of the one that is selected.
#pragma once

#include <string>

#include "engine/workbench/project.h"
#include "ui/panel.h"

namespace trocar::ui {

class TrialList {
 public:
  void draw(Ui& ui, const WorkbenchState& state, Requests& requests);

 private:
  void draw_judgement(Ui& ui, const workbench::TrialEntry& trial, Requests& requests);

  std::string why_;  ///< Of what is excluded.
};

}  // namespace trocar::ui
