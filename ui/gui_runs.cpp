#include "ui/gui_runs.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace trocar::ui {
namespace {

/// Half a rectangle of 60 × 60.
constexpr float kLargeArea_px = 1800.0F;
/// Fewer plain triangles in a row than this are not worth a change of program.
constexpr unsigned kLeastPlain = 16 * 3;

std::array<const ImDrawVert*, 3> corners(const ImDrawList& list, const ImDrawCmd& command, unsigned index) {
  const ImDrawVert* vertices = list.VtxBuffer.Data + command.VtxOffset;
  const ImDrawIdx* indices = list.IdxBuffer.Data + index;
  return {vertices + indices[0], vertices + indices[1], vertices + indices[2]};
}

bool opaque(const ImDrawVert& vertex) {
  return (vertex.col & IM_COL32_A_MASK) == IM_COL32_A_MASK;
}

GuiLook look_of(const std::array<const ImDrawVert*, 3>& at, ImVec2 white) {
  const auto& [a, b, c] = at;
  for (const ImDrawVert* vertex : at) {
    if (vertex->uv.x != white.x || vertex->uv.y != white.y) return GuiLook::kTextured;
  }
  const float area =
      0.5F * std::abs((b->pos.x - a->pos.x) * (c->pos.y - a->pos.y) - (c->pos.x - a->pos.x) * (b->pos.y - a->pos.y));
  const bool solid = opaque(*a) && a->col == b->col && b->col == c->col;
  return solid && area >= kLargeArea_px ? GuiLook::kOpaque : GuiLook::kPlain;
}

void add(std::vector<GuiRun>& runs, const GuiRun& run) {
  if (!runs.empty() && runs.back().look == run.look) {
    runs.back().count += run.count;
  } else {
    runs.push_back(run);
  }
}

}  // namespace

std::vector<GuiRun> gui_runs(const ImDrawList& list, const ImDrawCmd& command, ImVec2 white) {
  std::vector<GuiRun> fine;
  for (unsigned i = command.IdxOffset; i + 2 < command.IdxOffset + command.ElemCount; i += 3) {
    add(fine, {look_of(corners(list, command, i), white), i, 3});
  }
  std::vector<GuiRun> runs;
  for (GuiRun run : fine) {
    if (run.look == GuiLook::kPlain && run.count < kLeastPlain) run.look = GuiLook::kTextured;
    add(runs, run);
  }
  return runs;
}

bool gui_untinted(const ImDrawList& list, const ImDrawCmd& command) {
  for (unsigned i = command.IdxOffset; i + 2 < command.IdxOffset + command.ElemCount; i += 3) {
    const auto at = corners(list, command, i);
    if (!std::all_of(at.begin(), at.end(), [](const ImDrawVert* vertex) { return vertex->col == IM_COL32_WHITE; }))
      return false;
  }
  return true;
}

}  // namespace trocar::ui
