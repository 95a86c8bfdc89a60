/// Our own file chooser for projects: folders and project files of one folder, and a line to type a path in.
#pragma once

#include <string>

#include "ui/forms/file_list.h"
#include "ui/forms/form.h"

namespace trocar::ui {

class FileForm final : public Form {
 public:
  void open_existing() { start(false); }
  void open_new() { start(true); }

 protected:
  std::string_view title() const override { return create_ ? "New project" : "Open project"; }
  float width() const override { return 560.0F; }
  float height() const override { return 470.0F; }
  void prepare(const WorkbenchState& state) override;
  Requests draw_content(Ui& ui, const WorkbenchState& state) override;

 private:
  void start(bool create);
  std::string reason() const;

  bool create_ = false;
  FileList list_{{".trocar"}};
  std::string typed_;  ///< File name, or a whole path.
};

}  // namespace trocar::ui
