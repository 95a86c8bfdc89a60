/// A world's state as a value: copied, stored in a recording, restored exactly.
#pragma once

#include <string>

#include "engine/core/result.h"

namespace trocar::simulation {

/// Opaque bytes (about 2.7 kB), host byte order, with a version and the world's options at the front.
struct WorldSnapshot {
  std::string bytes;
  bool operator==(const WorldSnapshot&) const = default;
};

}  // namespace trocar::simulation
