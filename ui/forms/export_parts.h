/// What the forms that write a file have in common: its kind, its paper, its name and the button.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "ui/forms/form.h"

namespace trocar::ui {

/// Beside the project: "/data/pegs" + `ending`.
std::string beside_project(const WorkbenchState& state, std::string_view ending);
/// The place of the path's ending among them, in letters of either size; −1: none of them.
int place_of_ending(const std::string& path, std::span<const std::string_view> endings);

/// Width and resolution of a figure.
struct PaperChoice {
  int paper = 0;  ///< 0: for a screen; else a preset.
  std::int64_t dpi = 300;
  bool transparent = false;

  /// "", "column" or "page".
  std::string preset() const;
};
/// `drawn`: not a file of numbers; `picture`: one of pixels.
void draw_paper(Ui& ui, PaperChoice& choice, bool drawn, bool picture);

/// Why nothing can be written there; "" if it can, as far as can be seen: the project itself, a folder, no folder.
std::string reason_against_path(const std::string& path, const WorkbenchState& state);
/// Says so before a file is replaced.
bool export_button(Ui& ui, const char* sign, const std::string& path, const std::string& reason);

}  // namespace trocar::ui
