/// Which rows of the library are shown: the query as text, its terms as chips, and the filters that are saved.
#pragma once

#include <string>

#include "engine/workbench/library_query.h"
#include "ui/panel.h"

namespace trocar::ui {

class LibraryFilter {
 public:
  /// Draws the field and the chips. `shown` of `all` rows answer, `undecided` cannot be told yet.
  void draw(Ui& ui, const WorkbenchState& state, std::size_t shown, std::size_t all, std::size_t undecided,
            Requests& requests);
  /// What is asked; of a text that cannot be read, what was asked before it.
  const workbench::LibraryQuery& query() const { return query_; }
  /// Changes whenever the query does.
  std::uint64_t version() const { return version_; }
  void clear();

 private:
  void take(std::string text);
  void draw_saved(Ui& ui, const WorkbenchState& state, Requests& requests);
  void draw_chips(Ui& ui);

  std::string text_;
  std::string parsed_;
  std::string error_;
  std::string name_;
  workbench::LibraryQuery query_;
  std::uint64_t version_ = 0;
};

}  // namespace trocar::ui
