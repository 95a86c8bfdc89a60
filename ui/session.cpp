#include "ui/session.h"

#include <algorithm>
#include <utility>

namespace trocar::ui {

Session::Session(Window& window, Settings settings)
    : window_(window),
      settings_(std::move(settings)),
      context_(ImGui::CreateContext()),
      ui_(window.textures(), window.input()),
      shell_(settings_) {}

Session::~Session() = default;

Result<std::unique_ptr<Session>> Session::create(Window& window, Settings settings) {
  std::unique_ptr<Session> session(new Session(window, std::move(settings)));
  ImGui::SetCurrentContext(session->context_.get());
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;
  io.LogFilename = nullptr;
  io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset | ImGuiBackendFlags_HasMouseCursors;
  io.ConfigWindowsMoveFromTitleBarOnly = true;
  io.ConfigInputTextCursorBlink = false;
  io.ClipboardUserData = session.get();
  io.GetClipboardTextFn = [](void* data) {
    auto& self = *static_cast<Session*>(data);
    self.clipboard_ = self.window_.clipboard();
    return self.clipboard_.c_str();
  };
  io.SetClipboardTextFn = [](void* data, const char* text) {
    static_cast<Session*>(data)->window_.set_clipboard(text);
  };
  map_keys(io);
  session->last_s_ = window.now_s();
  TROCAR_RETURN_IF_ERROR(session->restyle());
  return session;
}

Status Session::restyle() {
  restyle_ = false;
  const float scale = effective_scale(settings_, window_.content_scale());
  ui_.set_theme(make_theme(settings_.theme));
  apply(ui_.theme(), scale, ImGui::GetStyle());
  if (ui_.fonts().body == nullptr || ui_.fonts().scale != scale) {
    ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
    TROCAR_ASSIGN_OR_RETURN(const Fonts fonts, build_fonts(atlas, scale));
    ui_.set_fonts(fonts);
    TROCAR_RETURN_IF_ERROR(window_.upload_fonts(atlas));
    settling_ = 3;
  }
  return {};
}

void Session::begin_input() {
  ImGuiIO& io = ImGui::GetIO();
  const WindowSize size = window_.size();
  io.DisplaySize = {static_cast<float>(std::max(size.width, 1)), static_cast<float>(std::max(size.height, 1))};
  const double now_s = window_.now_s();
  io.DeltaTime = static_cast<float>(std::clamp(now_s - last_s_, 1e-4, 0.25));
  ui_.set_gamepad(window_.gamepad());
  if (window_.input().apply(io) > 0) settling_ = std::max(settling_, 2);
}

double Session::measure_rate(double now_s) {
  const double dt_s = now_s - last_s_;
  last_s_ = now_s;
  // After a rest there is no rate to speak of.
  if (!show_rate_ || dt_s <= 0.0 || dt_s > 0.25) return 0.0;
  rate_hz_ = rate_hz_ == 0.0 ? 1.0 / dt_s : 0.9 * rate_hz_ + 0.1 / dt_s;
  return rate_hz_;
}

Result<ShellResult> Session::frame(const WorkbenchState& state, bool close_asked) {
  ImGui::SetCurrentContext(context_.get());
  if (restyle_ || effective_scale(settings_, window_.content_scale()) != ui_.scale()) {
    TROCAR_RETURN_IF_ERROR(restyle());
  }
  begin_input();
  const double rate_hz = measure_rate(window_.now_s());
  ImGui::NewFrame();
  ui_.begin_frame(window_.now_s());
  ShellResult result = shell_.draw(ui_, state, rate_hz, close_asked);
  ImGui::Render();
  restyle_ = result.restyle;
  if (settling_ > 0) --settling_;
  window_.set_cursor(ImGui::GetMouseCursor());
  TROCAR_RETURN_IF_ERROR(window_.present(*ImGui::GetDrawData(), ui_.theme().ground));
  if (result.clipboard) window_.set_clipboard(*result.clipboard);
  return result;
}

bool Session::restless() const {
  return window_.input().pending() || ui_.animating() || settling_ > 0 || restyle_;
}

}  // namespace trocar::ui
