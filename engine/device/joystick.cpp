#include "engine/device/joystick.h"

#include <fcntl.h>
#include <linux/input-event-codes.h>
#include <linux/joystick.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

namespace trocar::device {
namespace {

constexpr std::array<int, 6> kAxes{ABS_X, ABS_Y, ABS_RX, ABS_RY, ABS_Z, ABS_RZ};
constexpr std::array<int, 6> kButtons{BTN_A, BTN_B, BTN_X, BTN_Y, BTN_TL, BTN_TR};
constexpr int kNone = -1;

template <std::size_t N>
int place_of(const std::array<int, N>& codes, int code) {
  const auto* const found = std::find(codes.begin(), codes.end(), code);
  return found == codes.end() ? kNone : static_cast<int>(found - codes.begin());
}

}  // namespace

struct Joystick::Impl {
  explicit Impl(int opened) : descriptor(opened) {}
  ~Impl() { ::close(descriptor); }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  /// Which of ours each of the device's is.
  void learn_map() {
    std::array<std::uint8_t, ABS_CNT> axis_codes{};
    if (::ioctl(descriptor, JSIOCGAXMAP, axis_codes.data()) >= 0) {
      for (std::size_t i = 0; i < axes.size(); ++i) axes[i] = place_of(kAxes, axis_codes[i]);
    }
    std::array<std::uint16_t, KEY_MAX - BTN_MISC + 1> button_codes{};
    if (::ioctl(descriptor, JSIOCGBTNMAP, button_codes.data()) >= 0) {
      for (std::size_t i = 0; i < buttons.size(); ++i) buttons[i] = place_of(kButtons, button_codes[i]);
    }
  }

  void take(const js_event& event) {
    const int type = event.type & ~JS_EVENT_INIT;
    if (type == JS_EVENT_AXIS && event.number < axes.size() && axes[event.number] != kNone) {
      now.axes[static_cast<std::size_t>(axes[event.number])] =
          std::clamp(static_cast<float>(event.value) / 32767.0F, -1.0F, 1.0F);
    }
    if (type == JS_EVENT_BUTTON && event.number < buttons.size() && buttons[event.number] != kNone) {
      const std::uint32_t bit = 1U << static_cast<unsigned>(buttons[event.number]);
      now.buttons = event.value != 0 ? now.buttons | bit : now.buttons & ~bit;
    }
  }

  int descriptor;
  std::array<int, 8> axes{0, 1, 4, 2, 3, 5, kNone, kNone};
  std::array<int, 16> buttons{0, 1, 2, 3, 4, 5, kNone, kNone, kNone, kNone, kNone, kNone, kNone, kNone, kNone, kNone};
  JoystickLook now;
};

Result<Joystick> Joystick::open(const std::filesystem::path& path) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  if (descriptor < 0) {
    const std::string_view why = errno == EACCES ? "its user may not read it" : "none is plugged in there";
    return fail(ErrorCode::kIo, "no gamepad at " + path.string() + ": " + std::string(why));
  }
  auto impl = std::make_unique<Impl>(descriptor);
  impl->learn_map();
  return Joystick(std::move(impl));
}

Joystick::Joystick(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Joystick::~Joystick() = default;
Joystick::Joystick(Joystick&&) noexcept = default;
Joystick& Joystick::operator=(Joystick&&) noexcept = default;

Result<JoystickLook> Joystick::look() {
  while (true) {
    js_event event{};
    const ssize_t count = ::read(impl_->descriptor, &event, sizeof event);
    if (count == static_cast<ssize_t>(sizeof event)) {
      impl_->take(event);
    } else if (count < 0 && errno == EINTR) {
      continue;
    } else if (count < 0 && errno == EAGAIN) {
      return impl_->now;
    } else {
      return fail(ErrorCode::kIo, "the gamepad was unplugged");
    }
  }
}

}  // namespace trocar::device
