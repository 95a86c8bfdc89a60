/// A window without a screen on a hand-filled state, for tests of what is on it.
#pragma once

#include <doctest/doctest.h>

#include <memory>
#include <string>
#include <vector>

#include "tests/support/ui_state.h"
#include "ui/driver/driver.h"
#include "ui/window/null_window.h"

namespace trocar::ui {

/// The window on a state that commands do not change, unless a test does.
struct Desk {
  explicit Desk(workbench::WorkbenchState shown, float scale = 1.0F, ThemeKind theme = ThemeKind::kDark)
      : state(std::move(shown)) {
    Settings settings;
    settings.scale = scale;
    settings.theme = theme;
    session = std::move(Session::create(window, settings).value());
    CHECK(driver().frames(4));
  }
  Driver driver() {
    return Driver(*session, [this]() -> Status {
      window.poll(0.0);
      TROCAR_ASSIGN_OR_RETURN(const ShellResult result, session->frame(state));
      commands.insert(commands.end(), result.commands.begin(), result.commands.end());
      quit = quit || result.quit;
      return {};
    });
  }
  template <typename Command>
  const Command* last() const {
    const Command* found = nullptr;
    for (const auto& command : commands) {
      if (const auto* match = std::get_if<Command>(&command)) found = match;
    }
    return found;
  }

  workbench::WorkbenchState state;
  NullWindow window{{1600, 900}};
  std::unique_ptr<Session> session;
  std::vector<workbench::Command> commands;
  bool quit = false;
};

inline std::string text_of(const Status& status) {
  return status ? "" : status.error().text();
}

}  // namespace trocar::ui
