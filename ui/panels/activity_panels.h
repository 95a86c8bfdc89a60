/// What runs and what was said: jobs and log.
#pragma once

#include <cstddef>

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

}  // namespace trocar::ui
