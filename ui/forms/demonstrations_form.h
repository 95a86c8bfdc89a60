/// Writes demonstrations for other programs: which, in what format, what is lost; and how reading them again went.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "engine/exchange/exchange.h"
#include "ui/forms/form.h"

namespace trocar::ui {

class DemonstrationsForm final : public Form {
 protected:
  std::string_view title() const override { return "Export demonstrations"; }
  float width() const override { return 560.0F; }
  float height() const override { return 600.0F; }
  void prepare(const WorkbenchState& state) override;
  Requests draw_content(Ui& ui, const WorkbenchState& state) override;

 private:
  struct Choice {
    bool chosen = false;
    std::string keys;  ///< Filter keys, separated by commas.
  };
  void draw_list(Ui& ui, const WorkbenchState& state);
  void draw_report(Ui& ui, const WorkbenchState& state);
  void draw_verdict(Ui& ui, const WorkbenchState& state) const;
  workbench::ExportDemonstrations wanted(const WorkbenchState& state) const;

  std::map<workbench::DemonstrationId, Choice> choices_;
  int format_ = 0;
  std::string path_;
  std::string problem_;                         ///< Why it cannot be written so.
  std::optional<std::filesystem::path> asked_;  ///< What was written from this form.
};

}  // namespace trocar::ui
