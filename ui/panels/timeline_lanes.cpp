#include "ui/panels/timeline_lanes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "engine/demonstration/edit_words.h"
#include "ui/format.h"
#include "ui/icons.h"

namespace trocar::ui {
namespace {

constexpr float kRulerHeight = 24.0F;  // All at 100 %.
constexpr float kGatesHeight = 16.0F;

struct LaneRow {
  std::string_view name;
  std::string_view help;
  float height;
};
// By `Lane`.
constexpr std::array<LaneRow, kLaneCount> kLanes{{
    {"Segments", "The five segments of a transfer, A to E", 24.0F},
    {"Authority", "Who moved the left arm", 21.0F},
    {"Jaw L", "The left gripper's angle; marks where it opens and closes", 27.0F},
    {"Jaw R", "The right gripper's angle; marks where it opens and closes", 27.0F},
    {"Holds L, R", "Which arm holds the block: left above, right below", 17.0F},
    {"Pedals", "The pedals: agent above, clutch below", 17.0F},
    {"Notes", "Markers and notes", 18.0F},
    {"Problems", "Errors above, warnings below; the panel of that name tells more", 17.0F},
    {"Edits", "Where each edit of the stack has worked", 20.0F},
    {"Original", "The segments as they were recorded, at their times then", 20.0F},
}};

const LaneRow& row_of(Lane lane) {
  return kLanes[static_cast<std::size_t>(lane)];
}

constexpr Rgba kInk{16, 18, 21, 255};  // On the light colours of segments and authorities.

/// Light on a dark lane, dark on a light one: each has a contrast of 3:1 and more, and its glyph besides.
Rgba note_colour(const Theme& theme, demonstration::NoteColour colour) {
  using demonstration::NoteColour;
  constexpr std::array<std::pair<Rgba, Rgba>, 6> kDarkAndLight{{{{240, 128, 120, 255}, {178, 36, 30, 255}},
                                                                {{240, 160, 80, 255}, {166, 84, 0, 255}},
                                                                {{232, 208, 92, 255}, {128, 104, 0, 255}},
                                                                {{124, 204, 128, 255}, {28, 118, 48, 255}},
                                                                {{118, 178, 246, 255}, {24, 92, 186, 255}},
                                                                {{198, 152, 240, 255}, {118, 58, 176, 255}}}};
  if (colour == NoteColour::kPlain) return theme.warning;
  const auto& [dark, light] = kDarkAndLight[static_cast<std::size_t>(colour) - 1];
  return theme.dark ? dark : light;
}

const char* note_sign(demonstration::NoteGlyph glyph) {
  constexpr std::array<const char*, 6> kSigns{"",           icon::kStar, icon::kVerify,
                                              icon::kCross, icon::kHelp, icon::kWarning};
  return kSigns[static_cast<std::size_t>(glyph)];
}

class Lanes {
 public:
  Lanes(Ui& ui, const LaneLayout& layout) : ui_(ui), layout_(layout), y_(layout.lanes.y0) {}

  void begin(Lane lane);
  void block(double begin_s, double end_s, Rgba colour, std::string_view words, std::string_view short_words = {});
  void thin_row(const std::vector<Run>& runs, int row, int rows, Rgba colour) const;
  /// A triangle that points up where a gripper opens, down where it closes; each has a place of its own.
  void mark(double t_s, bool up, Rgba colour) const;
  void note(const demonstration::Note& note, std::string_view label);
  /// An error in the upper half, a warning in the lower.
  void problem(const review::Problem& problem);
  /// A frame around a span, and words in it as far as there is room.
  void outline(double begin_s, double end_s, std::string_view words) const;
  /// Where something was taken out: two triangles that meet.
  void seam(double t_s) const;
  Rect rect_of(double begin_s, double end_s) const;
  void curve(const std::vector<Extent>& extents, float low, float high, Rgba colour) const;
  void end();

