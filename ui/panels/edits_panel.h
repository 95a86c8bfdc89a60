/// The edits of the selected demonstration: the stack, and a form for a new edit or for changing one of them.
#pragma once

#include "ui/panel.h"
#include "ui/panels/edit_form.h"

namespace trocar::ui {

class EditsPanel final : public Panel {
 public:
  Requests draw(Ui& ui, const WorkbenchState& state) override;
  void begin_edit(const BeginEdit& asked, const WorkbenchState& state) override;

 private:
  void draw_stack(Ui& ui, const WorkbenchState& state, const demonstration::Demonstration& shown, Requests& requests);
  void draw_entry(Ui& ui, const WorkbenchState& state, const demonstration::Demonstration& shown, int place,
                  Requests& requests);
  void draw_choice(Ui& ui, const WorkbenchState& state);

  EditForm form_;
  int kind_ = 0;
};

}  // namespace trocar::ui
