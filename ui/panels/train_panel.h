/// The form that starts a training: which demonstrations, which segment, which method, and its few numbers.
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
  void draw_options(Ui& ui);
  std::string reason(const WorkbenchState& state) const;

  std::set<workbench::DemonstrationId> left_out_;
  int method_ = 2;
  int segment_ = 0;
  float epsilon_ = 0.1F;
  std::int64_t episodes_ = 10000;
  std::int64_t seed_ = 1;
  std::int64_t grid_ = 22;
  std::string name_;
};

}  // namespace trocar::ui
