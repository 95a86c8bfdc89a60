/// What ImGui made, cut into runs that need no texture or no mixing: in software a plain opaque pixel costs a fraction
/// of a textured, mixed one, and most of a window is plain and opaque.
#pragma once

#include <imgui.h>

#include <vector>

namespace trocar::ui {

enum class GuiLook {
  kTextured,
  kPlain,    ///< Needs no texture.
  kOpaque,   ///< Of one colour, hides all below.
  kPicture,  ///< A texture as it is; hides all below.
};

/// `count` indices from `first` on, in the list's index buffer.
struct GuiRun {
  GuiLook look = GuiLook::kTextured;
  unsigned first = 0;
  unsigned count = 0;
};

/// The command's triangles in their order. `white` is where its texture is white. Small things stay textured and mixed,
/// which is right for all: a change of state costs more than they do.
std::vector<GuiRun> gui_runs(const ImDrawList& list, const ImDrawCmd& command, ImVec2 white);

/// The command's pictures are shown as they are: all of its corners are opaque white.
bool gui_untinted(const ImDrawList& list, const ImDrawCmd& command);

}  // namespace trocar::ui
