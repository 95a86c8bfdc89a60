/// Ask which table of another program becomes a model, and of which demonstrations.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "ui/forms/file_list.h"
#include "ui/forms/form.h"

namespace trocar::ui {

class TableForm final : public Form {
 protected:
  std::string_view title() const override { return "Import Q-table"; }
  float width() const override { return 560.0F; }
  void prepare(const WorkbenchState& state) override;
  Requests draw_content(Ui& ui, const WorkbenchState& state) override;

 private:
  void draw_demonstrations(Ui& ui, const WorkbenchState& state);
  std::string reason(const WorkbenchState& state) const;
  workbench::ImportTable wanted(const WorkbenchState& state) const;

  FileList list_{{".npy", ".csv"}};
  std::string typed_;
  std::string name_;
  int kind_ = 0;
  int segment_ = 0;
  std::int64_t grid_ = 22;
  std::set<workbench::DemonstrationId> left_out_;
};

}  // namespace trocar::ui
