/// One act on the chosen demonstrations: what it would do to each, then one step of the history.
#pragma once

#include <set>
#include <string>

#include "ui/panel.h"

namespace trocar::ui {

class LibraryBatch {
 public:
  /// Draws the bar for `chosen`, and the list of what would change while an act is planned.
  void draw(Ui& ui, const WorkbenchState& state, const std::set<workbench::DemonstrationId>& chosen,
            Requests& requests);
  /// No act is planned.
  bool idle() const { return planned_.empty(); }

 private:
  void plan(std::string words, const std::set<workbench::DemonstrationId>& chosen, Requests& requests);
  void end(Requests& requests);
  void draw_acts(Ui& ui, const std::set<workbench::DemonstrationId>& chosen, Requests& requests);
  void draw_plan(Ui& ui, const WorkbenchState& state, Requests& requests);

  std::string words_;    ///< As typed.
  std::string planned_;  ///< What the plan is of; empty: there is none.
  std::string error_;
  std::set<workbench::DemonstrationId> of_;
};

}  // namespace trocar::ui
