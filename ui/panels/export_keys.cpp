#include "ui/panels/export_keys.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "ui/format.h"
#include "ui/icons.h"
#include "ui/panels/common.h"

namespace trocar::ui {
namespace {

using film::CameraKey;
using film::CameraPath;
using film::View;
using workbench::FilmDraft;

/// Where the 3-D view's camera is about what it circles.
void take_orbit(CameraPath& path, const scene::OrbitCamera& orbit) {
  path.yaw_rad = orbit.azimuth_rad;
  path.elevation_rad = std::clamp(orbit.elevation_rad, -1.55, 1.55);
  path.distance_m = std::clamp(orbit.distance_m, 0.02, 1.0);
}

void draw_camera_keys(Ui& ui, CameraPath& path) {
  static const std::vector<std::string> kEases{"Even", "Smooth", "Hold", "Spline"};
  const Scope scope(ui, "Keys");
  std::size_t removed = path.keys.size();
  for (std::size_t i = 0; i < path.keys.size(); ++i) {
    const CameraKey& key = path.keys[i];
    const std::string name = seconds(key.t_s);
    const float left = ImGui::GetCursorPosX();
    const float wide = ImGui::GetContentRegionAvail().x;
    ImGui::PushID(static_cast<int>(i));
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(name.c_str());
    const std::string from =
        fmt::format("from {:.0f}, {:.0f}, {:.0f} mm", 1e3 * key.eye_m[0], 1e3 * key.eye_m[1], 1e3 * key.eye_m[2]);
    note_item(ui, "text", name, from, {});
    ImGui::SameLine(left + ui.px(70));
    const float words = wide - ui.px(70) - ui.px(38) - ui.px(110);
    {
      const ColourScope colour(ImGuiCol_Text, ui.theme().text_dim);
      ImGui::TextUnformatted(fitted(from, std::max(ui.px(20), words)).c_str());
    }
    const Scope own(ui, name);
    ImGui::SameLine(left + wide - ui.px(38) - ui.px(104));
    auto ease = static_cast<int>(key.ease);
    if (combo(ui, "Ease", ease, kEases,
              {.help = "How the camera goes on to the next key",
               .reason = i + 1 == path.keys.size() ? "Nothing comes after the last key" : "",
               .width = ui.px(104)})) {
      path.keys[i].ease = static_cast<film::Ease>(ease);
    }
    ImGui::SameLine(left + wide - ui.px(32));
    if (icon_button(ui, "Remove key",
                    {.icon = icon::kTrash,
                     .help = "The camera goes from the key before to the one after",
                     .reason = path.keys.size() == 1 ? "Choose another camera instead: this is its only key" : "",
                     .style = ButtonStyle::kQuiet})) {
      removed = i;
    }
    ImGui::PopID();
  }
  if (removed < path.keys.size()) path.keys.erase(path.keys.begin() + static_cast<std::ptrdiff_t>(removed));
}

}  // namespace

void draw_film_camera(Ui& ui, const WorkbenchState& state, FilmDraft& draft, Requests& requests) {
  static const std::vector<std::string> kCameras{"Paper", "Top",       "Side", "Front",
                                                 "Orbit", "Turntable", "Keys", "Follow the tool"};
  CameraPath& path = draft.film.sources[draft.source].camera;
  auto camera = static_cast<int>(path.view);
  form_label(ui, "Camera");
  if (combo(ui, "Camera", camera, kCameras,
            {.help = "Orbit, Turntable, Follow and Keys begin from where the 3-D view is"})) {
    path.view = static_cast<View>(camera);
    if (path.view == View::kOrbit || path.view == View::kTurntable || path.view == View::kFollow) {
      take_orbit(path, state.orbit);
    }
    if (path.view == View::kPoses && path.keys.empty()) draft = workbench::with_key(std::move(draft), state.orbit);
  }
  CameraPath& chosen = draft.film.sources[draft.source].camera;
  if (chosen.view == View::kTurntable) {
    auto turn = static_cast<float>(chosen.turn_s);
    form_label(ui, "A turn takes");
    if (slider_float(ui, "A turn takes", turn, 2.0F, 60.0F, "%.0f s", {.help = "Of the film, for once around"})) {
      chosen.turn_s = static_cast<double>(turn);
    }
  }
  if (chosen.view == View::kPoses) draw_camera_keys(ui, chosen);
  command_button(ui, state, "film.key", "Add key from view", ButtonStyle::kNormal, requests);
  flow(button_width(ui, "Remove source", icon::kTrash), ui.px(6));
}

}  // namespace trocar::ui