 private:
  ImDrawList& list() const { return *ImGui::GetWindowDrawList(); }
  Ui& ui_;
  const LaneLayout& layout_;
  float y_;
  float height_ = 0.0F;
};

void Lanes::begin(Lane lane) {
  const std::string_view name = row_of(lane).name;
  height_ = ui_.px(row_of(lane).height);
  const FontScope font(ui_.fonts().small);
  const float text = ImGui::GetFontSize();
  list().AddText({layout_.names.x0, std::round(y_ + 0.5F * (height_ - text))}, to_u32(ui_.theme().text_dim),
                 name.data(), name.data() + name.size());
}

void Lanes::end() {
  y_ += height_;
  list().AddRectFilled({layout_.names.x0, y_}, {layout_.lanes.x1, y_ + 1.0F}, to_u32(ui_.theme().line, 0.7F));
  y_ += 1.0F;
}

void Lanes::block(double begin_s, double end_s, Rgba colour, std::string_view words, std::string_view short_words) {
  const float x0 = std::max(layout_.x_of(begin_s), layout_.lanes.x0);
  const float x1 = std::min(layout_.x_of(end_s), layout_.lanes.x1);
  if (x1 <= layout_.lanes.x0 || x0 >= layout_.lanes.x1) return;
  const float y0 = y_ + ui_.px(3);
  const float y1 = y_ + height_ - ui_.px(3);
  list().AddRectFilled({x0, y0}, {std::max(x1 - 1.0F, x0 + 1.0F), y1}, to_u32(colour), ui_.px(3));
  const FontScope font(ui_.fonts().small);
  const auto size_of = [](std::string_view text) {
    return ImGui::CalcTextSize(text.data(), text.data() + text.size());
  };
  const float w0 = std::max(x0, layout_.x_of(layout_.gate_in_s));
  const float w1 = std::min(x1, layout_.x_of(layout_.gate_out_s));
  if (size_of(words).x + ui_.px(8) > w1 - w0) words = short_words;
  const ImVec2 size = size_of(words);
  if (words.empty() || size.x + 2.0F > w1 - w0) return;
  const float x = w0 + ui_.px(6) + size.x > w1 - ui_.px(6) ? w0 + 0.5F * (w1 - w0 - size.x) : w0 + ui_.px(6);
  list().AddText({std::round(x), std::round(0.5F * (y0 + y1 - size.y))}, to_u32(kInk), words.data(),
                 words.data() + words.size());
}

void Lanes::thin_row(const std::vector<Run>& runs, int row, int rows, Rgba colour) const {
  const float each = (height_ - ui_.px(4)) / static_cast<float>(rows);
  const float y0 = y_ + ui_.px(2) + each * static_cast<float>(row);
  for (const Run& run : runs) {
    const float x0 = std::max(layout_.x_of(run.begin_s), layout_.lanes.x0);
    const float x1 = std::min(layout_.x_of(run.end_s), layout_.lanes.x1);
    if (x1 <= layout_.lanes.x0 || x0 >= layout_.lanes.x1) continue;
    list().AddRectFilled({x0, y0 + 1.0F}, {std::max(x1, x0 + 2.0F), y0 + each - 1.0F}, to_u32(colour), ui_.px(2));
  }
}

void Lanes::curve(const std::vector<Extent>& extents, float low, float high, Rgba colour) const {
  const float top = y_ + ui_.px(3);
  const float bottom = y_ + height_ - ui_.px(3);
  const auto y_of = [&](float value) { return bottom - (value - low) / (high - low) * (bottom - top); };
  const float step = layout_.lanes.width() / static_cast<float>(extents.size());
  float last = bottom;
  for (std::size_t i = 0; i < extents.size(); ++i) {
    const float x0 = std::round(layout_.lanes.x0 + step * static_cast<float>(i));
    const float x1 = std::round(layout_.lanes.x0 + step * static_cast<float>(i + 1));
    if (extents[i].low > extents[i].high) continue;
    const float y0 = std::round(y_of(extents[i].high));
    const float y1 = std::max(std::round(y_of(extents[i].low)), y0 + ui_.px(2));
    list().AddRectFilled({x0, y0}, {x1, bottom}, to_u32(colour, 0.22F));
    // The line bridges the step from the last column, so that it is whole where the jaw moves fast.
    list().AddRectFilled({x0, std::min(y0, last)}, {x1, std::max(y1, std::min(last, y1))}, to_u32(colour));
    last = y0;
  }
}

void Lanes::mark(double t_s, bool up, Rgba colour) const {
  const float x = std::round(layout_.x_of(t_s));
  if (x < layout_.lanes.x0 || x > layout_.lanes.x1) return;
  const float half = ui_.px(4);
  const float tall = ui_.px(6);
  list().AddRectFilled({x, y_ + 1.0F}, {x + 1.0F, y_ + height_}, to_u32(colour, 0.8F));
  if (up) {
    list().AddTriangleFilled({x - half, y_ + tall + 1.0F}, {x + half, y_ + tall + 1.0F}, {x, y_ + 1.0F},
                             to_u32(colour));
  } else {
    const float low = y_ + height_;
    list().AddTriangleFilled({x - half, low - tall}, {x + half, low - tall}, {x, low}, to_u32(colour));
  }
}

// A diamond at its begin, so that an instant can be seen; a bar over its span; words as far as there is room.
void Lanes::note(const demonstration::Note& note, std::string_view label) {
  const float x0 = layout_.x_of(note.begin_s);
  const float x1 = layout_.x_of(note.end_s);
  if (x1 < layout_.lanes.x0 || x0 > layout_.lanes.x1) return;
  const Rgba colour = note_colour(ui_.theme(), note.colour);
  const float y = std::round(y_ + 0.5F * height_);
  const float half = ui_.px(note.glyph == demonstration::NoteGlyph::kFlag ? 5 : 7);
  if (x1 > x0) {
    list().AddRectFilled({std::max(x0, layout_.lanes.x0), y - ui_.px(2)},
                         {std::min(x1, layout_.lanes.x1), y + ui_.px(2)}, to_u32(colour, 0.5F));
  }
  if (note.glyph == demonstration::NoteGlyph::kFlag) {
    list().AddQuadFilled({x0 - half, y}, {x0, y - half}, {x0 + half, y}, {x0, y + half}, to_u32(colour));
  } else {
    const char* sign = note_sign(note.glyph);
    const ImVec2 size = ImGui::CalcTextSize(sign);
    list().AddText({std::round(x0 - 0.5F * size.x), std::round(y - 0.5F * size.y)}, to_u32(colour), sign);
  }
  const Rect rect{x0 - half, y_ + 1.0F, std::max(x1, x0 + half), y_ + height_};
  note_rect(ui_, "mark", label, note.text, rect);
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  if (rect.contains(mouse.x, mouse.y)) ui_.set_hint(fmt::format("Note at {:.2f} s: {}", note.begin_s, note.text));
}

void Lanes::problem(const review::Problem& problem) {
  const bool error = problem.severity == demonstration::Severity::kError;
  const float x0 = layout_.x_of(problem.begin_s);
  const float x1 = std::max(layout_.x_of(problem.end_s), x0 + ui_.px(4));
  if (x1 < layout_.lanes.x0 || x0 > layout_.lanes.x1) return;
  const float middle = std::round(y_ + 0.5F * height_);
  const float low = error ? middle - 1.0F : y_ + height_ - ui_.px(2);
  const Rect rect{std::max(x0, layout_.lanes.x0), error ? y_ + ui_.px(2) : middle + 1.0F,
                  std::min(x1, layout_.lanes.x1), low};
  list().AddRectFilled({rect.x0, rect.y0}, {rect.x1, rect.y1}, to_u32(error ? ui_.theme().danger : ui_.theme().warning),
                       error ? 0.0F : ui_.px(2));
  note_rect(ui_, "mark", problem.id, problem.message, rect);
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  if (!rect.contains(mouse.x, mouse.y)) return;
  ui_.set_hint(fmt::format("{} at {:.2f} s: {}", error ? "Error" : "Warning", problem.begin_s, problem.message));
}

Rect Lanes::rect_of(double begin_s, double end_s) const {
  const float x0 = std::clamp(layout_.x_of(begin_s), layout_.lanes.x0, layout_.lanes.x1);
  const float x1 = std::clamp(layout_.x_of(end_s), layout_.lanes.x0, layout_.lanes.x1);
  return {x0, y_ + ui_.px(2), std::max(x1, x0 + ui_.px(3)), y_ + height_ - ui_.px(2)};
}

void Lanes::outline(double begin_s, double end_s, std::string_view words) const {
  const Rect rect = rect_of(begin_s, end_s);
  if (layout_.x_of(end_s) <= layout_.lanes.x0 || rect.x0 >= layout_.lanes.x1) return;
  const Theme& theme = ui_.theme();
  list().AddRectFilled({rect.x0, rect.y0}, {rect.x1 - 1.0F, rect.y1}, to_u32(theme.raised, 0.8F), ui_.px(3));
  list().AddRect({rect.x0, rect.y0}, {rect.x1 - 1.0F, rect.y1}, to_u32(theme.text_dim, 0.7F), ui_.px(3));
  const FontScope font(ui_.fonts().small);
  const std::string shown = fitted(words, rect.width() - ui_.px(10));
  if (rect.width() < ui_.px(18) || shown.size() < std::min<std::size_t>(words.size(), 4)) return;
  list().AddText({std::round(rect.x0 + ui_.px(5)), std::round(rect.centre_y() - 0.5F * ImGui::GetFontSize())},
                 to_u32(theme.text), shown.c_str());
}

void Lanes::seam(double t_s) const {
  const float x = std::round(layout_.x_of(t_s));
  if (x < layout_.lanes.x0 || x > layout_.lanes.x1) return;
  const float half = ui_.px(5);
  const float y0 = y_ + ui_.px(3);
  const float y1 = y_ + height_ - ui_.px(3);
  const ImU32 colour = to_u32(ui_.theme().text_dim);
  list().AddTriangleFilled({x - half, y0}, {x - half, y1}, {x, 0.5F * (y0 + y1)}, colour);
  list().AddTriangleFilled({x + half, y0}, {x, 0.5F * (y0 + y1)}, {x + half, y1}, colour);
}

void draw_segments(Lanes& lanes, Ui& ui, const LaneLayout& layout, const demonstration::Demonstration& shown) {
  UniqueNames unique;
  lanes.begin(Lane::kSegments);
  for (const demonstration::SegmentSpan& span : shown.segments) {
    const std::string letter(1, demonstration::letter(span.label));
    const double begin_s = std::max(span.begin_s, layout.gate_in_s);
    const double end_s = std::min(span.end_s, layout.gate_out_s);
    const std::string length = seconds(std::max(end_s - begin_s, 0.0));
    lanes.block(span.begin_s, span.end_s, segment_colour(span.label), fmt::format("{}  {}", letter, length), letter);
    if (end_s <= begin_s) continue;
    const float x0 = std::clamp(layout.x_of(begin_s), layout.lanes.x0, layout.lanes.x1);
    const float x1 = std::clamp(layout.x_of(end_s), layout.lanes.x0, layout.lanes.x1);
    const Rect rect{x0, layout.lanes.y0, x1, layout.lanes.y0 + ui.px(row_of(Lane::kSegments).height)};
    note_rect(ui, "text", unique("Segment " + letter), length, rect);
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    if (!rect.contains(mouse.x, mouse.y)) continue;
    // The segment may be too narrow for its letter.
    ui.set_hint(fmt::format("Segment {}: {:.2f}–{:.2f} s, {} long", letter, begin_s, end_s, length));
  }
  lanes.end();
}

void draw_authority(Lanes& lanes, const LaneData& data) {
  lanes.begin(Lane::kAuthority);
  for (const Run& run : data.authority()) {
    const auto authority = static_cast<demonstration::Authority>(run.state - 1);
    lanes.block(run.begin_s, run.end_s, authority_colour(authority), demonstration::to_string(authority));
  }
  lanes.end();
}

void draw_jaw(Lanes& lanes, const Ui& ui, const LaneData& data, int arm, Rgba colour) {
  using demonstration::EventKind;
  lanes.begin(arm == 0 ? Lane::kJawLeft : Lane::kJawRight);
  lanes.curve(data.jaw(arm), data.jaw_low(), data.jaw_high(), colour);
  for (const demonstration::Event& event : data.events()) {
    const bool opens = event.kind == EventKind::kJawOpens;
    if (event.arm == arm && (opens || event.kind == EventKind::kJawCloses))
      lanes.mark(event.t_s, opens, ui.theme().text);
  }
  lanes.end();
}

void draw_flags(Lanes& lanes, const LaneData& data, Lane lane, std::array<demonstration::SampleFlag, 2> flags,
                std::array<Rgba, 2> colours) {
  lanes.begin(lane);
  for (int row = 0; row < 2; ++row) {
    const auto index = static_cast<std::size_t>(row);
    lanes.thin_row(data.flag(flags[index]), row, 2, colours[index]);
  }
  lanes.end();
}

void draw_notes(Lanes& lanes, const demonstration::Demonstration& shown) {
  UniqueNames unique;
  lanes.begin(Lane::kNotes);
  for (const demonstration::Note& note : shown.notes) lanes.note(note, unique("Note"));
  lanes.end();
}

void draw_problems(Lanes& lanes, std::span<const review::Problem> problems) {
  lanes.begin(Lane::kProblems);
  for (const review::Problem& problem : problems) {
    if (problem.severity != demonstration::Severity::kInfo) lanes.problem(problem);
  }
  lanes.end();
}

std::string words_of(const demonstration::Demonstration& shown, std::int64_t entry) {
  for (const demonstration::StackEntry& each : *shown.stack) {
    if (each.id != entry) continue;
    return each.name.empty() ? demonstration::title_of(demonstration::name_of(*each.edit)) : each.name;
  }
  return {};
}

void draw_edits(Lanes& lanes, Ui& ui, const demonstration::Demonstration& shown, const LaneData& data) {
  UniqueNames unique;
  lanes.begin(Lane::kEdits);
  for (const demonstration::EditSpan& span : data.edits()) {
    const std::string words = words_of(shown, span.entry);
    if (span.end_s > span.begin_s) {
      lanes.outline(span.begin_s, span.end_s, words);
    } else {
      lanes.seam(span.begin_s);
    }
    const Rect rect = lanes.rect_of(span.begin_s, span.end_s);
    note_rect(ui, "mark", unique("Edit " + words), fmt::format("{:.3f}–{:.3f} s", span.begin_s, span.end_s), rect);
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    if (rect.contains(mouse.x, mouse.y)) {
      ui.set_hint(fmt::format("{}: {:.2f}–{:.2f} s", words, span.begin_s, span.end_s));
    }
  }
  lanes.end();
}

void draw_original(Lanes& lanes, const LaneData& data) {
  lanes.begin(Lane::kOriginal);
  for (const demonstration::SegmentSpan& span : data.original()) {
    lanes.outline(span.begin_s, span.end_s, std::string(1, demonstration::letter(span.label)));
  }
  lanes.end();
}

}  // namespace

std::string_view name_of(Lane lane) {
  return row_of(lane).name;
}

std::string_view help_of(Lane lane) {
  return row_of(lane).help;
}

float lanes_height(const Ui& ui, const LaneSet& shown) {
  float height = ui.px(kRulerHeight) + ui.px(kGatesHeight);
  for (std::size_t i = 0; i < kLaneCount; ++i) {
    if (shown[i]) height += ui.px(kLanes[i].height) + 1.0F;
  }
  return height;
}

LaneLayout lay_out(const Ui& ui, const Rect& area, const TimeRange& range) {
  const float x0 = area.x0 + ui.px(78);
  const float x1 = area.x1 - ui.px(10);
  const float gates = area.y0 + ui.px(kRulerHeight);
  const float lanes = gates + ui.px(kGatesHeight);
  LaneLayout layout;
  layout.names = {area.x0, gates, x0, area.y1};
  layout.ruler = {x0, area.y0, x1, gates};
  layout.gates = {x0, gates, x1, lanes};
  layout.lanes = {x0, lanes, x1, area.y1};
  layout.range = range;
  return layout;
}

void draw_ruler(Ui& ui, const LaneLayout& layout) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const FontScope font(ui.fonts().small);
  const double step = ruler_step(layout.range, layout.lanes.width(), ui.px(64));
  const int digits = step >= 1.0 ? 0 : step >= 0.1 ? 1 : step >= 0.01 ? 2 : 3;
  const double minor = step / 5.0;
  const auto first = static_cast<std::int64_t>(std::ceil(layout.range.begin_s / minor));
  for (std::int64_t i = first; static_cast<double>(i) * minor <= layout.range.end_s; ++i) {
    const double t_s = static_cast<double>(i) * minor;
    if (t_s < 0.0) continue;
    const float x = std::round(layout.x_of(t_s));
    const bool major = i % 5 == 0;
    const float tall = major ? ui.px(8) : ui.px(4);
    list.AddRectFilled({x, layout.ruler.y1 - tall}, {x + 1.0F, layout.ruler.y1}, to_u32(ui.theme().text_disabled));
    if (!major) continue;
    list.AddRectFilled({x, layout.lanes.y0}, {x + 1.0F, layout.lanes.y1}, to_u32(ui.theme().line, 0.45F));
    const std::string words = fmt::format("{:.{}f} s", t_s, digits);
    const ImVec2 size = ImGui::CalcTextSize(words.c_str());
    if (x + size.x < layout.ruler.x1)
      list.AddText({x + ui.px(4), layout.ruler.y0 + ui.px(1)}, to_u32(ui.theme().text_dim), words.c_str());
  }
  list.AddRectFilled({layout.names.x0, layout.ruler.y1}, {layout.lanes.x1, layout.ruler.y1 + 1.0F},
                     to_u32(ui.theme().line));
}

