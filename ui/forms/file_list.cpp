#include "ui/forms/file_list.h"

#include <algorithm>
#include <system_error>

#include "ui/format.h"
#include "ui/icons.h"

namespace trocar::ui {
namespace {

std::string lower_ending(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  for (char& c : ending) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c | 0x20) : c;
  return ending;
}

}  // namespace

std::filesystem::path first_folder(const WorkbenchState& state) {
  std::error_code error;
  std::filesystem::path folder = state.path.empty() ? std::filesystem::current_path(error) : state.path.parent_path();
  if (folder.empty()) folder = std::filesystem::current_path(error);
  return std::filesystem::absolute(folder, error);
}

void FileList::go_to(const std::filesystem::path& folder) {
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
    const bool shown =
        is_folder || std::find(endings_.begin(), endings_.end(), lower_ending(it->path())) != endings_.end();
    if (!name.starts_with(".") && shown) entries_.push_back({name, is_folder});
  }
  std::sort(entries_.begin(), entries_.end(),
            [](const Entry& a, const Entry& b) { return a.folder != b.folder ? a.folder : a.name < b.name; });
}

bool FileList::draw_rows(Ui& ui, std::string& typed, std::filesystem::path& next) {
  const Scope scope(ui, "Files");
  bool picked = false;
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
    if (!row(entry.name, entry.folder ? icon::kFolder : icon::kFile, entry.name == typed)) continue;
    if (entry.folder) {
      next = folder_ / entry.name;
    } else {
      typed = entry.name;
      picked = true;
    }
  }
  return picked;
}

bool FileList::draw(Ui& ui, std::string& typed, std::string_view none, float below) {
  const std::string folder = shown_path(folder_);
  {
    const FontScope font(ui.fonts().small);
    const ColourScope dim(ImGuiCol_Text, ui.theme().text_dim);
    ImGui::TextUnformatted(fitted(folder, ImGui::GetContentRegionAvail().x).c_str());
    note_item(ui, "text", "Folder", folder, {.help = folder});
  }
  const ColourScope ground(ImGuiCol_ChildBg, ui.theme().panel);
  ImGui::BeginChild("files", {0.0F, std::max(ImGui::GetContentRegionAvail().y - below, ui.px(90))});
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ui.px(8), 0.0F});
  std::filesystem::path next;
  const bool picked = draw_rows(ui, typed, next);
  ImGui::PopStyleVar();
  if (!read_error_.empty()) wrapped_text(ui, read_error_, ui.theme().danger);
  if (entries_.empty() && read_error_.empty()) dim_text(ui, none);
  ImGui::EndChild();
  if (!next.empty()) go_to(next);
  return picked;
}

}  // namespace trocar::ui
