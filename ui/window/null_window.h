/// A window that draws nothing: size, time and synthetic input, for tests of logic (microseconds a frame).
#pragma once

#include "ui/window/window.h"

namespace trocar::ui {

class NullWindow : public Window {
 public:
  explicit NullWindow(WindowSize size = {}) : size_(size) {}

  WindowSize size() const override { return size_; }
  void resize(WindowSize size) { size_ = size; }
  double now_s() const override { return static_cast<double>(frame_) / kFrames_hz; }
  void poll(double timeout_s) override;
  void set_title(const std::string& title) override { title_ = title; }
  const std::string& title() const { return title_; }
  void set_cursor(ImGuiMouseCursor cursor) override { cursor_ = cursor; }
  std::string clipboard() const override { return clipboard_; }
  void set_clipboard(const std::string& text) override { clipboard_ = text; }
  std::optional<trial::GamepadLook> gamepad() override { return gamepad_; }
  /// As if one were plugged in, and held so.
  void set_gamepad(std::optional<trial::GamepadLook> look) { gamepad_ = look; }
  Status upload_fonts(ImFontAtlas& atlas) override;
  Status present(const ImDrawData& data, Rgba ground) override;
  Result<Image> capture() override;
  TextureStore& textures() override { return textures_; }

 private:
  static constexpr double kFrames_hz = 60.0;
  WindowSize size_;
  std::int64_t frame_ = 0;
  std::string title_;
  std::string clipboard_;
  std::optional<trial::GamepadLook> gamepad_;
  ImGuiMouseCursor cursor_ = 0;
  NullTextures textures_;
};

}  // namespace trocar::ui
