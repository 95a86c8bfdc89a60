/// The timeline's second row: the selection by number, what can be done with it, snapping, looping, which lanes show.
#pragma once

#include <optional>
#include <string>

#include "ui/panel.h"
#include "ui/panels/timeline_lanes.h"

namespace trocar::ui {

class TimelineTools {
 public:
  /// `lanes`: which are shown; changed by the menu.
  void draw(Ui& ui, const WorkbenchState& state, const demonstration::Demonstration& shown, LaneSet& lanes,
            Requests& requests);

 private:
  void draw_numbers(Ui& ui, const WorkbenchState& state, const demonstration::Demonstration& shown, Requests& requests);
  void draw_lane_menu(Ui& ui, LaneSet& lanes) const;

  std::optional<workbench::TimeSpan> written_;  ///< The selection that the fields say.
  std::string from_;
  std::string to_;
};

}  // namespace trocar::ui
