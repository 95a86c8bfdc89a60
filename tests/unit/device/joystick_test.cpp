#include "engine/device/joystick.h"

#include <doctest/doctest.h>
#include <fcntl.h>
#include <linux/joystick.h>
#include <sys/stat.h>
#include <unistd.h>

#include "tests/support/scratch_folder.h"

using namespace trocar;

namespace {

void write_event(int descriptor, int type, int number, int value) {
  js_event event{};
  event.type = static_cast<__u8>(type);
  event.number = static_cast<__u8>(number);
  event.value = static_cast<__s16>(value);
  REQUIRE(::write(descriptor, &event, sizeof event) == static_cast<ssize_t>(sizeof event));
}

}  // namespace

TEST_CASE("a gamepad is what its events have said so far, and an error once it is unplugged") {
  const testing::ScratchFolder folder;
  const std::string path = (folder / "js0").string();
  REQUIRE(::mkfifo(path.c_str(), 0600) == 0);
  auto pad = device::Joystick::open(path);
  REQUIRE(pad);
  const int writer = ::open(path.c_str(), O_WRONLY | O_NONBLOCK);
  REQUIRE(writer >= 0);
  CHECK(pad->look().value() == device::JoystickLook{});
  // What the driver says at first, of a pad that it knows as an Xbox one.
  write_event(writer, JS_EVENT_AXIS | JS_EVENT_INIT, 2, -32767);
  write_event(writer, JS_EVENT_AXIS, 0, 32767);
  write_event(writer, JS_EVENT_AXIS, 4, -32768);
  write_event(writer, JS_EVENT_BUTTON, 4, 1);
  write_event(writer, JS_EVENT_BUTTON, 0, 1);
  write_event(writer, JS_EVENT_BUTTON, 0, 0);
  // Of more sticks and buttons than we know, nothing.
  write_event(writer, JS_EVENT_AXIS, 200, 5);
  write_event(writer, JS_EVENT_BUTTON, 200, 1);
  const auto look = pad->look();
  REQUIRE(look);
  CHECK(look->axes[0] == 1.0F);
  CHECK(look->axes[3] == -1.0F);
  CHECK(look->axes[4] == -1.0F);
  CHECK(look->buttons == 1U << 4U);
  CHECK(pad->look().value() == *look);
  ::close(writer);
  CHECK(pad->look().error().code() == ErrorCode::kIo);
}

TEST_CASE("where no gamepad is, one sentence says so") {
  const auto pad = device::Joystick::open("/nowhere/js0");
  REQUIRE_FALSE(pad);
  CHECK(pad.error().text() == "no gamepad at /nowhere/js0: none is plugged in there");
}
