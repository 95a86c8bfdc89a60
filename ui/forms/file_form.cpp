#include "ui/forms/file_form.h"

#include <algorithm>
#include <system_error>

#include "ui/format.h"
#include "ui/icons.h"

namespace trocar::ui {
namespace {

constexpr const char* kExtension = ".trocar";

}  // namespace

void FileForm::start(bool create) {
  create_ = create;
  open();
}

void FileForm::prepare(const WorkbenchState& state) {
  std::error_code error;
  std::filesystem::path folder = state.path.empty() ? std::filesystem::current_path(error) : state.path.parent_path();
  if (folder.empty()) folder = std::filesystem::current_path(error);
  typed_ = create_ ? std::string("project") + kExtension : "";
  go_to(std::filesystem::absolute(folder, error));
}

void FileForm::go_to(const std::filesystem::path& folder) {
  folder_ = folder;
  entries_.clear();
  read_error_.clear();
  std::error_code error;
  std::filesystem::directory_iterator it(folder, std::filesystem::directory_options::skip_permission_denied, error);
  if (error) {
    read_error_ = "This folder cannot be read: " + error.message();
    return;
  }
  for (; it != std::filesystem::directory_iterator(); it.increment(error)) {
    if (error) break;
    const std::string name = it->path().filename().string();
    const bool is_folder = it->is_directory(error);
    if (name.starts_with(".") || (!is_folder && it->path().extension() != kExtension)) continue;
    entries_.push_back({name, is_folder});
  }
  std::sort(entries_.begin(), entries_.end(),
            [](const Entry& a, const Entry& b) { return a.folder != b.folder ? a.folder : a.name < b.name; });
}

void FileForm::draw_list(Ui& ui) {
  const Scope scope(ui, "Files");
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ui.px(8), 0.0F});
  std::filesystem::path next;
  const auto row = [&](std::string_view name, const char* sign, bool selected) {
    const ImVec2 at = ImGui::GetCursorPos();
    const bool clicked = selectable_row(ui, name, selected, "", {.height = ui.px(26)});
    const ImVec2 after = ImGui::GetCursorPos();
    ImGui::SetCursorPos({at.x + ui.px(8), at.y + ui.px(4)});
    ImGui::TextUnformatted(
        (std::string(sign) + "   " + fitted(name, ImGui::GetContentRegionAvail().x - ui.px(44))).c_str());
    ImGui::SetCursorPos(after);
    return clicked;
  };
  if (folder_.has_parent_path() && folder_ != folder_.root_path() && row("Parent folder", icon::kArrowUp, false)) {
    next = folder_.parent_path();
  }
  for (const Entry& entry : entries_) {
    if (!row(entry.name, entry.folder ? icon::kFolder : icon::kFile, entry.name == typed_)) continue;
    if (entry.folder) {
      next = folder_ / entry.name;
    } else {
      typed_ = entry.name;
    }
  }
  ImGui::PopStyleVar();
  if (!read_error_.empty()) wrapped_text(ui, read_error_, ui.theme().danger);
  if (entries_.empty() && read_error_.empty()) dim_text(ui, "No folder and no project in here");
  if (!next.empty()) go_to(next);
}

std::string FileForm::reason() const {
  if (typed_.empty()) return create_ ? "Type a name for the project" : "Choose a project";
  std::error_code error;
  const std::filesystem::path path = folder_ / typed_;
  const bool exists = std::filesystem::exists(path, error);
  if (create_ && exists) return "There is such a file already";
  if (!create_ && !exists) return "There is no such file";
  return "";
}

Requests FileForm::draw_content(Ui& ui, const WorkbenchState&) {
  const std::string folder = shown_path(folder_);
  {
    const FontScope font(ui.fonts().small);
    const ColourScope dim(ImGuiCol_Text, ui.theme().text_dim);
    ImGui::TextUnformatted(fitted(folder, ImGui::GetContentRegionAvail().x).c_str());
    note_item(ui, "text", "Folder", folder, {.help = folder});
  }
  const float below = 2.0F * ImGui::GetFrameHeightWithSpacing() + ui.px(6);
  {
    const ColourScope ground(ImGuiCol_ChildBg, ui.theme().panel);
    ImGui::BeginChild("files", {0.0F, std::max(ImGui::GetContentRegionAvail().y - below, ui.px(90))});
    draw_list(ui);
    ImGui::EndChild();
  }
  form_label(ui, create_ ? "File name" : "File");
  text_field(ui, "File", typed_, "Name or path");
  const std::string why = reason();
  if (!button(ui, create_ ? "Create" : "Open",
              {.icon = create_ ? icon::kFile : icon::kFolder,
               .reason = why,
               .width = -1.0F,
               .style = ButtonStyle::kPrimary})) {
    return {};
  }
  std::filesystem::path path = folder_ / typed_;
  if (create_ && path.extension().empty()) path += kExtension;
  close();
  return {workbench::Command{workbench::OpenProject{path, create_}}};
}

}  // namespace trocar::ui
