#include "ui/forms/export_forms.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>

#include "engine/figure/field_figure.h"
#include "ui/command_table.h"
#include "ui/icons.h"

namespace trocar::ui {
namespace {

/// The kinds of file of a field: first what is drawn, last what has no slices.
constexpr std::array<std::string_view, 7> kFieldEndings{".png", ".svg", ".pdf", ".csv", ".npy", ".vti", ".h5"};
constexpr int kDrawnEndings = 3;
constexpr int kWholeEndings = 5;

// A demonstration's name as a file's: letters that a folder or a shell would take for its own become "-".
std::string file_name(std::string name) {
  constexpr std::string_view kUnfit = "/\\:*?\"<>|";
  std::replace_if(
      name.begin(), name.end(), [&](char c) { return kUnfit.find(c) != std::string_view::npos || c == '\0'; }, '-');
  return name.empty() || name.starts_with(".") ? "film" : name;
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
  static const std::vector<std::string> kCodecNames{"Auto", "H.264", "MPEG-4", "FFV1", "MJPEG", "VP9", "AV1", "GIF"};
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
    const std::string_view ending = media::usual_ending(static_cast<media::Codec>(codec_));
    path_ = std::filesystem::path(path_).replace_extension(ending).string();
  }
  form_label(ui, "Captions");
  checkbox(ui, "Segments, jaws and pedals", captions_, {.help = "What is written below the picture"});
  form_label(ui, "Overlays");
  checkbox(
      ui, "All of them", all_overlays_,
      {.help = "Metrics, tally, trail and the other side's ghost too, and captions in files of their own (.srt, .vtt)",
       .reason = captions_ ? "" : "The picture is left bare"});
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
    for (const auto& [id, trial] : state.project->trials) {
      if (id.value == state.demonstration.value) continue;
      names.push_back(trial->name);
      others_.push_back(workbench::DemonstrationId{id.value});
    }
  }
  if (beside_ >= static_cast<int>(names.size())) beside_ = 0;
  form_label(ui, "Beside");
  combo(ui, "Beside", beside_, names, {.help = "A second demonstration or trial in the same film"});
  static const std::vector<std::string> kSyncNames{"Clock", "Segments", "Grasp"};
  static const std::vector<std::string> kTwoNames{"Side by side", "Above", "Inset"};
  const std::string_view alone = beside_ == 0 ? "Nothing is beside it" : "";
  form_label(ui, "Together by");
  segmented(ui, "Together by", sync_, kSyncNames,
            {.help = "What begins together: all, each segment (the faster side waits), or the grasp", .reason = alone});
  form_label(ui, "Two as");
  segmented(ui, "Two as", two_, kTwoNames, {.help = "How the two pictures lie", .reason = alone});
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
  video.all_overlays = all_overlays_;
  video.sync = static_cast<film::Sync>(sync_);
  constexpr std::array<film::Layout, 3> kTwo{film::Layout::kSideBySide, film::Layout::kTopBottom,
                                             film::Layout::kPictureInPicture};
  video.two = kTwo[static_cast<std::size_t>(two_)];
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
  path_ = beside_project(state, fmt::format("-{}.png", learning::to_string(state.field.layer)));
  if (!shown_slice_.empty()) {
    slice_ = shown_slice_;
  } else {
    // As the panel Fields shows it at first: in the view, or through the goal.
    const bool known = state.insight && state.insight->entry;
    const int goal = known ? state.insight->entry->model->grid.coordinates(state.insight->entry->model->goal).z : 11;
    slice_ = fmt::format("z={}", state.field.slices[2] >= 0 ? state.field.slices[2] : goal);
  }
}

int FieldForm::kind_of_file() const {
  return place_of_ending(path_, kFieldEndings);
}

void FieldForm::draw_subject(Ui& ui, const WorkbenchState& state) {
  const std::string layer(learning::to_string(state.field.layer));
  const bool two = state.insight && state.insight->second;
  std::vector<std::string> names{layer};
  if (two) {
    const std::string pair =
        fmt::format("{} against {}", state.insight->second->entry->name, state.insight->entry->name);
    names.push_back(fmt::format("Difference in {}, {}", layer, pair));
    names.push_back("Policy change, " + pair);
    names.push_back("Outcomes, " + pair);
  }
  if (subject_ >= static_cast<int>(names.size())) subject_ = 0;
  form_label(ui, "Field");
  combo(ui, "Field", subject_, names, {.help = "The layer in the panel Fields, or what two models differ in"});
}

