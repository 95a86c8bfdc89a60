#include "ui/window/glfw_window.h"

#include <GL/glcorearb.h>
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include "engine/render/gl_functions.h"
#include "ui/gui_renderer.h"

namespace trocar::ui {
namespace {

std::string last_error() {
  const char* description = nullptr;
  glfwGetError(&description);
  return description == nullptr ? "no reason given" : description;
}

struct CloseGlfw {
  void operator()(GLFWwindow* window) const {
    glfwDestroyWindow(window);
    glfwTerminate();
  }
};
using WindowHandle = std::unique_ptr<GLFWwindow, CloseGlfw>;

class GlfwWindow final : public Window {
 public:
  explicit GlfwWindow(WindowHandle handle) : handle_(std::move(handle)) {}
  ~GlfwWindow() override {
    renderer_.reset();
    for (GLFWcursor* cursor : cursors_) {
      if (cursor != nullptr) glfwDestroyCursor(cursor);
    }
  }

  Status set_up();
  WindowSize size() const override;
  float content_scale() const override;
  double now_s() const override { return glfwGetTime(); }
  void poll(double timeout_s) override;
  bool wants_frame() const override { return damaged_ || input().pending(); }
  bool focused() const override { return glfwGetWindowAttrib(handle_.get(), GLFW_FOCUSED) != 0; }
  bool take_close_request() override;
  void set_title(const std::string& title) override;
  void set_cursor(ImGuiMouseCursor cursor) override;
  std::string clipboard() const override;
  void set_clipboard(const std::string& text) override { glfwSetClipboardString(handle_.get(), text.c_str()); }
  std::optional<trial::GamepadLook> gamepad() override;
  Status upload_fonts(ImFontAtlas& atlas) override;
  Status present(const ImDrawData& data, Rgba ground) override;
  Result<Image> capture() override;
  TextureStore& textures() override { return *renderer_; }

 private:
  static GlfwWindow& self(GLFWwindow* window) { return *static_cast<GlfwWindow*>(glfwGetWindowUserPointer(window)); }
  void listen();

