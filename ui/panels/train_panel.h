/// The form that starts a training: demonstrations, segment, a preset and every hyperparameter; and how the training of
/// the selected model went, epoch by epoch.
#pragma once

#include <cstdint>
#include <set>
#include <string>

#include "ui/panel.h"

namespace trocar::ui {

class TrainPanel final : public Panel {
 public:
  Requests draw(Ui& ui, const WorkbenchState& state) override;

 private:
  void draw_choice(Ui& ui, const WorkbenchState& state);
  void draw_method(Ui& ui);
  void draw_parameters(Ui& ui);
  /// The curve of the training that runs, and how to stop it.
  void draw_running(Ui& ui, const WorkbenchState& state, Requests& requests);
  void draw_history(Ui& ui, const WorkbenchState& state, Requests& requests);
  /// Goes on by an epoch when the last one has been shown.
  void play(Ui& ui, const WorkbenchState& state, Requests& requests);
  std::string reason(const WorkbenchState& state) const;
  workbench::TrainModel training(const WorkbenchState& state) const;

  std::set<workbench::DemonstrationId> left_out_;
  learning::TrainOptions options_ = learning::options_of(learning::Preset::kExact);
  int segment_ = 0;
  std::int64_t grid_ = 22;
  std::string name_;
  bool all_parameters_ = false;
  bool playing_ = false;
};

}  // namespace trocar::ui
