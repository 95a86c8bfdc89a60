/// The command palette: type a few letters, Enter does it.
#pragma once

#include <string>

#include "ui/panel.h"

namespace trocar::ui {

class Palette {
 public:
  void open();
  bool is_open() const { return open_; }
  Requests draw(Ui& ui, const WorkbenchState& state);

 private:
  void draw_rows(Ui& ui, const WorkbenchState& state, Requests& requests);
  bool open_ = false;
  bool focus_ = false;
  std::string typed_;
  int chosen_ = 0;
};

}  // namespace trocar::ui
