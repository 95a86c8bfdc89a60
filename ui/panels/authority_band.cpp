#include "ui/panels/authority_band.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "ui/format.h"
#include "ui/icons.h"
#include "ui/theme.h"

namespace trocar::ui {
namespace {

using control::ControlState;
using demonstration::Authority;
using demonstration::Segment;

constexpr Rgba kStopped{214, 72, 72, 255};

/// A shape of its own for each owner, so that colour is not needed: a triangle is the agent, a circle the operator, a
/// square the assistant, two bars hold, an octagon stop.
void draw_shape(ImDrawList& list, ControlState state, Segment segment, ImVec2 centre, float radius, ImU32 colour) {
  switch (state) {
    case ControlState::kAgent:
      list.AddTriangleFilled({centre.x - radius * 0.7F, centre.y - radius},
                             {centre.x - radius * 0.7F, centre.y + radius}, {centre.x + radius, centre.y}, colour);
      return;
    case ControlState::kClutch:
    case ControlState::kHold:
      for (const float side : {-1.0F, 1.0F}) {
        const float x = centre.x + side * radius * 0.45F;
        list.AddRectFilled({x - radius * 0.28F, centre.y - radius}, {x + radius * 0.28F, centre.y + radius}, colour);
      }
      return;
    case ControlState::kStopped:
      list.AddNgonFilled(centre, radius * 1.1F, colour, 8);
      return;
    default:
      if (segment == Segment::kE) {
        list.AddRectFilled({centre.x - radius, centre.y - radius}, {centre.x + radius, centre.y + radius}, colour);
      } else {
        list.AddCircleFilled(centre, radius, colour);
      }
  }
}

/// Who has the arm in the segment after this one.
std::string next_words(Segment segment, trial::Mode mode) {
  const bool shared = mode == trial::Mode::kShared;
  switch (segment) {
    case Segment::kA:
      return "next: OPERATOR in B";
    case Segment::kB:
      return shared ? "next: AGENT in C" : "next: OPERATOR in C";
    case Segment::kC:
      return "next: OPERATOR in D";
    case Segment::kD:
      return "next: ASSISTANT in E";
    case Segment::kE:
      return "next: the outcome";
  }
  return "";
}

std::string presses_words(int presses) {
  return presses == 1 ? "1 press" : fmt::format("{} presses", presses);
}

void draw_lamp(Ui& ui, const char* name, const char* meaning, bool down, const std::string& more, Rgba colour,
               float width) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float height = ui.px(40);
  ImGui::InvisibleButton(name, {width, height});
  note_item(ui, "lamp", name, down ? "down" : "up", {.help = meaning});
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Theme& theme = ui.theme();
  list.AddRectFilled(at, {at.x + width, at.y + height}, to_u32(down ? mix(theme.raised, colour, 0.35F) : theme.raised),
                     ui.px(6));
  const ImVec2 centre{at.x + ui.px(22), at.y + 0.5F * height};
  const float radius = ui.px(11);
  if (down) {
    list.AddCircleFilled(centre, radius, to_u32(colour));
  } else {
    list.AddCircle(centre, radius, to_u32(theme.text_dim), 0, ui.px(2));
  }
  const float left = at.x + ui.px(42);
  const float line = ImGui::GetFontSize();
  list.AddText({left, at.y + 0.5F * height - line}, to_u32(theme.text), fitted(name, width - ui.px(48)).c_str());
  const FontScope small(ui.fonts().small);
  list.AddText({left, at.y + 0.5F * height + ui.px(1)}, to_u32(theme.text_dim),
               fitted(more, width - ui.px(48)).c_str());
}

}  // namespace

std::string_view band_word(ControlState state, Segment segment) {
  switch (state) {
    case ControlState::kAgent:
      return "AGENT";
    case ControlState::kClutch:
      return "CLUTCH";
    case ControlState::kHold:
      return "HOLD";
    case ControlState::kStopped:
      return "STOPPED";
    case ControlState::kOutcome:
      return "OUTCOME";
    case ControlState::kReady:
      return "READY";
    case ControlState::kReset:
      return "RESET";
    case ControlState::kOperator:
      return segment == Segment::kE ? "ASSISTANT" : "OPERATOR";
    default:
      return "NOT READY";
  }
}

