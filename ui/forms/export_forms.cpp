#include "ui/forms/export_forms.h"

#include <fmt/format.h>

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
  path_ = beside(state, ".mp4");
  beside_ = 0;
}

Requests VideoForm::draw_content(Ui& ui, const WorkbenchState& state) {
  static const std::vector<std::string> kSizes{"1280×720", "1920×1080", "640×360"};
  static const std::vector<std::string> kRates{"25", "30", "60"};
  constexpr std::array<std::array<int, 2>, 3> kPixels{{{1280, 720}, {1920, 1080}, {640, 360}}};
  constexpr std::array<double, 3> kHertz{25.0, 30.0, 60.0};
  std::vector<std::string> others{"Alone"};
  std::vector<workbench::DemonstrationId> ids{workbench::DemonstrationId{}};
  if (state.project != nullptr) {
    for (const auto& [id, shown] : state.project->demonstrations) {
      if (id == state.demonstration) continue;
      others.push_back(shown->name);
      ids.push_back(id);
    }
  }
  if (beside_ >= static_cast<int>(others.size())) beside_ = 0;
  form_label(ui, "File");
  text_field(ui, "File", path_, "film.mp4");
  form_label(ui, "Size");
  segmented(ui, "Size", size_, kSizes, {.help = "In pixels"});
  form_label(ui, "Frames a second");
  segmented(ui, "Rate", rate_, kRates, {});
  form_label(ui, "Beside");
  combo(ui, "Beside", beside_, others, {.help = "A second demonstration, side by side"});
  ImGui::Dummy({0.0F, ui.px(6)});
  const std::string reason = path_.empty() ? "Type a file name" : command("file.export_video").reason_now(state);
  if (!export_button(ui, icon::kFilm, path_, reason)) return {};
  workbench::ExportVideo video;
  video.demonstrations = {state.demonstration};
  if (beside_ > 0) video.demonstrations.push_back(ids[static_cast<std::size_t>(beside_)]);
  video.path = path_;
  video.width = kPixels[static_cast<std::size_t>(size_)][0];
  video.height = kPixels[static_cast<std::size_t>(size_)][1];
  video.fps = kHertz[static_cast<std::size_t>(rate_)];
  close();
  return {workbench::Command{video}, ShowPanel{PanelId::kJobs}};
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
