#include "ui/gui_runs.h"

#include <doctest/doctest.h>

#include <vector>

using namespace trocar;
using ui::GuiLook;

namespace {

const ImVec2 kWhite{0.25F, 0.75F};

struct Drawing {
  ImDrawList list{nullptr};
  ImDrawCmd command;

  void rectangle(float side, ImU32 colour, ImVec2 uv = kWhite) {
    const auto base = static_cast<ImDrawIdx>(list.VtxBuffer.Size);
    for (const auto& [x, y] : {ImVec2(0, 0), ImVec2(side, 0), ImVec2(side, side), ImVec2(0, side)}) {
      list.VtxBuffer.push_back({{x, y}, uv, colour});
    }
    for (const int corner : {0, 1, 2, 0, 2, 3}) list.IdxBuffer.push_back(static_cast<ImDrawIdx>(base + corner));
    command.ElemCount += 6;
  }
  std::vector<GuiLook> looks() const {
    std::vector<GuiLook> found;
    unsigned next = 0;
    for (const ui::GuiRun& run : ui::gui_runs(list, command, kWhite)) {
      CHECK(run.first == next);
      next += run.count;
      found.push_back(run.look);
    }
    CHECK(next == command.ElemCount);
    return found;
  }
};

constexpr ImU32 kSolid = IM_COL32(40, 50, 60, 255);
constexpr ImU32 kGlass = IM_COL32(40, 50, 60, 254);

}  // namespace

TEST_CASE("a large solid rectangle is drawn plain and unmixed, a see-through or textured one is not") {
  Drawing drawing;
  drawing.rectangle(200.0F, kSolid);
  drawing.rectangle(200.0F, kGlass);
  drawing.rectangle(200.0F, kSolid, {0.5F, 0.5F});
  CHECK(drawing.looks() == std::vector{GuiLook::kOpaque, GuiLook::kTextured});
}

TEST_CASE("runs keep the order in which things cover each other, and small things do not cut them") {
  Drawing drawing;
  drawing.rectangle(10.0F, kSolid);
  drawing.rectangle(10.0F, kSolid, {0.5F, 0.5F});
  drawing.rectangle(200.0F, kSolid);
  for (int i = 0; i < 20; ++i) drawing.rectangle(5.0F, kGlass);
  drawing.rectangle(10.0F, kSolid, {0.5F, 0.5F});
  CHECK(drawing.looks() == std::vector{GuiLook::kTextured, GuiLook::kOpaque, GuiLook::kPlain, GuiLook::kTextured});
}

TEST_CASE("a picture is shown as it is only if no corner tints it or lets something through") {
  for (const ImU32 other : {kSolid, IM_COL32(255, 255, 255, 254)}) {
    Drawing drawing;
    drawing.rectangle(100.0F, IM_COL32_WHITE);
    CHECK(ui::gui_untinted(drawing.list, drawing.command));
    drawing.rectangle(100.0F, other);
    CHECK_FALSE(ui::gui_untinted(drawing.list, drawing.command));
  }
}

TEST_CASE("a large rectangle that changes colour across is not taken for one of one colour") {
  Drawing drawing;
  drawing.rectangle(200.0F, kSolid);
  drawing.list.VtxBuffer[2].col = IM_COL32(200, 50, 60, 255);
  for (const GuiLook look : drawing.looks()) CHECK_FALSE(look == GuiLook::kOpaque);
}
