/// ImGui, fonts, theme and shell on one window: one call draws one frame of the workbench.
#pragma once

#include <imgui.h>

#include <memory>

#include "ui/settings.h"
#include "ui/shell.h"
#include "ui/window/window.h"

namespace trocar::ui {

/// Threads: that of the window, which outlives this. At most one session draws at a time.
class Session {
 public:
  /// Errors: kNotFound when no font is installed.
  static Result<std::unique_ptr<Session>> create(Window& window, Settings settings);
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  /// Takes the input that waits in the window, draws, and returns what was asked for; theme, scale and clipboard are
  /// already seen to. Errors: those of the window, kNotFound for fonts.
  /// `close_asked`: somebody wants the window to close; the result says whether it shall.
  Result<ShellResult> frame(const WorkbenchState& state, bool close_asked = false);
  /// True if another frame is wanted at once: input waits, or something moves.
  bool restless() const;

  const ItemLog& items() const { return ui_.items(); }
  const Ui& ui() const { return ui_; }
  const Settings& settings() const { return settings_; }
  Settings& settings() { return settings_; }
  Window& window() { return window_; }
  /// Frames a second in the menu bar; off in scripts, whose pictures must not depend on the machine.
  void show_frame_rate(bool on) { show_rate_ = on; }

 private:
  Session(Window& window, Settings settings);
  Status restyle();
  void begin_input();
  double measure_rate(double now_s);

  struct Destroy {
    void operator()(ImGuiContext* context) const { ImGui::DestroyContext(context); }
  };
  Window& window_;
  Settings settings_;
  std::unique_ptr<ImGuiContext, Destroy> context_;
  Ui ui_;
  Shell shell_;
  std::string clipboard_;  ///< What ImGui was last given to paste.
  bool restyle_ = true;
  bool show_rate_ = false;
  double last_s_ = 0.0;
  double rate_hz_ = 0.0;
  int settling_ = 3;  ///< Frames that ImGui needs to find its sizes.
};

}  // namespace trocar::ui
