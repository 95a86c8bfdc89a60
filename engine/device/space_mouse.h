/// A mouse of six axes (3Dconnexion's SpaceMouse and its kin), through spacenavd and libspnav.
#pragma once

#include <array>
#include <cstdint>
#include <memory>

#include "engine/core/result.h"

namespace trocar::device {

/// As libspnav has it: x right, y up, z away, then the turns about these; ±350 at most.
struct SpaceMouseLook {
  std::array<int, 6> axes{};
  std::uint32_t buttons = 0;  ///< Bit i: the i-th is down.
};

/// The library is loaded when the first is opened, so that no start pays for it. At most one is open at a time.
/// Threads: one at a time.
class SpaceMouse {
 public:
  /// Errors: kUnsupported in one sentence where the library or its daemon is missing.
  static Result<SpaceMouse> open();
  ~SpaceMouse();
  SpaceMouse(SpaceMouse&&) noexcept;
  SpaceMouse& operator=(SpaceMouse&&) noexcept;

  /// How it is held now. Never waits.
  SpaceMouseLook look();

 private:
  struct Impl;
  explicit SpaceMouse(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace trocar::device
