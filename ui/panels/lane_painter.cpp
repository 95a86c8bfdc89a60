#include "ui/panels/lane_painter.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "ui/format.h"
#include "ui/icons.h"
#include "ui/widgets/stroke.h"

namespace trocar::ui {
namespace {

// By `Lane`.
constexpr std::array<LaneRow, kLaneCount> kLanes{{
    {"Pictures", "Small pictures along time", 54.0F},
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
    {"x", "Where both tools are along x; the right one dashed", 34.0F},
    {"y", "Where both tools are along y; the right one dashed", 34.0F},
    {"z", "How high both tools are; the right one dashed", 34.0F},
    {"Speed", "How fast both tools move; the right one dashed", 34.0F},
    {"Acceleration", "Of both tools; the right one dashed", 34.0F},
    {"Jerk", "Of both tools; the right one dashed", 34.0F},
    {"Clearance", "How far both tools are from all that they could hit; the right one dashed", 34.0F},
}};

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

}  // namespace

const LaneRow& row_of(Lane lane) {
  return kLanes[static_cast<std::size_t>(lane)];
}

void LanePainter::begin(Lane lane) {
  const std::string_view name = row_of(lane).name;
  height_ = ui_.px(row_of(lane).height);
  const FontScope font(ui_.fonts().small);
  const float text = ImGui::GetFontSize();
  list().AddText({layout_.names.x0, std::round(y_ + 0.5F * (height_ - text))}, to_u32(ui_.theme().text_dim),
                 name.data(), name.data() + name.size());
}

void LanePainter::note_mark(std::string_view role, std::string_view label, std::string_view value, const Rect& rect,
                            const std::string& hint) const {
  const Rect seen{rect.x0, std::max(rect.y0, layout_.lanes.y0), rect.x1, std::min(rect.y1, layout_.lanes.y1)};
  if (seen.y1 <= seen.y0) return;
  note_rect(ui_, role, label, value, seen);
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  if (!hint.empty() && seen.contains(mouse.x, mouse.y)) ui_.set_hint(hint);
}

void LanePainter::end() {
  y_ += height_;
  list().AddRectFilled({layout_.names.x0, y_}, {layout_.lanes.x1, y_ + 1.0F}, to_u32(ui_.theme().line, 0.7F));
  y_ += 1.0F;
}

void LanePainter::block(double begin_s, double end_s, Rgba colour, std::string_view words,
                        std::string_view short_words) {
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

void LanePainter::thin_row(const std::vector<Run>& runs, int row, int rows, Rgba colour) const {
  const float each = (height_ - ui_.px(4)) / static_cast<float>(rows);
  const float y0 = y_ + ui_.px(2) + each * static_cast<float>(row);
  for (const Run& run : runs) {
    const float x0 = std::max(layout_.x_of(run.begin_s), layout_.lanes.x0);
    const float x1 = std::min(layout_.x_of(run.end_s), layout_.lanes.x1);
    if (x1 <= layout_.lanes.x0 || x0 >= layout_.lanes.x1) continue;
    list().AddRectFilled({x0, y0 + 1.0F}, {std::max(x1, x0 + 2.0F), y0 + each - 1.0F}, to_u32(colour), ui_.px(2));
  }
}

void LanePainter::area(const std::vector<Extent>& extents, float low, float high, Rgba colour) const {
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

void LanePainter::line(const plot::Curve& curve, double low, double high, Rgba colour, bool dashed) const {
  const float top = y_ + ui_.px(3);
  const float bottom = y_ + height_ - ui_.px(3);
  const double begin_s = layout_.range.begin_s;
  const double end_s = layout_.range.end_s;
  const int columns = std::max(static_cast<int>(layout_.lanes.width()), 1);
  const float thick = std::max(ui_.px(1.25F), 1.0F);
  list().PushClipRect({layout_.lanes.x0, y_}, {layout_.lanes.x1, y_ + height_}, true);
  std::vector<ImVec2> points;
  for (const std::vector<plot::CurvePoint>& stretch : curve.lines(begin_s, end_s, columns)) {
    points.clear();
    for (const plot::CurvePoint& point : stretch) {
      const auto share = static_cast<float>(std::clamp((point.y - low) / (high - low), 0.0, 1.0));
      points.push_back({layout_.x_of(point.x), bottom - share * (bottom - top)});
    }
    if (points.size() < 2) continue;
    if (!dashed) {
      stroke(list(), points, to_u32(colour), thick);
      continue;
    }
    for (std::size_t i = 1; i < points.size(); ++i) dash(points[i - 1], points[i], to_u32(colour), thick);
  }
  list().PopClipRect();
}

// By where it is along x, so that dashes stay in their places while the view is still.
void LanePainter::dash(ImVec2 from, ImVec2 to, ImU32 colour, float thick) const {
  const float length = ui_.px(5);
  const int pieces = std::max(static_cast<int>(std::ceil((to.x - from.x) / length)), 1);
  for (int i = 0; i < pieces; ++i) {
    const auto at = [&](float share) {
      return ImVec2{from.x + share * (to.x - from.x), from.y + share * (to.y - from.y)};
    };
    const float each = 1.0F / static_cast<float>(pieces);
    const ImVec2 middle = at(each * (static_cast<float>(i) + 0.5F));
    if (static_cast<int>(std::floor((middle.x - layout_.lanes.x0) / length)) % 3 == 2) continue;
    list().AddLine(at(each * static_cast<float>(i)), at(each * static_cast<float>(i + 1)), colour, thick);
  }
}

void LanePainter::words_at_end(std::string_view words) const {
  const FontScope font(ui_.fonts().small);
  const ImVec2 size = ImGui::CalcTextSize(words.data(), words.data() + words.size());
  const ImVec2 at{std::round(layout_.lanes.x1 - size.x - ui_.px(4)), std::round(y_ + ui_.px(2))};
  list().AddRectFilled({at.x - ui_.px(3), at.y}, {at.x + size.x + ui_.px(3), at.y + size.y},
                       to_u32(ui_.theme().panel, 0.85F), ui_.px(3));
  list().AddText(at, to_u32(ui_.theme().text_dim), words.data(), words.data() + words.size());
}

void LanePainter::mark(double t_s, bool up, Rgba colour) const {
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
void LanePainter::note(const demonstration::Note& note, std::string_view label) {
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
  note_mark("mark", label, note.text, rect, fmt::format("Note at {:.2f} s: {}", note.begin_s, note.text));
}

void LanePainter::problem(const review::Problem& problem) {
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
  note_mark("mark", problem.id, problem.message, rect,
            fmt::format("{} at {:.2f} s: {}", error ? "Error" : "Warning", problem.begin_s, problem.message));
}

Rect LanePainter::rect_of(double begin_s, double end_s) const {
  const float x0 = std::clamp(layout_.x_of(begin_s), layout_.lanes.x0, layout_.lanes.x1);
  const float x1 = std::clamp(layout_.x_of(end_s), layout_.lanes.x0, layout_.lanes.x1);
  return {x0, y_ + ui_.px(2), std::max(x1, x0 + ui_.px(3)), y_ + height_ - ui_.px(2)};
}

void LanePainter::outline(double begin_s, double end_s, std::string_view words) const {
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

void LanePainter::seam(double t_s) const {
  const float x = std::round(layout_.x_of(t_s));
  if (x < layout_.lanes.x0 || x > layout_.lanes.x1) return;
  const float half = ui_.px(5);
  const float y0 = y_ + ui_.px(3);
  const float y1 = y_ + height_ - ui_.px(3);
  const ImU32 colour = to_u32(ui_.theme().text_dim);
  list().AddTriangleFilled({x - half, y0}, {x - half, y1}, {x, 0.5F * (y0 + y1)}, colour);
  list().AddTriangleFilled({x + half, y0}, {x, 0.5F * (y0 + y1)}, {x + half, y1}, colour);
}

}  // namespace trocar::ui
