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
  /// Only the menu of the lanes, where there is no room for the row.
  void draw_lane_menu(Ui& ui, LaneSet& lanes) const;

 private:
  void draw_numbers(Ui& ui, const WorkbenchState& state, const demonstration::Demonstration& shown, Requests& requests);

  std::optional<workbench::TimeSpan> written_;  ///< The selection that the fields say.
  std::string from_;
  std::string to_;
};

}  // namespace trocar::ui
