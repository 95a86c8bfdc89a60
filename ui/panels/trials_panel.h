/// Trials: what is to be run and by whom, the runner's screen while it runs, and what came of all of them.
#pragma once

#include <string>
#include <vector>

#include "engine/workbench/trial_results.h"
#include "ui/panel.h"
#include "ui/panels/trial_list.h"

namespace trocar::ui {

class TrialsPanel final : public Panel {
 public:
  Requests draw(Ui& ui, const WorkbenchState& state) override;

 private:
  void draw_setup(Ui& ui, const WorkbenchState& state, Requests& requests);
  void draw_who(Ui& ui, const WorkbenchState& state);
  /// A start of a rollout is one transfer of the block and by the model that it is of.
  void take_start(const WorkbenchState& state);
  void draw_devices(Ui& ui, const WorkbenchState& state);
  /// Somebody moves an arm who is no script.
  bool anybody() const { return operator_ != 0 || assistant_ != 0; }
  void draw_how(Ui& ui, const WorkbenchState& state, Requests& requests);
  void draw_console(Ui& ui, const workbench::ConsoleView& console);
  void draw_runner(Ui& ui, const WorkbenchState& state, Requests& requests);
  void draw_live(Ui& ui, const WorkbenchState& state);
  void draw_results(Ui& ui, const WorkbenchState& state, Requests& requests);
  workbench::StartTrials request(const WorkbenchState& state) const;
  /// Why they cannot be run; "" if they can.
  std::string reason(const WorkbenchState& state) const;

  int page_ = 0;
  std::optional<workbench::FromCell> start_;
  workbench::ModelId start_model_;  ///< Whose rollout began there.
  int protocol_ = 0;
  std::string protocol_file_;
  int mode_ = 1;
  int operator_ = 0;   ///< 0 script, 1 person, 2 console.
  int assistant_ = 0;  ///< Likewise 0 or 1; of a console its right hand.
  bool gamepad_ = false;
  bool space_mouse_ = false;
  bool looked_ = false;  ///< For devices.
  std::int64_t port_ = 5005;
  int skill_ = 0;
  int anchor_ = 0;
  std::int64_t transfers_ = 6;
  std::int64_t seed_ = 1;
  std::int64_t subject_ = 1;
  std::int64_t rate_ = 20;
  std::string delay_ = "0";
  bool realtime_ = true;
  bool in_turn_ = true;
  std::int64_t block_ = 0;
  TrialList list_;
  std::string file_ = "trials.csv";
  std::shared_ptr<const workbench::Project> of_;  ///< Whose results these are.
  workbench::TrialResults results_;
};

}  // namespace trocar::ui
