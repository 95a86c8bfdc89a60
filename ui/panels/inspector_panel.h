/// All that is known of the selected demonstration and model; names can be edited here.
#pragma once

#include <string>

#include "ui/panel.h"

namespace trocar::ui {

/// Why it is unknown how a demonstration ends, as a sentence; "" if it is known.
std::string outcome_reason(const demonstration::Demonstration& shown);

class InspectorPanel final : public Panel {
 public:
  Requests draw(Ui& ui, const WorkbenchState& state) override;

 private:
  void draw_demonstration(Ui& ui, const WorkbenchState& state, Requests& requests);
  void draw_segments(Ui& ui, const WorkbenchState& state, const demonstration::Demonstration& shown,
                     Requests& requests);

  workbench::DemonstrationId named_;
  std::string name_;       ///< Being edited.
  std::string last_name_;  ///< As it was in the document.
};

}  // namespace trocar::ui
