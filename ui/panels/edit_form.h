/// The form of an edit that is being made or changed: its parameters, what it would do, and how it is committed.
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

/// Threads: that of the window.
class EditForm {
 public:
  /// With the parameters of `edit`. `entry`: that of the stack which is changed; 0: a new one.
  void begin(const demonstration::Edit& edit, const workbench::Project& project,
             const demonstration::Demonstration& shown, std::int64_t entry);
  /// A new one where it is most likely wanted; nothing if no demonstration is selected.
  void begin(const BeginEdit& asked, const WorkbenchState& state);
  bool open() const { return draft_.has_value(); }
  /// That the edit is of; only while it is open.
  demonstration::DemonstrationId demonstration() const { return draft_->demonstration; }
  /// Only while it is open; it may end by that.
  void draw(Ui& ui, const WorkbenchState& state, Requests& requests);
  /// Leaves everything as it is.
  void end(Requests& requests);

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

  bool draw_option(Ui& ui, const WorkbenchState& state, demonstration::EditOption& option);
  bool draw_warp(Ui& ui);
  void draw_outcome(Ui& ui, const WorkbenchState& state);
  void request_preview(Requests& requests);
  void commit(Requests& requests);

  std::optional<Draft> draft_;
  WarpCurve warp_;
};

}  // namespace trocar::ui
