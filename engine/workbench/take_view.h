/// What is shown of a take by hand.
#pragma once

#include <string>

#include "engine/workbench/command.h"

namespace trocar::workbench {

/// From arming to the verdict.
struct TakeView {
  RecordByHand request;
  std::string name;        ///< That it will have.
  bool reviewing = false;  ///< It has ended and waits for the verdict.
  std::string summary;     ///< How it ended.
};

}  // namespace trocar::workbench