  WindowHandle handle_;
  render::GlFunctions gl_;
  std::unique_ptr<GuiRenderer> renderer_;
  std::array<GLFWcursor*, ImGuiMouseCursor_COUNT> cursors_{};
  std::string title_;
  ImGuiMouseCursor cursor_ = ImGuiMouseCursor_Arrow;
  bool damaged_ = true;
};

Status GlfwWindow::set_up() {
  glfwMakeContextCurrent(handle_.get());
  glfwSwapInterval(1);
  TROCAR_ASSIGN_OR_RETURN(gl_, render::GlFunctions::load(&glfwGetProcAddress));
  TROCAR_ASSIGN_OR_RETURN(renderer_, GuiRenderer::create(gl_));
  cursors_[ImGuiMouseCursor_Arrow] = glfwCreateStandardCursor(GLFW_ARROW_CURSOR);
  cursors_[ImGuiMouseCursor_TextInput] = glfwCreateStandardCursor(GLFW_IBEAM_CURSOR);
  cursors_[ImGuiMouseCursor_ResizeEW] = glfwCreateStandardCursor(GLFW_HRESIZE_CURSOR);
  cursors_[ImGuiMouseCursor_ResizeNS] = glfwCreateStandardCursor(GLFW_VRESIZE_CURSOR);
  cursors_[ImGuiMouseCursor_Hand] = glfwCreateStandardCursor(GLFW_HAND_CURSOR);
  glfwGetError(nullptr);
  listen();
  return {};
}

void GlfwWindow::listen() {
  GLFWwindow* window = handle_.get();
  glfwSetWindowUserPointer(window, this);
  glfwSetCursorPosCallback(window, [](GLFWwindow* w, double x, double y) {
    // GLFW speaks in screen coordinates, the rest of us in pixels.
    int width = 1;
    int height = 1;
    glfwGetWindowSize(w, &width, &height);
    const WindowSize pixels = self(w).size();
    self(w).input().push(MouseMoved{static_cast<float>(x * pixels.width / std::max(width, 1)),
                                    static_cast<float>(y * pixels.height / std::max(height, 1))});
  });
  glfwSetCursorEnterCallback(window, [](GLFWwindow* w, int entered) {
    if (entered == 0) self(w).input().push(MouseMoved{-1e6F, -1e6F});
  });
  glfwSetMouseButtonCallback(window, [](GLFWwindow* w, int button, int action, int) {
    if (button < 5) self(w).input().push(MouseButton{button, action != GLFW_RELEASE});
  });
  glfwSetScrollCallback(window, [](GLFWwindow* w, double x, double y) {
    self(w).input().push(MouseWheel{static_cast<float>(x), static_cast<float>(y)});
  });
  glfwSetKeyCallback(window, [](GLFWwindow* w, int key, int, int action, int) {
    if (key > 0 && key < kKeyCount) self(w).input().push(KeyChanged{static_cast<Key>(key), action != GLFW_RELEASE});
  });
  glfwSetCharCallback(window, [](GLFWwindow* w, unsigned codepoint) { self(w).input().push(Typed{codepoint}); });
  glfwSetDropCallback(window, [](GLFWwindow* w, int count, const char** paths) {
    for (int i = 0; i < count; ++i) self(w).input().push(Dropped{paths[i]});
  });
  glfwSetWindowRefreshCallback(window, [](GLFWwindow* w) { self(w).damaged_ = true; });
  glfwSetWindowContentScaleCallback(window, [](GLFWwindow* w, float, float) { self(w).damaged_ = true; });
  glfwSetFramebufferSizeCallback(window, [](GLFWwindow* w, int, int) { self(w).damaged_ = true; });
}

WindowSize GlfwWindow::size() const {
  WindowSize size;
  glfwGetFramebufferSize(handle_.get(), &size.width, &size.height);
  return size;
}

float GlfwWindow::content_scale() const {
  float x = 1.0F;
  float y = 1.0F;
  glfwGetWindowContentScale(handle_.get(), &x, &y);
  return x;
}

void GlfwWindow::poll(double timeout_s) {
  if (timeout_s > 0.0 && !input().pending()) {
    glfwWaitEventsTimeout(timeout_s);
  } else {
    glfwPollEvents();
  }
}

bool GlfwWindow::take_close_request() {
  if (glfwWindowShouldClose(handle_.get()) == 0) return false;
  glfwSetWindowShouldClose(handle_.get(), GLFW_FALSE);
  return true;
}

std::optional<trial::GamepadLook> GlfwWindow::gamepad() {
  for (int stick = GLFW_JOYSTICK_1; stick <= GLFW_JOYSTICK_LAST; ++stick) {
    GLFWgamepadstate state;
    if (glfwJoystickIsGamepad(stick) == GLFW_FALSE || glfwGetGamepadState(stick, &state) == GLFW_FALSE) continue;
    trial::GamepadLook look;
    std::copy(std::begin(state.axes), std::end(state.axes), look.axes.begin());
    for (unsigned i = 0; i < std::size(state.buttons); ++i) {
      if (state.buttons[i] == GLFW_PRESS) look.buttons |= 1U << i;
    }
    return look;
  }
  return std::nullopt;
}

void GlfwWindow::set_title(const std::string& title) {
  if (title == title_) return;
  title_ = title;
  glfwSetWindowTitle(handle_.get(), title.c_str());
}

void GlfwWindow::set_cursor(ImGuiMouseCursor cursor) {
  if (cursor == cursor_ || cursor < 0 || cursor >= ImGuiMouseCursor_COUNT) return;
  cursor_ = cursor;
  GLFWcursor* shape = cursors_[static_cast<std::size_t>(cursor)];
  glfwSetCursor(handle_.get(), shape != nullptr ? shape : cursors_[ImGuiMouseCursor_Arrow]);
}

std::string GlfwWindow::clipboard() const {
  const char* text = glfwGetClipboardString(handle_.get());
  return text == nullptr ? "" : text;
}

Status GlfwWindow::upload_fonts(ImFontAtlas& atlas) {
  renderer_->upload_fonts(atlas);
  return {};
}

Status GlfwWindow::present(const ImDrawData& data, Rgba ground) {
  if (renderer_->draw(data, ground, std::exchange(damaged_, false))) glfwSwapBuffers(handle_.get());
  return {};
}

Result<Image> GlfwWindow::capture() {
  const WindowSize pixels = size();
  Image upside_down(pixels.width, pixels.height);
  gl_.BindFramebuffer(GL_FRAMEBUFFER, 0);
  gl_.ReadBuffer(GL_FRONT);
  gl_.PixelStorei(GL_PACK_ALIGNMENT, 1);
  gl_.ReadPixels(0, 0, pixels.width, pixels.height, GL_RGBA, GL_UNSIGNED_BYTE, upside_down.rgba.data());
  Image image(pixels.width, pixels.height);
  const std::size_t row = 4 * static_cast<std::size_t>(pixels.width);
  for (int y = 0; y < pixels.height; ++y) {
    const auto from = upside_down.rgba.begin() + static_cast<std::ptrdiff_t>(row) * (pixels.height - 1 - y);
    std::copy(from, from + static_cast<std::ptrdiff_t>(row), image.rgba.begin() + static_cast<std::ptrdiff_t>(row) * y);
  }
  return image;
}

}  // namespace

Result<std::unique_ptr<Window>> open_glfw_window(WindowSize size, const std::string& title) {
  if (glfwInit() == 0)
    return fail(ErrorCode::kUnsupported, "there is no display to open a window on (" + last_error() + ")");
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_DEPTH_BITS, 0);
  glfwWindowHint(GLFW_STENCIL_BITS, 0);
  WindowHandle handle(glfwCreateWindow(size.width, size.height, title.c_str(), nullptr, nullptr));
  if (handle == nullptr) {
    const std::string why = last_error();
    glfwTerminate();
    return fail(ErrorCode::kUnsupported, "no window with OpenGL 3.3 could be opened (" + why + ")");
  }
  auto window = std::make_unique<GlfwWindow>(std::move(handle));
  TROCAR_RETURN_IF_ERROR(window->set_up());
  return window;
}

}  // namespace trocar::ui
