/// The demonstrations as a table: thumbnails, measures, sorting by any column, and choosing several.
#pragma once

#include <memory>
#include <set>
#include <string>
#include <vector>

#include "engine/workbench/library_columns.h"
#include "ui/panel.h"
#include "ui/panels/library_batch.h"
#include "ui/panels/library_filter.h"
#include "ui/panels/sketch.h"

namespace trocar::ui {

/// Only the rows in sight are drawn.
class LibraryTable {
 public:
  /// Fills `height` pixels, or what is left.
  void draw(Ui& ui, const WorkbenchState& state, float height, Requests& requests);

 private:
  void follow(const WorkbenchState& state);
  void sort_by(const workbench::LibraryColumn& column);
  void draw_heads(Ui& ui);
  void draw_row(Ui& ui, const WorkbenchState& state, std::size_t place, const std::string& name, Requests& requests);
  void draw_name(Ui& ui, const WorkbenchState& state, std::size_t place, const std::string& name, Requests& requests);
  void choose(std::size_t place, Requests& requests);
  void draw_choice(Ui& ui);
  bool draw_nothing(Ui& ui, const WorkbenchState& state);

  LibraryFilter filter_;
  LibraryBatch batch_;
  SketchCache sketches_;
  std::shared_ptr<const workbench::LibraryView> view_;  ///< Which the rows are of.
  std::vector<const workbench::LibraryRow*> rows_;      ///< Those that are shown, in their order.
  std::vector<std::string> names_;                      ///< Of them, each another.
  std::size_t undecided_ = 0;
  std::uint64_t filtered_ = 0;  ///< The filter's version that they are of.
  std::string sort_ = "id";
  bool descending_ = false;
  bool sorted_ = false;
  std::set<workbench::DemonstrationId> chosen_;
  workbench::DemonstrationId anchor_;  ///< Where a range that is chosen begins.
};

}  // namespace trocar::ui
