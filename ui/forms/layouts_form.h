/// Layouts of the workspace by name: keep this one, go to another, rename, delete.
#pragma once

#include <optional>
#include <string>

#include "ui/forms/form.h"
#include "ui/settings.h"

namespace trocar::ui {

class LayoutsForm final : public Form {
 public:
  /// `settings` outlives this.
  explicit LayoutsForm(const Settings& settings) : settings_(settings) {}

 protected:
  std::string_view title() const override { return "Layouts"; }
  float width() const override { return 460.0F; }
  void prepare(const WorkbenchState& state) override;
  Requests draw_content(Ui& ui, const WorkbenchState& state) override;

 private:
  void draw_layout(Ui& ui, const NamedLayout& layout, Requests& requests);
  void draw_renaming(Ui& ui, Requests& requests);
  void draw_saving(Ui& ui, Requests& requests);

  const Settings& settings_;
  std::string name_;
  std::string renamed_;  ///< The one that is being renamed; "": none.
  std::string new_name_;
  std::optional<NamedLayout> deleted_;  ///< The last one, to be brought back.
};

}  // namespace trocar::ui
