/// The project's demonstrations and models, and what can be done with them.
#pragma once

#include <map>
#include <string>

#include "ui/panel.h"
#include "ui/panels/library_table.h"

namespace trocar::ui {

class LibraryPanel final : public Panel {
 public:
  Requests draw(Ui& ui, const WorkbenchState& state) override;

 private:
  void draw_buttons(Ui& ui, const WorkbenchState& state, Requests& requests);
  void draw_demonstrations(Ui& ui, const WorkbenchState& state, bool wide, Requests& requests);
  void draw_models(Ui& ui, const WorkbenchState& state, bool wide, Requests& requests);
  void draw_trash(Ui& ui, const WorkbenchState& state, Requests& requests);
  void remember(const WorkbenchState& state);
  std::string arrival_of(workbench::ModelId id) const;

  LibraryTable table_;
  std::map<workbench::ModelId, std::string> arrival_;  ///< Of the models looked at so far.
};

}  // namespace trocar::ui
