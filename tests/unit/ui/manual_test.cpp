// The manual and the equivalents on the command line: of every command, from the one table.
#include "ui/manual.h"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <string>

#include "tests/support/ui_state.h"
#include "ui/command_cli.h"
#include "ui/command_table.h"
#include "ui/command_text.h"
#include "ui/panel_pages.h"

namespace trocar::ui {

TEST_CASE("the manual has every command with its id, title and help, once in its menu") {
  const std::string page = commands_page();
  for (const CommandRow& row : command_table()) {
    CAPTURE(row.id);
    const std::string id = fmt::format("`{}` |", row.id);
    const std::size_t at = page.find(id);
    REQUIRE(at != std::string::npos);
    CHECK(page.find(id, at + 1) == std::string::npos);
    const std::size_t line = page.rfind('\n', at) + 1;
    const std::string words = page.substr(line, at - line);
    CHECK(words.find(row.title) != std::string::npos);
    CHECK(words.find(row.help) != std::string::npos);
    if (!row.keys.empty()) CHECK(words.find(std::string(row.keys.front())) != std::string::npos);
  }
}

TEST_CASE("the manual's keys name every preset, and its panels every panel with a picture and a command that exists") {
  const std::string keys = keys_page();
  for (const KeyPreset preset : kKeyPresets) CHECK(keys.find(title_of(preset)) != std::string::npos);
  CHECK(keys.find("`Keypad7`") != std::string::npos);
  const std::string panels = panels_page();
  for (std::size_t i = 0; i < kPanelCount; ++i) {
    const auto panel = static_cast<PanelId>(i);
    CAPTURE(title(panel));
    CHECK(panels.find(fmt::format("## {}\n", title(panel))) != std::string::npos);
    CHECK(page_of(panel).summary.size() > 10);
    for (const std::string_view name : page_of(panel).commands) {
      if (name.empty() || name.ends_with('.') || name.ends_with('_')) continue;
      CHECK(command(name).id == name);
    }
  }
}

TEST_CASE("what a command does to the document is said by the command line as the table says") {
  const workbench::WorkbenchState state = testing::made_state_with_model();
  for (const CommandRow& row : command_table()) {
    if (!row.reason_now(state).empty()) continue;
    CAPTURE(row.id);
    for (const Request& request : row.run(state)) {
      const auto* asked = std::get_if<workbench::Command>(&request);
      if (asked == nullptr) continue;
      const std::string words = command_text(*asked, state);
      if (words.empty()) continue;
      const std::string_view cli = cli_of(row.id);
      // "trocar demo edit": up to the project.
      const std::string_view head = cli.substr(0, cli.find(" P"));
      CHECK(!head.empty());
      CHECK(words.starts_with(head));
    }
  }
}

}  // namespace trocar::ui
