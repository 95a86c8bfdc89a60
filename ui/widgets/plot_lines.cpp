#include "ui/widgets/plot_lines.h"

#include <algorithm>
#include <cmath>

#include "ui/widgets/stroke.h"

namespace trocar::ui {
namespace {

constexpr float kDash = 6.0F;  // All at 100 %.
constexpr float kPause = 4.0F;

float line_width(const Ui& ui, LineStyle style) {
  return style == LineStyle::kGhost ? std::max(ui.px(1), 1.0F) : 1.6F * ui.scale();
}

void stroke_here(const std::vector<ImVec2>& points, ImU32 colour, float width) {
  stroke(*ImGui::GetWindowDrawList(), points, colour, width);
}

// The dashes go on around the corners, so that a line of many short pieces has them, too.
void stroke_dashed(const Ui& ui, const std::vector<ImVec2>& points, ImU32 colour, float width) {
  const float dash = kDash * ui.scale();
  const float pause = kPause * ui.scale();
  std::vector<ImVec2> piece;
  bool down = true;
  float left = dash;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i == 0) {
      piece.push_back(points[0]);
      continue;
    }
    ImVec2 at = points[i - 1];
    float way = std::hypot(points[i].x - at.x, points[i].y - at.y);
    for (; way > left; left = down ? dash : pause) {
      const float share = left / way;
      at = {at.x + share * (points[i].x - at.x), at.y + share * (points[i].y - at.y)};
      way -= left;
      if (down) {
        piece.push_back(at);
        stroke_here(piece, colour, width);
      }
      piece.clear();
      down = !down;
      if (down) piece.push_back(at);
    }
    left -= way;
    if (down) piece.push_back(points[i]);
  }
  if (down) stroke_here(piece, colour, width);
}

}  // namespace

void draw_line(const Ui& ui, const PlotArea& area, const PlotLine& line) {
  // Two pixels a column: finer cannot be told from it, and costs twice.
  const int columns = std::max(static_cast<int>(area.rect.width() / 2.0F), 1);
  const ImU32 colour = to_u32(line.colour);
  const float width = line_width(ui, line.style);
  std::vector<ImVec2> points;
  for (const auto& piece : line.curve->lines(area.begin_s, area.end_s, columns)) {
    points.clear();
    for (const plot::CurvePoint& point : piece) points.push_back({area.x_of(point.x), area.y_of(point.y)});
    if (points.size() == 1) {
      ImGui::GetWindowDrawList()->AddCircleFilled(points[0], width, colour);
    } else if (line.style == LineStyle::kDashed) {
      stroke_dashed(ui, points, colour, width);
    } else {
      stroke_here(points, colour, width);
    }
  }
}

void draw_sample(const Ui& ui, const PlotLine& line, float x0, float x1, float y) {
  const std::vector<ImVec2> points{{x0, y}, {x1, y}};
  if (line.style == LineStyle::kDashed) {
    stroke_dashed(ui, points, to_u32(line.colour), line_width(ui, line.style));
  } else {
    stroke_here(points, to_u32(line.colour), line_width(ui, line.style));
  }
  draw_mark(ui, line, {0.5F * (x0 + x1), y});
}

void draw_mark(const Ui& ui, const PlotLine& line, ImVec2 at) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float half = ui.px(3);
  if (line.style == LineStyle::kSolid) list.AddCircleFilled(at, half, to_u32(line.colour));
  if (line.style == LineStyle::kDashed) {
    list.AddRectFilled({at.x - half, at.y - half}, {at.x + half, at.y + half}, to_u32(line.colour));
  }
}

void draw_dashes(const Ui& ui, ImVec2 from, ImVec2 to, ImU32 colour, float width) {
  stroke_dashed(ui, {from, to}, colour, width);
}

}  // namespace trocar::ui
