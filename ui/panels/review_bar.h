/// What becomes of a take by hand that has ended: a row above the 3-D view, which stays in sight.
#pragma once

#include "ui/panel.h"

namespace trocar::ui {

class ReviewBar {
 public:
  /// Draws nothing but while a take waits for its verdict.
  void draw(Ui& ui, const WorkbenchState& state, Requests& requests);

 private:
  float height_ = 0.0F;  ///< That it needs, pixels.
};

}  // namespace trocar::ui
