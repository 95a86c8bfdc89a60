/// Asks before quitting cuts off a recording or jobs; opened only if there are some.
#pragma once

#include "ui/forms/form.h"

namespace trocar::ui {

/// True if quitting now would cut something off.
bool something_runs(const WorkbenchState& state);

class QuitForm final : public Form {
 protected:
  std::string_view title() const override { return "Quit"; }
  float width() const override { return 440.0F; }
  Requests draw_content(Ui& ui, const WorkbenchState& state) override;
};

}  // namespace trocar::ui
