#include "engine/device/space_mouse.h"

#include <dlfcn.h>
#include <spnav.h>

#include <utility>

namespace trocar::device {
namespace {

/// The functions of libspnav that are used.
struct Functions {
  int (*open)() = nullptr;
  int (*close)() = nullptr;
  int (*poll_event)(spnav_event*) = nullptr;
};

template <typename Function>
bool find(void* library, const char* name, Function& function) {
  function = reinterpret_cast<Function>(::dlsym(library, name));
  return function != nullptr;
}

Result<Functions> load() {
  void* library = ::dlopen("libspnav.so.0", RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) {
    return fail(ErrorCode::kUnsupported, "libspnav is not installed, so a SpaceMouse cannot be used");
  }
  Functions functions;
  if (find(library, "spnav_open", functions.open) && find(library, "spnav_close", functions.close) &&
      find(library, "spnav_poll_event", functions.poll_event)) {
    return functions;
  }
  return fail(ErrorCode::kUnsupported, "libspnav is of another version, so a SpaceMouse cannot be used");
}

const Result<Functions>& functions() {
  static const Result<Functions> loaded = load();
  return loaded;
}

}  // namespace

struct SpaceMouse::Impl {
  explicit Impl(const Functions& library) : spnav(library) {}
  ~Impl() { spnav.close(); }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  Functions spnav;
  SpaceMouseLook now;
};

Result<SpaceMouse> SpaceMouse::open() {
  const Result<Functions>& library = functions();
  if (!library) return tl::unexpected(library.error());
  if (library->open() == -1) {
    return fail(ErrorCode::kUnsupported, "no SpaceMouse: its daemon (spacenavd) does not run");
  }
  return SpaceMouse(std::make_unique<Impl>(*library));
}

SpaceMouse::SpaceMouse(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
SpaceMouse::~SpaceMouse() = default;
SpaceMouse::SpaceMouse(SpaceMouse&&) noexcept = default;
SpaceMouse& SpaceMouse::operator=(SpaceMouse&&) noexcept = default;

SpaceMouseLook SpaceMouse::look() {
  spnav_event event;
  while (impl_->spnav.poll_event(&event) != 0) {
    if (event.type == SPNAV_EVENT_MOTION) {
      const spnav_event_motion& motion = event.motion;
      impl_->now.axes = {motion.x, motion.y, motion.z, motion.rx, motion.ry, motion.rz};
    } else if (event.type == SPNAV_EVENT_BUTTON && event.button.bnum >= 0 && event.button.bnum < 32) {
      const std::uint32_t bit = 1U << static_cast<unsigned>(event.button.bnum);
      impl_->now.buttons = event.button.press != 0 ? impl_->now.buttons | bit : impl_->now.buttons & ~bit;
    }
  }
  return impl_->now;
}

}  // namespace trocar::device
