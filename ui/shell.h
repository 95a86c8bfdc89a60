/// The whole window: bars, tiles with their panels, forms, palette and keys. It turns acts into commands.
#pragma once

#include <imgui.h>

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ui/bars.h"
#include "ui/forms/demonstrations_form.h"
#include "ui/forms/export_forms.h"
#include "ui/forms/file_form.h"
#include "ui/forms/help_forms.h"
#include "ui/forms/import_form.h"
#include "ui/forms/keys_form.h"
#include "ui/forms/layouts_form.h"
#include "ui/forms/plot_form.h"
#include "ui/forms/quit_form.h"
#include "ui/forms/record_form.h"
#include "ui/forms/table_form.h"
#include "ui/palette.h"
#include "ui/panel.h"
#include "ui/settings.h"
#include "ui/status_line.h"
#include "ui/take_keys.h"
#include "ui/tile_area.h"

namespace trocar::ui {

/// What one frame asked for beyond the workbench.
struct ShellResult {
  std::vector<workbench::Command> commands;
  bool quit = false;
  bool restyle = false;                  ///< Theme or scale changed in the settings.
  std::optional<std::string> clipboard;  ///< To be copied.
};

/// Threads: that of the window.
class Shell {
 public:
  explicit Shell(Settings& settings);

  /// Draws one frame between ImGui's NewFrame and Render.
  /// `close_asked`: somebody wants the window to close.
  ShellResult draw(Ui& ui, const WorkbenchState& state, double frames_hz, bool close_asked);
  /// Of the last command that has a text, for the status line.
  const std::string& last_command() const { return status_.last_command; }

 private:
  Requests draw_host(Ui& ui, const WorkbenchState& state, double frames_hz);
  Requests draw_forms(Ui& ui, const WorkbenchState& state);
  Requests take_keys(Ui& ui, const WorkbenchState& state) const;
  /// True if the action opens a form, which is then open.
  bool open_form(UiAction action, const Ui& ui);
  /// True if it is about tiles.
  bool act_on_tiles(UiAction action, const Ui& ui);
  void arrange(Tile layout);
  void take_back(std::optional<Tile> layout, std::string_view none);
  void show_panel(PanelId panel);
  void choose_keys(const KeyChoices& keys);
  void tell(std::string words);
  void act(UiAction action, const Ui& ui, const WorkbenchState& state, ShellResult& result);
  void resolve(const Requests& requests, const Ui& ui, const WorkbenchState& state, ShellResult& result);
  /// A project that was dropped is opened, any other file looked at for import.
  Requests take_dropped(const Ui& ui, const WorkbenchState& state);
  bool form_open() const;

  Settings& settings_;
  std::shared_ptr<SharedTime> time_ = std::make_shared<SharedTime>();
  TileArea tiles_;
  LayoutHistory history_;
  RecordForm record_;
  FileForm file_;
  ImportForm import_;
  DemonstrationsForm demonstrations_;
  VideoForm video_;
  FieldForm field_;
  PlotForm plot_;
  TableForm table_;
  ShortcutForm shortcuts_;
  PageForm page_;
  KeysForm keys_{settings_};
  LayoutsForm layouts_{settings_};
  AboutForm about_;
  QuitForm quit_;
  Palette palette_;
  TakeKeys take_keys_;
  StatusLine status_;
  std::string seen_done_;  ///< What the workbench did last, as it was told.
  ImVec2 pointer_when_done_;
  std::shared_ptr<const Keymap> keymap_;
};

/// The scale in use: the settings' own, or the screen's.
float effective_scale(const Settings& settings, float content_scale);

}  // namespace trocar::ui
