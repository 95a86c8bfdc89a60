/// The tree of edits, newest first, its branches drawn; a click goes there, and nothing is ever lost.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/workbench/history_graph.h"
#include "ui/panel.h"

namespace trocar::ui {

/// Only the rows in sight are drawn, and only of them are pictures asked for.
class HistoryPanel final : public Panel {
 public:
  Requests draw(Ui& ui, const WorkbenchState& state) override;

 private:
  void follow(const WorkbenchState& state);
  void draw_bar(Ui& ui, const WorkbenchState& state, Requests& requests);
  void draw_row(Ui& ui, const WorkbenchState& state, const workbench::HistoryRow& row, Requests& requests);
  void draw_lanes(const Ui& ui, const workbench::HistoryRow& row, const Rect& rect, bool head) const;
  void draw_buttons(Ui& ui, const WorkbenchState& state, const workbench::HistoryRow& row, Requests& requests) const;
  /// Scrolls to where the project is, once it has moved.
  void keep_head_in_sight(const Ui& ui, const WorkbenchState& state);
  bool answers(const WorkbenchState& state, const workbench::HistoryRow& row) const;
  bool searching() const { return !search_.empty(); }

  std::vector<workbench::HistoryRow> rows_;
  std::vector<std::size_t> shown_;  ///< Into `rows_`: those that answer the search.
  int lanes_ = 1;                   ///< That are in use, of all rows.
  std::size_t of_count_ = 0;
  std::int64_t of_head_ = -1;
  std::string of_path_;
  std::string search_;
  std::string searched_;
  std::size_t searched_checkpoints_ = 0;
  std::string name_;       ///< Of the checkpoint at HEAD, as typed.
  std::string name_seen_;  ///< As it is kept.
  std::int64_t name_of_ = -1;
  std::int64_t in_sight_ = -1;
  std::vector<std::int64_t> asked_;  ///< Points whose pictures were asked for last.
};

}  // namespace trocar::ui
