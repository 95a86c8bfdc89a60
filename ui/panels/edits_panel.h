/// The edits of the selected demonstration: the stack, and a form for a new edit or for changing one of them.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/demonstration/edit_words.h"
#include "ui/panel.h"
#include "ui/widgets/warp_curve.h"

namespace trocar::ui {

class EditsPanel final : public Panel {
 public:
  Requests draw(Ui& ui, const WorkbenchState& state) override;
  void begin_edit(const BeginEdit& asked, const WorkbenchState& state) override;

 private:
  /// An edit that is being made; shown in the view as it would be.
  struct Draft {
    demonstration::DemonstrationId demonstration;
    std::int64_t entry = 0;  ///< Of the stack, to be changed; 0: a new edit.
    std::string name;        ///< Of the kind of edit.
    std::vector<demonstration::EditOption> options;
    std::int64_t copies = 0;  ///< Made of it with the edit; 0: it is edited itself.
    std::string problem;      ///< Why the parameters make no edit.
    std::shared_ptr<const demonstration::Demonstration> previewed;  ///< What the last preview was asked for.
  };

  void begin(const demonstration::Edit& edit, const workbench::Project& project,
             const demonstration::Demonstration& shown, std::int64_t entry);
  void draw_stack(Ui& ui, const WorkbenchState& state, const demonstration::Demonstration& shown, Requests& requests);
  void draw_entry(Ui& ui, const WorkbenchState& state, const demonstration::Demonstration& shown, int place,
                  Requests& requests);
  void draw_choice(Ui& ui, const WorkbenchState& state);
  bool draw_option(Ui& ui, const WorkbenchState& state, demonstration::EditOption& option);
  bool draw_warp(Ui& ui);
  void draw_draft(Ui& ui, const WorkbenchState& state, Requests& requests);
  void draw_outcome(Ui& ui, const WorkbenchState& state);
  void request_preview(Requests& requests);
  void commit(Requests& requests);
  void end(Requests& requests);

  std::optional<Draft> draft_;
  WarpCurve warp_;
  int kind_ = 0;
};

}  // namespace trocar::ui
