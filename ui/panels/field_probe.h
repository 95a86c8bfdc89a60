/// All numbers of one cell, and of those that were pinned beside it.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ui/panel.h"

namespace trocar::ui {

class FieldProbe {
 public:
  /// The card of the cell `at`, then the table of the pinned ones. Precondition: there is an insight with a field.
  void draw(Ui& ui, const WorkbenchState& state, const spatial::CellCoordinates& at, Requests& requests);
  /// Once more: takes it off.
  void pin(const spatial::CellCoordinates& cell);
  void forget() { pinned_.clear(); }
  /// A header row, and one for each pinned cell; for `at` if none is.
  std::string csv(const WorkbenchState& state, const spatial::CellCoordinates& at);

 private:
  /// The margins of the selected model, made when it changes.
  void follow(const WorkbenchState& state);
  void draw_table(Ui& ui, const WorkbenchState& state, const spatial::CellCoordinates& at);

  std::vector<spatial::CellCoordinates> pinned_;
  std::shared_ptr<const learning::Model> margin_of_;
  std::shared_ptr<const learning::Field> margin_;
};

}  // namespace trocar::ui
