/// Where the values of a measure lie, by how rollouts end and of which model: a box and points.
#pragma once

#include <string>
#include <vector>

#include "engine/learning/rollout_spread.h"
#include "ui/panel.h"

namespace trocar::ui {

class RolloutBoxes {
 public:
  void draw(Ui& ui, const workbench::ModelInsight& insight);
  learning::RolloutMeasure measure() const { return measure_; }

 private:
  struct Row {
    std::string name;  ///< "Arrives", "B arrives"
    learning::RolloutEnd end = learning::RolloutEnd::kArrives;
    const learning::MeasureSpread* values = nullptr;
  };

  std::vector<Row> rows_of(const workbench::ModelInsight& insight) const;
  void draw_row(Ui& ui, const Row& row, double low, double high) const;

  learning::RolloutMeasure measure_ = learning::RolloutMeasure::kMaxDeviation;
};

}  // namespace trocar::ui
