#include "engine/control/arm.h"

#include <array>

namespace trocar::control {

std::string_view to_string(OperatingState state) {
  constexpr std::array<std::string_view, 4> kNames{"DISABLED", "ENABLED", "PAUSED", "FAULT"};
  return kNames[static_cast<std::size_t>(state)];
}

}  // namespace trocar::control
