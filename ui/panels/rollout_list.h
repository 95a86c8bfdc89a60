/// The rollouts one by one: a table of all measures, and small pictures in order of one of them.
#pragma once

#include <memory>
#include <vector>

#include "engine/learning/rollout_table.h"
#include "ui/panel.h"
#include "ui/panels/rollout_brush.h"

namespace trocar::ui {

/// The order in which the brushed rollouts are listed; worked out again only when they or the measure change.
class RolloutOrder {
 public:
  const std::vector<std::size_t>& of(const workbench::ModelInsight& insight, const RolloutBrush& brush,
                                     learning::RolloutMeasure by, bool descending);

 private:
  std::shared_ptr<const std::vector<learning::Rollout>> of_;
  learning::RolloutMeasure by_ = learning::RolloutMeasure::kStart;
  bool descending_ = false;
  int version_ = -1;  ///< Of the brush.
  std::vector<std::size_t> order_;
};

/// All measures, sorted by any; a click on a row makes its rollout stand out.
class RolloutTable {
 public:
  void draw(Ui& ui, const WorkbenchState& state, const RolloutBrush& brush, Requests& requests);

 private:
  RolloutOrder order_;
  learning::RolloutMeasure by_ = learning::RolloutMeasure::kStart;
  bool descending_ = false;
};

/// Side views of up to 24 rollouts, the first in the order of a measure, each as far as it has come in the play.
class RolloutMultiples {
 public:
  void draw(Ui& ui, const WorkbenchState& state, RolloutBrush& brush, Requests& requests);
  /// These pictures as a figure.
  workbench::PlotSettings plot() const;

 private:
  RolloutOrder order_;
  int by_ = static_cast<int>(learning::RolloutMeasure::kMaxDeviation);
  bool descending_ = true;
  int columns_ = 4;
};

}  // namespace trocar::ui
