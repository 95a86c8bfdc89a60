/// The widgets that say which column of a table is what.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "engine/exchange/column_map.h"
#include "engine/exchange/table_preview.h"
#include "ui/widgets/widgets.h"

namespace trocar::ui {

/// Draws the map and changes it; numbers that are being typed are kept here.
class ColumnMapEditor {
 public:
  /// Returns true if the map was changed. `text`: it is a table of text, which can be cut in several ways.
  bool draw(Ui& ui, exchange::ColumnMap& map, const std::vector<exchange::TableColumn>& columns, bool text);

 private:
  bool draw_layout(Ui& ui, exchange::ColumnMap& map);
  bool draw_time(Ui& ui, exchange::TimeColumn& time);
  bool draw_arm(Ui& ui, exchange::ArmColumns& arm);
  bool draw_rotation(Ui& ui, exchange::ArmColumns& arm);
  bool draw_jaw(Ui& ui, exchange::ArmColumns& arm);
  bool draw_frame(Ui& ui, exchange::FrameMap& frame);
  bool choose(Ui& ui, std::string_view label, std::string& chosen, const std::vector<std::string>& names,
              std::string_view help);
  bool choose_column(Ui& ui, std::string_view label, exchange::ColumnName& chosen, std::string_view none = {});
  bool type_numbers(Ui& ui, std::string_view label, std::vector<double*> numbers, std::string_view help);

  const std::vector<exchange::TableColumn>* columns_ = nullptr;
  std::map<std::string, std::string> typed_;  ///< What stands in a field that has not been left yet, by its path.
};

}  // namespace trocar::ui
