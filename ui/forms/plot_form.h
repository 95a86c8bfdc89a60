/// Ask which figure of models and their rollouts is written, how wide, and where.
#pragma once

#include <string>
#include <utility>

#include "ui/forms/export_parts.h"
#include "ui/forms/form.h"

namespace trocar::ui {

class PlotForm final : public Form {
 public:
  /// With this figure chosen, as its panel shows it.
  void open_on(workbench::PlotSettings settings) {
    settings_ = std::move(settings);
    open();
  }

 protected:
  std::string_view title() const override { return "Export figure"; }
  float width() const override { return 500.0F; }
  void prepare(const WorkbenchState& state) override;
  Requests draw_content(Ui& ui, const WorkbenchState& state) override;

 private:
  void draw_kind(Ui& ui, const WorkbenchState& state);
  void draw_details(Ui& ui);
  std::string reason(const WorkbenchState& state) const;
  workbench::ExportPlot wanted() const;

  workbench::PlotSettings settings_;
  std::string path_;
  std::string slice_;
  PaperChoice paper_;
  bool brushed_ = true;  ///< Only what is brushed, if anything is.
  bool one_slice_ = false;
};

}  // namespace trocar::ui