std::string FieldForm::reason(const WorkbenchState& state) const {
  const int file = kind_of_file();
  if (std::string why = command("file.export_field").reason_now(state); !why.empty()) return why;
  if (std::string why = reason_against_path(path_, state); !why.empty()) return why;
  if (file < 0) return "Choose a kind of file";
  if (kind_ == 0 || file >= kWholeEndings || !state.insight || !state.insight->entry) return "";
  const auto slice = figure::slice_from(slice_, state.insight->entry->model->grid);
  return slice ? "" : slice.error().text();
}

workbench::ExportField FieldForm::wanted(const WorkbenchState& state) const {
  workbench::ExportField field;
  field.model = state.model;
  field.layer = state.field.layer;
  field.mask = state.field.mask;
  field.path = path_;
  if (subject_ > 0) {
    field.against = state.learning.second;
    field.contrast = static_cast<workbench::FieldContrast>(subject_ - 1);
  }
  const int file = kind_of_file();
  if (kind_ == 1 && file < kWholeEndings) {
    field.slice = slice_;
    // As thick as it is shown.
    const std::size_t axis = slice_.starts_with("x") ? 0 : slice_.starts_with("y") ? 1 : 2;
    if (subject_ == 0 && !state.insight->field->categorical) {
      field.slab = state.field.slabs[axis];
      field.through = state.field.through;
    }
  }
  if (file < 0 || file >= kDrawnEndings) return field;
  // Limits and map are of the layer: a contrast has its own.
  if (subject_ == 0) {
    field.look.scale = state.field.scale;
    field.look.map = state.field.map;
    field.look.limits = state.field.limits;
  }
  field.look.vision = state.field.vision;
  field.look.preset = paper_.preset();
  field.look.transparent = paper_.transparent;
  if (file == 0 && paper_.paper > 0) field.look.dpi = static_cast<double>(paper_.dpi);
  return field;
}

Requests FieldForm::draw_content(Ui& ui, const WorkbenchState& state) {
  static const std::vector<std::string> kKinds{"All slices", "One slice"};
  static const std::vector<std::string> kFiles{"PNG", "SVG", "PDF", "CSV", "NPY", "VTI", "HDF5"};
  int file = kind_of_file();
  draw_subject(ui, state);
  form_label(ui, "Kind of file");
  if (segmented(ui, "Kind of file", file, kFiles,
                {.help = "Drawn in the colours of the window; or its numbers: as a table, for NumPy, VTK or HDF5"})) {
    const auto chosen = static_cast<std::size_t>(file);
    path_ = std::filesystem::path(path_).replace_extension(kFieldEndings[chosen]).string();
  }
  const std::string whole = file >= kWholeEndings ? "This file holds the whole lattice" : "";
  form_label(ui, "What");
  segmented(ui, "What", kind_, kKinds, {.reason = whole});
  form_label(ui, "Slice");
  const std::string no_slice = !whole.empty() ? whole : kind_ == 0 ? "All slices along z are drawn" : "";
  text_field(ui, "Slice", slice_, "z=11", {.help = "x=, y= or z= and the index of the cells", .reason = no_slice});
  draw_paper(ui, paper_, file >= 0 && file < kDrawnEndings, file == 0);
  form_label(ui, "File");
  text_field(ui, "File", path_, "field.png", {.help = "Its ending says what kind it is"});
  ImGui::Dummy({0.0F, ui.px(6)});
  const std::string why = reason(state);
  // What is wrong is said while it can be mended.
  if (!why.empty()) wrapped_text(ui, why, ui.theme().text_dim);
  if (!export_button(ui, icon::kDownload, path_, why)) return {};
  close();
  return {workbench::Command{wanted(state)}, ShowPanel{PanelId::kJobs}};
}

}  // namespace trocar::ui
