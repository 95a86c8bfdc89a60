/// What is wrong or odd about the selected demonstration, where it is, and what mends it.
#pragma once

#include <memory>
#include <string>

#include "ui/panel.h"

namespace trocar::ui {

class ProblemsPanel final : public Panel {
 public:
  Requests draw(Ui& ui, const WorkbenchState& state) override;

 private:
  void follow(const WorkbenchState& state, Requests& requests);
  void draw_simulation(Ui& ui, const WorkbenchState& state) const;
  void draw_list(Ui& ui, const WorkbenchState& state, Requests& requests);
  void draw_problem(Ui& ui, const WorkbenchState& state, const review::Problem& problem, Requests& requests);
  void draw_fix(Ui& ui, const WorkbenchState& state, const review::Problem& problem, Requests& requests);

  std::shared_ptr<const workbench::ReviewView> seen_;  ///< What the ids below are of.
  std::string selected_;                               ///< Id of the problem that is spelled out.
  std::string previewed_;                              ///< Id of the one whose fix the view shows.
};

}  // namespace trocar::ui
