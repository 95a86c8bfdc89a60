/// The manual, made from the tables that the window itself is made of: `trocar ui manual`.
#pragma once

#include <filesystem>
#include <string>

#include "engine/core/progress.h"
#include "engine/core/result.h"

namespace trocar::ui {

struct ManualOptions {
  std::filesystem::path folder;   ///< Made if it is missing; pages of these names are replaced.
  std::filesystem::path project;  ///< Shown in the pictures; empty: one with a recording and a model is made for them.
  const Progress* progress = nullptr;
};

struct ManualReport {
  int commands = 0;
  int panels = 0;
  int pages = 0;
  int pictures = 0;
};

/// Markdown. Every command by menu: title, help, keys, id, and what the command line calls it.
std::string commands_page();
/// Every chord of every preset, and what the mouse does.
std::string keys_page();
/// Every panel with its picture, which is looked for at "panels/NAME.png", and its commands.
std::string panels_page();

/// Writes index.md, commands.md, keys.md, panels.md and a picture of each panel. Errors: kIo for the folder; those of
/// `run_headless`. Threads: call it in the main thread, where no GL context is current.
Result<ManualReport> write_manual(const ManualOptions& options);

}  // namespace trocar::ui
