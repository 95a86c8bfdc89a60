/// A gamepad as Linux has it without a window: /dev/input/js0 and the like.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>

#include "engine/core/result.h"

namespace trocar::device {

/// In the order that GLFW and SDL have: axes left x, left y, right x, right y, left trigger, right trigger (right and
/// down are positive, triggers rest at −1); buttons A, B, X, Y, left and right bumper.
struct JoystickLook {
  std::array<float, 6> axes{0.0F, 0.0F, 0.0F, 0.0F, -1.0F, -1.0F};
  std::uint32_t buttons = 0;  ///< Bit i: the i-th is down.
  bool operator==(const JoystickLook&) const = default;
};

/// What the kernel's driver calls the sticks and buttons decides which they are; where it does not say, they are those
/// of an Xbox pad. Threads: one at a time.
class Joystick {
 public:
  /// Errors: kIo in one sentence where there is none, or no right to read it.
  static Result<Joystick> open(const std::filesystem::path& path);
  ~Joystick();
  Joystick(Joystick&&) noexcept;
  Joystick& operator=(Joystick&&) noexcept;

  /// How it is held now. Never waits. Errors: kIo once it is unplugged.
  Result<JoystickLook> look();

 private:
  struct Impl;
  explicit Joystick(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace trocar::device
