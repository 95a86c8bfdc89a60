/// How far rollouts stray from the expert at their worst, by how they end and of which model: a box and points.
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

 private:
  struct Row {
    std::string name;  ///< "Arrives", "B arrives"
    learning::RolloutEnd end = learning::RolloutEnd::kArrives;
    learning::Spread spread;     ///< Metres.
    std::vector<double> points;  ///< Some of them, evenly; metres.
  };
  using Rollouts = std::shared_ptr<const std::vector<learning::Rollout>>;

  void update(const workbench::ModelInsight& insight);
  void add_rows(const std::vector<learning::Rollout>& rollouts, const std::string& before);
  void draw_row(Ui& ui, const Row& row, double most_m) const;

  Rollouts of_;
  Rollouts second_of_;
  std::vector<Row> rows_;
};

}  // namespace trocar::ui
