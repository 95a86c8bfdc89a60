#include "ui/forms/file_form.h"

#include <system_error>

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
  typed_ = create_ ? std::string("project") + kExtension : "";
  list_.go_to(first_folder(state));
}

std::string FileForm::reason() const {
  if (typed_.empty()) return create_ ? "Type a name for the project" : "Choose a project";
  std::error_code error;
  const bool exists = std::filesystem::exists(list_.chosen(typed_), error);
  if (create_ && exists) return "There is such a file already";
  if (!create_ && !exists) return "There is no such file";
  return "";
}

Requests FileForm::draw_content(Ui& ui, const WorkbenchState&) {
  list_.draw(ui, typed_, "No folder and no project in here", 2.0F * ImGui::GetFrameHeightWithSpacing() + ui.px(6));
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
  std::filesystem::path path = list_.chosen(typed_);
  if (create_ && path.extension().empty()) path += kExtension;
  close();
  return {workbench::Command{workbench::OpenProject{path, create_}}};
}

}  // namespace trocar::ui
