#include "ui/forms/export_forms.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <system_error>

#include "ui/command_table.h"
#include "ui/icons.h"

namespace trocar::ui {
namespace {

std::string beside(const WorkbenchState& state, std::string_view ending) {
  std::filesystem::path path = state.path;
  path.replace_extension();
  return path.string() + std::string(ending);
}

// A demonstration's name as a file's: letters that a folder or a shell would take for its own become "-".
std::string file_name(std::string name) {
  constexpr std::string_view kUnfit = "/\\:*?\"<>|";
  std::replace_if(
      name.begin(), name.end(), [&](char c) { return kUnfit.find(c) != std::string_view::npos || c == '\0'; }, '-');
  return name.empty() || name.starts_with(".") ? "film" : name;
}

// Says so before a file is replaced.
bool export_button(Ui& ui, const char* sign, const std::string& path, const std::string& reason) {
  std::error_code error;
  const bool exists = !path.empty() && std::filesystem::exists(path, error);
  if (exists) wrapped_text(ui, "There is such a file already", ui.theme().warning);
  return button(
      ui, exists ? "Replace the file" : "Export",
      {.icon = sign, .reason = reason, .width = -1.0F, .style = exists ? ButtonStyle::kDanger : ButtonStyle::kPrimary});
}

}  // namespace

void VideoForm::prepare(const WorkbenchState& state) {
  const auto shown = selected_demonstration(state);
  path_ = (state.path.parent_path() / (file_name(shown == nullptr ? "film" : shown->name) + ".mp4")).string();
  beside_ = 0;
}

void VideoForm::draw_look(Ui& ui) {
  static const std::vector<std::string> kSizeNames{"1280×720", "1920×1080", "640×360"};
  static const std::vector<std::string> kRateNames{"25", "30", "60"};
  static const std::vector<std::string> kSpeedNames{"0.5×", "1×", "2×", "4×", "8×"};
  static const std::vector<std::string> kCameraNames{"Paper", "Top", "Side", "Front"};
  static const std::vector<std::string> kCodecNames{"Auto", "H.264", "MPEG-4", "FFV1", "MJPEG"};
  form_label(ui, "Size");
  segmented(ui, "Size", size_, kSizeNames, {.help = "In pixels"});
  form_label(ui, "Frames a second");
  segmented(ui, "Rate", rate_, kRateNames, {});
  form_label(ui, "Speed");
  segmented(ui, "Speed", speed_, kSpeedNames, {.help = "Seconds of the demonstration for each second of film"});
  form_label(ui, "Camera");
  segmented(ui, "Camera", camera_, kCameraNames, {.help = "From where it is filmed"});
  form_label(ui, "Codec");
  if (segmented(ui, "Codec", codec_, kCodecNames, {.help = "Sets the file's ending, too; FFV1 loses nothing"})) {
    constexpr std::array<const char*, 5> kEndings{".mp4", ".mp4", ".mp4", ".mkv", ".avi"};
    path_ = std::filesystem::path(path_).replace_extension(kEndings[static_cast<std::size_t>(codec_)]).string();
  }
  form_label(ui, "Captions");
  checkbox(ui, "Segments, jaws and pedals", captions_, {.help = "What is written below the picture"});
}

void VideoForm::draw_beside(Ui& ui, const WorkbenchState& state) {
  std::vector<std::string> names{"Alone"};
  others_.assign(1, workbench::DemonstrationId{});
  if (state.project != nullptr) {
    for (const auto& [id, shown] : state.project->demonstrations) {
      if (id == state.demonstration) continue;
      names.push_back(shown->name);
      others_.push_back(id);
    }
  }
  if (beside_ >= static_cast<int>(names.size())) beside_ = 0;
  form_label(ui, "Beside");
  combo(ui, "Beside", beside_, names, {.help = "A second demonstration, side by side"});
}

workbench::ExportVideo VideoForm::wanted(const WorkbenchState& state) const {
  constexpr std::array<std::array<int, 2>, 3> kPixels{{{1280, 720}, {1920, 1080}, {640, 360}}};
  constexpr std::array<double, 3> kRates_hz{25.0, 30.0, 60.0};
  constexpr std::array<double, 5> kSpeeds{0.5, 1.0, 2.0, 4.0, 8.0};
  workbench::ExportVideo video;
  video.demonstrations = {state.demonstration};
  if (beside_ > 0) video.demonstrations.push_back(others_[static_cast<std::size_t>(beside_)]);
  video.path = path_;
  video.width = kPixels[static_cast<std::size_t>(size_)][0];
  video.height = kPixels[static_cast<std::size_t>(size_)][1];
  video.fps = kRates_hz[static_cast<std::size_t>(rate_)];
  video.speed = kSpeeds[static_cast<std::size_t>(speed_)];
  video.camera = static_cast<scene::CameraPreset>(camera_);
  video.codec = static_cast<media::Codec>(codec_);
  video.captions = captions_;
  return video;
}

Requests VideoForm::draw_content(Ui& ui, const WorkbenchState& state) {
  form_label(ui, "File");
  text_field(ui, "File", path_, "film.mp4");
  draw_look(ui);
  draw_beside(ui, state);
  ImGui::Dummy({0.0F, ui.px(6)});
  const std::string reason = path_.empty() ? "Type a file name" : command("file.export_video").reason_now(state);
  if (!export_button(ui, icon::kFilm, path_, reason)) return {};
  close();
  return {workbench::Command{wanted(state)}, ShowPanel{PanelId::kJobs}};
}

void FieldForm::prepare(const WorkbenchState& state) {
  path_ = beside(state, fmt::format("-{}.png", learning::to_string(state.field.layer)));
  slice_ = "z=11";
}

Requests FieldForm::draw_content(Ui& ui, const WorkbenchState& state) {
  static const std::vector<std::string> kKinds{"All slices", "One slice"};
  form_label(ui, "Layer");
  ImGui::AlignTextToFramePadding();
  text(ui, learning::to_string(state.field.layer));
  form_label(ui, "What");
  segmented(ui, "What", kind_, kKinds, {});
  form_label(ui, "Slice");
  text_field(
      ui, "Slice", slice_, "z=11",
      {.help = "x=, y= or z= and the index of the cells", .reason = kind_ == 0 ? "All slices along z are drawn" : ""});
  form_label(ui, "File");
  text_field(ui, "File", path_, "field.png", {.help = ".png or .svg draws; .csv or .npy holds the numbers"});
  ImGui::Dummy({0.0F, ui.px(6)});
  const std::string reason = path_.empty() ? "Type a file name" : command("file.export_field").reason_now(state);
  if (!export_button(ui, icon::kDownload, path_, reason)) return {};
  close();
  return {workbench::Command{
              workbench::ExportField{state.model, state.field.layer, kind_ == 0 ? std::string() : slice_, path_}},
          ShowPanel{PanelId::kJobs}};
}

}  // namespace trocar::ui
