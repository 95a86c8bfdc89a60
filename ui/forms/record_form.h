/// Asks how the scripted operators shall carry out a transfer, and starts the recording.
#pragma once

#include <cstdint>
#include <string>

#include "ui/forms/form.h"

namespace trocar::ui {

class RecordForm final : public Form {
 protected:
  std::string_view title() const override { return "Record"; }
  Requests draw_content(Ui& ui, const WorkbenchState& state) override;

 private:
  int skill_ = 0;
  std::int64_t seed_ = 1;
  int block_ = 0;
  int goal_ = 0;
  bool realtime_ = true;
  std::string name_;
};

}  // namespace trocar::ui