void draw_lanes(Ui& ui, const LaneLayout& layout, const LaneSet& lane_set, const demonstration::Demonstration& shown,
                const LaneData& data, std::span<const review::Problem> problems) {
  Lanes lanes(ui, layout);
  const Rgba left = mix(ui.theme().accent, ui.theme().text, 0.1F);
  const Rgba right = mix(ui.theme().warning, ui.theme().text, 0.1F);
  if (has(lane_set, Lane::kSegments)) draw_segments(lanes, ui, layout, shown);
  if (has(lane_set, Lane::kAuthority)) draw_authority(lanes, data);
  if (has(lane_set, Lane::kJawLeft)) draw_jaw(lanes, ui, data, 0, left);
  if (has(lane_set, Lane::kJawRight)) draw_jaw(lanes, ui, data, 1, right);
  if (has(lane_set, Lane::kHolds)) {
    draw_flags(lanes, data, Lane::kHolds, {demonstration::kLeftHolds, demonstration::kRightHolds}, {left, right});
  }
  if (has(lane_set, Lane::kPedals)) {
    draw_flags(lanes, data, Lane::kPedals, {demonstration::kAgentPedal, demonstration::kClutchPedal},
               {ui.theme().good, ui.theme().text_dim});
  }
  if (has(lane_set, Lane::kNotes)) draw_notes(lanes, shown);
  if (has(lane_set, Lane::kProblems)) draw_problems(lanes, problems);
  if (has(lane_set, Lane::kEdits)) draw_edits(lanes, ui, shown, data);
  if (has(lane_set, Lane::kOriginal)) draw_original(lanes, data);
}

}  // namespace trocar::ui
