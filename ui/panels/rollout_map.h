/// Slices through what becomes of every start: a click selects one, and regions of starts are painted.
#pragma once

#include <memory>
#include <string>

#include "ui/panel.h"
#include "ui/panels/field_shading.h"

namespace trocar::ui {

class RolloutMap {
 public:
  void draw(Ui& ui, const WorkbenchState& state, Requests& requests);
  /// The one that is shown, "x=7".
  std::string slice() const;

 private:
  enum class Mouse { kSelect, kPaint, kErase };
  std::shared_ptr<const learning::Field> field(Ui& ui, const WorkbenchState& state);
  void take_mouse(const WorkbenchState& state, const Rect& rect, bool hovered, Requests& requests);
  void brush(const spatial::Grid& grid, const spatial::CellCoordinates& middle);
  void draw_marks(Ui& ui, const WorkbenchState& state, const Rect& rect) const;

  FieldShading shading_;
  std::shared_ptr<const workbench::ModelEntry> of_;  ///< Whose `outcomes_` these are.
  std::shared_ptr<const learning::Field> outcomes_;
  spatial::CellSet chosen_;  ///< The starts, as a set.
  std::shared_ptr<const workbench::ModelInsight> chosen_of_;
  int shown_ = 0;
  int axis_ = 0;
  int index_ = 0;
  int mouse_ = 0;
  int radius_ = 1;
  bool painting_ = false;
  std::optional<spatial::CellCoordinates> hovered_;
};

}  // namespace trocar::ui
