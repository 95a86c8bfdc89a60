#include "ui/widgets/ui.h"

#include <cmath>
#include <utility>

#include "ui/keymap.h"

namespace trocar::ui {

Ui::Ui(TextureStore& textures, InputQueue& input)
    : textures_(&textures), input_(&input), keymap_(std::make_shared<const Keymap>()) {}

float Ui::px(float at_100) const {
  return std::round(at_100 * fonts_.scale);
}

void Ui::begin_frame(double now_s) {
  items_.begin_frame();
  shown_hint_ = std::exchange(hint_, {});
  tooltip_.clear();
  now_s_ = now_s;
  animating_ = false;
  wheel_was_taken_ = std::exchange(wheel_taken_, false);
  if (!hovered_now_) {
    hovered_path_.clear();
    clicked_path_.clear();
  }
  hovered_now_ = false;
  const ImGuiIO& io = ImGui::GetIO();
  if (io.MouseDelta.x != 0.0F || io.MouseDelta.y != 0.0F) moved_since_click_ = true;
  if (ImGui::IsAnyMouseDown()) moved_since_click_ = false;
}

bool Ui::rested_on(std::string_view path) {
  constexpr double kRest_s = 0.4;
  hovered_now_ = true;
  if (ImGui::IsAnyMouseDown()) clicked_path_ = path;
  if (!moved_since_click_ || path == clicked_path_) return false;
  clicked_path_.clear();
  if (path != hovered_path_) {
    hovered_path_ = path;
    hovered_since_s_ = now_s_;
  }
  const bool rested = now_s_ - hovered_since_s_ >= kRest_s;
  if (!rested) animate();
  return rested;
}

Scope::Scope(Ui& ui, std::string_view name) : ui_(ui) {
  ui_.items().push(name);
  ImGui::PushID(name.data(), name.data() + name.size());
}

Scope::~Scope() {
  ImGui::PopID();
  ui_.items().pop();
}

}  // namespace trocar::ui
