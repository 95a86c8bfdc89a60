/// What runs, what was said, and what was done: jobs, log and history.
#pragma once

#include <set>

#include "ui/panel.h"

namespace trocar::ui {

class JobsPanel final : public Panel {
 public:
  Requests draw(Ui& ui, const WorkbenchState& state) override;
};

class LogPanel final : public Panel {
 public:
  Requests draw(Ui& ui, const WorkbenchState& state) override;

 private:
  std::size_t seen_ = 0;
};

/// The tree of edits, newest first; a click goes there.
class HistoryPanel final : public Panel {
 public:
  Requests draw(Ui& ui, const WorkbenchState& state) override;
};

}  // namespace trocar::ui
