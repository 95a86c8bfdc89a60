#include "ui/panels/view_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "engine/workbench/studio.h"
#include "ui/format.h"
#include "ui/icons.h"
#include "ui/panels/common.h"

namespace trocar::ui {
namespace {

using workbench::Command;

constexpr int kWidest = 1280;  // Software rendering gets slow beyond; the picture is scaled up instead.

scene::OrbitCamera shown_orbit(const WorkbenchState& state) {
  return state.camera_preset ? orbit_of(scene::camera(*state.camera_preset)) : state.orbit;
}

scene::Camera shown_camera(const WorkbenchState& state) {
  return state.camera_preset ? scene::camera(*state.camera_preset) : state.orbit.camera();
}

// A panel's words and buttons on top of the picture stay legible on any ground.
void ground(Ui& ui, ImVec2 low, ImVec2 high) {
  ImGui::GetWindowDrawList()->AddRectFilled(low, high, to_u32(ui.theme().panel, 0.88F), ui.px(6));
}

void draw_axes(Ui& ui, const WorkbenchState& state, const Rect& rect) {
  struct Axis {
    const char* letter;
    Eigen::Vector3d direction;
    Rgba colour;
  };
  const Eigen::Matrix3d R_CW = shown_camera(state).X_WC.rotation().transpose();
  std::vector<Axis> axes{{"x", R_CW.col(0), {236, 110, 104, 255}},
                         {"y", R_CW.col(1), {116, 200, 120, 255}},
                         {"z", R_CW.col(2), {96, 164, 240, 255}}};
  // The farthest first, so that the nearest covers it.
  std::sort(axes.begin(), axes.end(), [](const Axis& a, const Axis& b) { return a.direction.z() > b.direction.z(); });
  const float length = ui.px(24);
  const ImVec2 centre{rect.x0 + ui.px(44), rect.y1 - ui.px(44)};
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const FontScope font(ui.fonts().small);
  for (const Axis& axis : axes) {
    const ImVec2 tip{centre.x + length * static_cast<float>(axis.direction.x()),
                     centre.y + length * static_cast<float>(axis.direction.y())};
    list.AddLine(centre, tip, to_u32(axis.colour), ui.px(2));
    list.AddCircleFilled(tip, ui.px(8), to_u32(axis.colour), 16);
    const ImVec2 size = ImGui::CalcTextSize(axis.letter);
    list.AddText({std::round(tip.x - 0.5F * size.x), std::round(tip.y - 0.5F * size.y)}, IM_COL32(16, 18, 21, 255),
                 axis.letter);
  }
}

void draw_camera_buttons(Ui& ui, const WorkbenchState& state, const Rect& rect, Requests& requests) {
  struct Preset {
    std::string_view name;
    std::string_view command;
    scene::CameraPreset preset;
  };
  constexpr std::array<Preset, 4> kPresets{{{"Paper", "view.camera_paper", scene::CameraPreset::kPaper},
                                            {"Top", "view.camera_top", scene::CameraPreset::kTop},
                                            {"Side", "view.camera_side", scene::CameraPreset::kSide},
                                            {"Front", "view.camera_front", scene::CameraPreset::kFront}}};
  float width = ui.px(6) + 3.0F * ui.px(2);
  for (const Preset& preset : kPresets) {
    width += ImGui::CalcTextSize(preset.name.data(), preset.name.data() + preset.name.size()).x + ui.px(18);
  }
  const ImVec2 at{rect.x0 + ui.px(10), rect.y0 + ui.px(10)};
  ground(ui, at, {at.x + width, at.y + ImGui::GetFrameHeight() + ui.px(6)});
  ImGui::SetCursorScreenPos({at.x + ui.px(3), at.y + ui.px(3)});
  for (std::size_t i = 0; i < kPresets.size(); ++i) {
    if (i > 0) ImGui::SameLine(0.0F, ui.px(2));
    const CommandRow& row = command(kPresets[i].command);
    if (toggle(ui, kPresets[i].name, state.camera_preset == kPresets[i].preset,
               {.help = row.help, .shortcut = shown_keys(ui, row.id)})) {
      append(requests, row.run(state));
    }
  }
}

// In the lower right corner where they do not fit beside the camera's.
void draw_layer_buttons(Ui& ui, const WorkbenchState& state, const Rect& rect, Requests& requests) {
  if (selected_model(state) == nullptr) return;
  const float cameras = item_rect().x1 + ui.px(3);
  const float width = ImGui::CalcTextSize("Field").x + ImGui::CalcTextSize("Ghosts").x + 2 * ui.px(18) + ui.px(8);
  ImVec2 at{rect.x1 - ui.px(10) - width, rect.y0 + ui.px(10)};
  if (at.x < cameras + ui.px(8)) at.y = rect.y1 - ImGui::GetFrameHeight() - ui.px(16);
  // Without room for either, the menu has them still.
  if (at.x < cameras + ui.px(8) && at.y < item_rect().y1 + ui.px(8)) return;
  ground(ui, at, {at.x + width, at.y + ImGui::GetFrameHeight() + ui.px(6)});
  ImGui::SetCursorScreenPos({at.x + ui.px(3), at.y + ui.px(3)});
  const CommandRow& field = command("view.field");
  if (toggle(ui, "Field", shows_field(state.field), {.help = field.help, .shortcut = shown_keys(ui, field.id)})) {
    append(requests, field.run(state));
  }
  ImGui::SameLine(0.0F, ui.px(2));
  const CommandRow& ghosts = command("view.ghosts");
  if (toggle(ui, "Ghosts", state.rollouts.ghosts, {.help = ghosts.help, .shortcut = shown_keys(ui, ghosts.id)})) {
    append(requests, ghosts.run(state));
  }
}

}  // namespace

scene::OrbitCamera orbit_of(const scene::Camera& camera) {
  // Turn about the point where the line of sight meets the height at which blocks are carried.
  constexpr double kHeight_m = 0.015;
  const Eigen::Vector3d forward = camera.X_WC.rotation().col(2);
  double distance_m = 0.24;
  if (forward.z() < -0.05) distance_m = (kHeight_m - camera.X_WC.p.z()) / forward.z();
  return scene::OrbitCamera::from(camera, std::clamp(distance_m, 0.05, 0.6));
}

void ViewPanel::follow_size(ImVec2 size, Requests& requests) {
  int width = std::max(static_cast<int>(size.x), 64);
  int height = std::max(static_cast<int>(size.y), 64);
  if (width > kWidest) {
    height = std::max(height * kWidest / width, 64);
    width = kWidest;
  }
  steady_frames_ = width == wanted_width_ && height == wanted_height_ ? steady_frames_ + 1 : 0;
  wanted_width_ = width;
  wanted_height_ = height;
  // While a splitter is dragged the old picture is stretched; a new size is asked for when it rests.
  const bool first = asked_width_ == 0;
  if ((first || steady_frames_ >= 2) && (width != asked_width_ || height != asked_height_)) {
    asked_width_ = width;
    asked_height_ = height;
    requests.emplace_back(Command{workbench::SetViewSize{width, height}});
  }
}

void ViewPanel::take_mouse(Ui& ui, const WorkbenchState& state, bool hovered, Requests& requests) {
  const ImGuiIO& io = ImGui::GetIO();
  scene::OrbitCamera orbit = shown_orbit(state);
  bool moved = false;
  // The way to where the button went down is no part of the drag.
  const bool begun = ImGui::IsItemActive() && !ImGui::IsItemActivated();
  const auto dragged = [begun](int mouse_button) { return begun && ImGui::IsMouseDragging(mouse_button, 0.0F); };
  if ((io.MouseDelta.x != 0.0F || io.MouseDelta.y != 0.0F) && dragged(0) && !io.KeyShift) {
    constexpr double kTurn_rad = 0.0075;
    orbit.orbit(-kTurn_rad * io.MouseDelta.x / ui.scale(), kTurn_rad * io.MouseDelta.y / ui.scale());
    moved = true;
  } else if ((io.MouseDelta.x != 0.0F || io.MouseDelta.y != 0.0F) && (dragged(0) || dragged(1) || dragged(2))) {
    const double metres = 0.83 * orbit.distance_m / std::max(wanted_height_, 1);
    orbit.pan(-metres * io.MouseDelta.x, metres * io.MouseDelta.y);
    moved = true;
  }
  if (hovered && io.MouseWheel != 0.0F) {
    orbit.zoom(std::pow(0.9, io.MouseWheel));
    moved = true;
  }
  if (moved) requests.emplace_back(Command{workbench::SetCamera{orbit}});
}

void ViewPanel::draw_picture(Ui& ui, const WorkbenchState& state, const Rect& rect) const {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (state.picture == nullptr || state.picture->empty()) {
    // As the picture's own ground.
    const ImU32 ground = state.light_backdrop ? IM_COL32(221, 225, 230, 255) : IM_COL32(30, 33, 38, 255);
    list.AddRectFilled({rect.x0, rect.y0}, {rect.x1, rect.y1}, ground);
    return;
  }
  const Image& picture = *state.picture;
  const bool exact =
      picture.width == static_cast<int>(rect.width()) && picture.height == static_cast<int>(rect.height());
  const ImTextureID texture = ui.textures().texture(exact ? "view" : "view (scaled)", picture, state.picture_number,
                                                    exact ? Sampling::kNearest : Sampling::kLinear);
  const float factor =
      std::max(rect.width() / static_cast<float>(picture.width), rect.height() / static_cast<float>(picture.height));
  const float u = 0.5F * rect.width() / (factor * static_cast<float>(picture.width));
  const float v = 0.5F * rect.height() / (factor * static_cast<float>(picture.height));
  list.AddImage(texture, {rect.x0, rect.y0}, {rect.x1, rect.y1}, {0.5F - u, 0.5F - v}, {0.5F + u, 0.5F + v});
}

// What the halves of the picture are of.
void ViewPanel::draw_halves(Ui& ui, const WorkbenchState& state, const Rect& rect) const {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddLine({rect.centre_x(), rect.y0}, {rect.centre_x(), rect.y1}, to_u32(ui.theme().line), ui.px(2));
  const FontScope font(ui.fonts().strong);
  for (const bool left : {true, false}) {
    std::string words;
    std::string name;
    if (state.picture_models) {
      words = fmt::format("{}  {}", left ? "A" : "B", (*state.picture_models)[left ? 0 : 1]);
      name = left ? "Model of the left half" : "Model of the right half";
    } else {
      const workbench::TimeSpan& edges = *state.picture_edges;
      words = fmt::format("{} {}", left ? "Begin" : "End", seconds(left ? edges.begin_s : edges.end_s));
      name = left ? "Begin of the cut" : "End of the cut";
    }
    const ImVec2 size = ImGui::CalcTextSize(words.c_str());
    const float middle = left ? 0.5F * (rect.x0 + rect.centre_x()) : 0.5F * (rect.centre_x() + rect.x1);
    const ImVec2 at{std::round(middle - 0.5F * size.x), rect.y1 - size.y - ui.px(20)};
    ground(ui, {at.x - ui.px(10), at.y - ui.px(5)}, {at.x + size.x + ui.px(10), at.y + size.y + ui.px(5)});
    list.AddText(at, to_u32(ui.theme().text), words.c_str());
    note_rect(ui, "text", name, words, {at.x, at.y, at.x + size.x, at.y + size.y});
  }
}

void ViewPanel::draw_overlays(Ui& ui, const WorkbenchState& state, const Rect& rect, Requests& requests) {
  draw_camera_buttons(ui, state, rect, requests);
  draw_layer_buttons(ui, state, rect, requests);
  const Rect buttons = item_rect();
  // Not under the buttons.
  if (rect.height() > ui.px(140)) draw_axes(ui, state, rect);
  take_.draw(ui, state, {shown_camera(state), rect}, buttons.y0 > rect.centre_y() ? buttons.y0 : rect.y1);
  if (state.picture == nullptr && state.picture_error.empty()) {
    ImGui::SetCursorScreenPos({rect.x1 - ui.px(40), rect.y1 - ui.px(40)});
    spinner(ui, ui.px(14), ui.theme().text_dim);
    note_rect(ui, "progress", "Drawing the first picture", "", item_rect());
  } else if (!state.picture_error.empty()) {
    const ImVec2 at{rect.x0 + ui.px(16), rect.centre_y() - ui.px(30)};
    ground(ui, at, {rect.x1 - ui.px(16), at.y + ui.px(84)});
    ImGui::SetCursorScreenPos({at.x + ui.px(14), at.y + ui.px(10)});
    ImGui::BeginGroup();
    heading(ui, std::string(icon::kWarning) + "  The view could not be drawn");
    wrapped_text(ui, state.picture_error, ui.theme().text_dim);
    ImGui::EndGroup();
    if (ImGui::SetCursorScreenPos({rect.x1 - ui.px(110), at.y + ui.px(12)});
        button(ui, "Retry", {.icon = icon::kRefresh})) {
      requests.emplace_back(Command{workbench::SetViewSize{asked_width_, asked_height_}});
    }
  }
}

Requests ViewPanel::draw(Ui& ui, const WorkbenchState& state) {
  Requests requests;
  if (draw_welcome(ui, state, requests)) return requests;
  gizmo_bar_.draw(ui, state, requests);
  review_bar_.draw(ui, state, requests);
  const ImVec2 size = ImGui::GetContentRegionAvail();
  follow_size(size, requests);
  const std::string value = state.picture == nullptr
                                ? ""
                                : std::to_string(state.picture->width) + "×" + std::to_string(state.picture->height);
  const bool hovered = canvas(ui, "Picture", size, value,
                              {.help = "Drag to turn, right or middle drag (or Shift) to shift, wheel to zoom"});
  ImGui::SetItemAllowOverlap();
  const Rect rect = item_rect();
  const bool halves = state.picture_edges || state.picture_models;
  ViewPort port{shown_camera(state), rect};
  if (halves) port.rect.x1 = rect.centre_x();
  if (state.picture_models) port.camera = workbench::half_camera(port.camera);
  bool taken = take_.take_mouse(ui, state, port, hovered, requests);
  // Handles of a tool belong to one picture; slices are the same in both halves.
  if (!taken && !halves) taken = gizmo_.take_mouse(ui, state, port, hovered, requests);
  if (!taken && !state.picture_edges) taken = slices_.take_mouse(ui, state, port, hovered, requests);
  if (!taken) take_mouse(ui, state, hovered, requests);
  draw_picture(ui, state, rect);
  const ImVec2 after = ImGui::GetCursorPos();
  if (!state.picture_edges) slices_.draw(ui, state, port);
  if (halves) {
    draw_halves(ui, state, rect);
  } else {
    gizmo_.draw(ui, state, port);
    take_.draw_marks(ui, state, port);
  }
  draw_overlays(ui, state, rect, requests);
  ImGui::SetCursorPos(after);
  return requests;
}

}  // namespace trocar::ui
