/// What every panel is: it reads constant state, draws, and returns what the user asked for.
#pragma once

#include <memory>

#include "engine/workbench/workbench.h"
#include "ui/panels/time_range.h"
#include "ui/request.h"
#include "ui/shortcut.h"
#include "ui/widgets/widgets.h"

namespace trocar::ui {

using workbench::WorkbenchState;

/// Threads: that of the window.
class Panel {
 public:
  virtual ~Panel() = default;
  /// Called within the panel's region of the window, its scope ("Library") open.
  virtual Requests draw(Ui& ui, const WorkbenchState& state) = 0;
  /// Whether a chord is this panel's own while it is the current one (`TileArea::current`), and no command's.
  virtual bool claims(const Ui&, const Chord&, const WorkbenchState&) const { return false; }
  /// Opens the form of an edit, where the panel has one.
  virtual void begin_edit(const BeginEdit&, const WorkbenchState&) {}
  /// The slice of a field that is looked at, "z=11"; "" while there is none.
  virtual std::string shown_slice() const { return ""; }
};

/// `time` is what panels over time show; they share it.
std::unique_ptr<Panel> make_panel(PanelId panel, const std::shared_ptr<SharedTime>& time);

}  // namespace trocar::ui
