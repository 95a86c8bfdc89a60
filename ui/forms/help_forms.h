/// The sheet of all keys, the page about a panel, and what this program is.
#pragma once

#include "ui/forms/form.h"

namespace trocar::ui {

class ShortcutForm final : public Form {
 protected:
  std::string_view title() const override { return "Keyboard shortcuts"; }
  float width() const override { return 760.0F; }
  float height() const override { return 560.0F; }
  Requests draw_content(Ui& ui, const WorkbenchState& state) override;
};

/// What a panel is for, and all that can be done there.
class PageForm final : public Form {
 public:
  void open_on(PanelId panel);

 protected:
  std::string_view title() const override { return "Help"; }
  float width() const override { return 620.0F; }
  float height() const override { return 560.0F; }
  Requests draw_content(Ui& ui, const WorkbenchState& state) override;

 private:
  void draw_commands(Ui& ui) const;

  PanelId panel_ = PanelId::kView;
};

class AboutForm final : public Form {
 protected:
  std::string_view title() const override { return "About Trocar"; }
  float width() const override { return 440.0F; }
  Requests draw_content(Ui& ui, const WorkbenchState& state) override;
};

}  // namespace trocar::ui
