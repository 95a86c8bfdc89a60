/// A line through many points that keeps its width wherever it turns.
#pragma once

#include <imgui.h>

#include <span>

namespace trocar::ui {

/// Pixels of the screen, all of them. Points that cannot be told apart are drawn as one, and the line begins anew where
/// it turns back sharply: ImGui's own lines grow spikes there, or vanish.
void stroke(ImDrawList& list, std::span<const ImVec2> points, ImU32 colour, float width);

}  // namespace trocar::ui
