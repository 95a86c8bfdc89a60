/// What each panel is for, in words: the pages of Help and of the manual.
#pragma once

#include <array>
#include <span>
#include <string_view>
#include <vector>

#include "ui/command_table.h"
#include "ui/tile_tree.h"

namespace trocar::ui {

struct MouseHelp {
  std::string_view act;  ///< "Trim"
  std::string_view how;  ///< "Drag a gate; Esc cancels"
};

struct PanelPage {
  std::string_view summary;  ///< One sentence.
  std::string_view more;     ///< How it is used, some sentences.
  /// Of its commands; one that ends in a dot stands for all that begin so.
  std::array<std::string_view, 6> commands;
  std::array<MouseHelp, 7> mouse;
};

const PanelPage& page_of(PanelId panel);
/// The rows of the command table that a page names, in the order of the table.
std::vector<const CommandRow*> commands_of(const PanelPage& page);
/// All that the mouse does, of all panels and of the window.
std::vector<MouseHelp> all_mouse_help();

}  // namespace trocar::ui