Rgba band_colour(ControlState state, Segment segment) {
  switch (state) {
    case ControlState::kAgent:
      return authority_colour(Authority::kAgent);
    case ControlState::kOperator:
      return authority_colour(segment == Segment::kE ? Authority::kAssistant : Authority::kOperator);
    case ControlState::kStopped:
      return kStopped;
    default:
      return authority_colour(Authority::kHold);
  }
}

void authority_band(Ui& ui, const trial::TrialStatus& status, Segment segment, trial::Mode mode) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  const float height = ui.px(72);
  const std::string word(band_word(status.state, segment));
  const std::string value =
      fmt::format("{} in {}, {}", word, demonstration::letter(segment), next_words(segment, mode));
  ImGui::InvisibleButton("Authority", {std::max(width, 1.0F), height});
  note_item(ui, "text", "Authority", value, {.help = "Who has the left arm now"});
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Rgba colour = band_colour(status.state, segment);
  const Rgba ink{18, 20, 24, 255};
  list.AddRectFilled(at, {at.x + width, at.y + height}, to_u32(colour), ui.px(6));
  draw_shape(list, status.state, segment, {at.x + ui.px(36), at.y + 0.5F * height}, ui.px(17), to_u32(ink));
  ImFont* font = ui.fonts().large;
  const float size = std::min(ui.px(34), 0.11F * width);
  list.AddText(font, size, {at.x + ui.px(68), at.y + 0.5F * (height - size) - ui.px(8)}, to_u32(ink), word.c_str());
  const FontScope small(ui.fonts().small);
  list.AddText({at.x + ui.px(69), at.y + 0.5F * (height + size) - ui.px(8)}, to_u32(ink),
               fitted(next_words(segment, mode), width - ui.px(140)).c_str());
  // The segment as on every chip.
  const float side = ui.px(44);
  const ImVec2 chip{at.x + width - side - ui.px(14), at.y + 0.5F * (height - side)};
  list.AddRectFilled(chip, {chip.x + side, chip.y + side}, to_u32(segment_colour(segment)), ui.px(5));
  list.AddRect(chip, {chip.x + side, chip.y + side}, to_u32(ink), ui.px(5), 0, ui.px(2));
  const char letter[2] = {demonstration::letter(segment), 0};
  const ImVec2 extent = font->CalcTextSizeA(ui.px(30), 1e6F, 0.0F, letter);
  list.AddText(font, ui.px(30), {chip.x + 0.5F * (side - extent.x), chip.y + 0.5F * (side - extent.y)}, to_u32(ink),
               letter);
}

void pedal_lamps(Ui& ui, const trial::TrialStatus& status) {
  const float room = ImGui::GetContentRegionAvail().x;
  const float gap = ui.px(8);
  const bool beside = room >= ui.px(360);
  const float width = beside ? 0.5F * (room - gap) : room;
  std::string presses = presses_words(status.agent_presses);
  if (status.pedal_stuck) presses = "down since the beginning: stuck?";
  draw_lamp(ui, "AGENT: hold to run", "Left pedal: the agent moves the tool in A and C while it is held",
            status.agent_pedal, presses, authority_colour(Authority::kAgent), width);
  if (beside) ImGui::SameLine(0.0F, gap);
  draw_lamp(ui, "CLUTCH", "Right pedal: the hand moves, the tool holds", status.clutch_pedal,
            presses_words(status.counts.clutches), ui.theme().warning, width);
}

void control_states(Ui& ui, ControlState now) {
  const Scope scope(ui, "States");
  const FontScope small(ui.fonts().small);
  for (int i = 0; i < control::kControlStates; ++i) {
    const auto state = static_cast<ControlState>(i);
    const std::string word(to_string(state));
    const float width = ImGui::CalcTextSize(word.c_str()).x + ui.px(12);
    if (i > 0) flow(width, ui.px(4));
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float height = ImGui::GetFontSize() + ui.px(6);
    ImGui::InvisibleButton(word.c_str(), {width, height});
    note_item(ui, "state", word, state == now ? "lit" : "", {});
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const Theme& theme = ui.theme();
    const Rgba lit = theme.accent_fill;
    if (state == now) list.AddRectFilled(at, {at.x + width, at.y + height}, to_u32(lit), ui.px(4));
    list.AddRect(at, {at.x + width, at.y + height}, to_u32(state == now ? lit : theme.line), ui.px(4));
    list.AddText({at.x + ui.px(6), at.y + ui.px(3)}, to_u32(state == now ? theme.on_accent : theme.text_dim),
                 word.c_str());
  }
}

}  // namespace trocar::ui
