/// The real window, through GLFW. Only `trocar-workbench` links this.
#pragma once

#include <memory>
#include <string>

#include "ui/window/window.h"

namespace trocar::ui {

/// Errors: kUnsupported, in one sentence, where there is no display or no OpenGL 3.3.
/// Threads: the main thread.
Result<std::unique_ptr<Window>> open_glfw_window(WindowSize size, const std::string& title);

}  // namespace trocar::ui
