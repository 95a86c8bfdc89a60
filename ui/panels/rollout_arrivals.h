/// Which share of the starts has arrived within so many steps, of one model or of two.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "ui/panel.h"

namespace trocar::ui {

class RolloutArrivals {
 public:
  void draw(Ui& ui, const std::shared_ptr<const workbench::ModelInsight>& insight);

 private:
  void update(const std::shared_ptr<const workbench::ModelInsight>& insight);
  std::string words_at(std::size_t step) const;
  void draw_curves(Ui& ui, const Rect& area) const;

  std::shared_ptr<const workbench::ModelInsight> of_;
  std::array<std::vector<int>, 2> arrived_;  ///< Of the first model and, if there is one, the second; equally long.
  int starts_ = 0;
};

}  // namespace trocar::ui
