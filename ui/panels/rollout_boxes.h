/// Where the values of a measure lie, by how rollouts end and of which model: a box and points.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "engine/learning/rollout_table.h"
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
    learning::Spread spread;     ///< SI.
    std::vector<double> points;  ///< Some of them, evenly; SI.
  };
  using Rollouts = std::shared_ptr<const std::vector<learning::Rollout>>;

  void update(const workbench::ModelInsight& insight);
  void add_rows(const std::vector<learning::Rollout>& rollouts, const workbench::ModelInsight& insight,
                const std::string& before);
  void draw_row(Ui& ui, const Row& row, double low, double high) const;

  Rollouts of_;
  Rollouts second_of_;
  std::vector<Row> rows_;
  learning::RolloutMeasure measure_ = learning::RolloutMeasure::kMaxDeviation;
  learning::RolloutMeasure drawn_ = learning::RolloutMeasure::kStart;  ///< Whose `rows_` these are.
};

}  // namespace trocar::ui
