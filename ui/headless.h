/// The workbench without a display: `trocar ui run` and `trocar ui dump`.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "engine/core/progress.h"
#include "engine/core/result.h"
#include "ui/theme.h"
#include "ui/tile_tree.h"

namespace trocar::ui {

struct UiRunOptions {
  std::filesystem::path project;     ///< Opened first; empty: none.
  std::filesystem::path script;      ///< Empty: none.
  std::filesystem::path screenshot;  ///< Written at the end; empty: none.
  int width = 1600;
  int height = 900;
  double scale = 1.0;  ///< 0.75 … 3.
  ThemeKind theme = ThemeKind::kDark;
  std::optional<PanelId> panel;        ///< Alone in the window; none: as the workspace has them.
  bool dump = false;                   ///< Fill `UiRunReport::dump`.
  const Progress* progress = nullptr;  ///< Cancelled: the run ends at the next frame, and all jobs with it.
};

struct UiRunReport {
  int lines = 0;  ///< Of the script that were run.
  int frames = 0;
  int screenshots = 0;
  double first_frame_s = 0.0;  ///< From the call to the first frame drawn.
  std::string dump;            ///< The list of widgets of the last frame, as a JSON array.
};

/// Draws off-screen and obeys the script; waits until the project is open and the picture is there before the first
/// line and before the last screenshot; a project that cannot be opened ends it there. Settings of the user are neither
/// read nor written.
///
/// Errors: kInvalidArgument for the size, the scale or the script, naming its line; kIo for a missing file,
/// kNotFound for a missing label; kCheckFailed for an expectation that does not hold, naming its line; kUnsupported
/// without OSMesa; kIo; kCancelled. Threads: call it in the main thread, where no GL context is current.
Result<UiRunReport> run_headless(const UiRunOptions& options);

}  // namespace trocar::ui
