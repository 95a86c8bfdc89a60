/// Asks who drives each arm, a person or a script, how, and with which block; then arms or starts the recording.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "ui/forms/form.h"

namespace trocar::ui {

class RecordForm final : public Form {
 protected:
  std::string_view title() const override { return "Record"; }
  float width() const override { return 640.0F; }
  void prepare(const WorkbenchState& state) override;
  Requests draw_content(Ui& ui, const WorkbenchState& state) override;
  bool has_footer() const override { return true; }
  Requests draw_footer(Ui& ui, const WorkbenchState& state) override;

 private:
  void draw_scripted(Ui& ui);
  void draw_by_hand(Ui& ui, const WorkbenchState& state);
  Requests draw_arm(Ui& ui, const WorkbenchState& state);
  Requests draw_start(Ui& ui, const WorkbenchState& state);
  void draw_arms(Ui& ui);
  void draw_replayed(Ui& ui, const WorkbenchState& state);
  void draw_way(Ui& ui);
  void draw_devices(Ui& ui, const WorkbenchState& state);
  void draw_task(Ui& ui, const std::string& reason);
  /// What the form would have recorded now.
  workbench::RecordByHand take(const WorkbenchState& state) const;
  bool replays() const;

  int who_ = 0;
  int skill_ = 0;
  std::int64_t seed_ = 1;
  int block_ = 0;
  int goal_ = 0;
  bool realtime_ = true;
  std::string name_;
  // By hand.
  std::array<int, 2> sources_{0, 1};  ///< Of the left and the right arm, as `trial::ArmSource`.
  int mode_ = 0;
  std::int64_t countdown_s_ = 3;
  bool pre_roll_ = false;
  bool punch_ = false;
  bool gamepad_ = false;
  bool space_mouse_ = false;
  bool looked_ = false;  ///< For devices, since it opened.
  int replayed_ = 0;
  std::vector<workbench::DemonstrationId> demonstrations_;
};

}  // namespace trocar::ui
