/// Draws what stands in a lane of the timeline: blocks, curves, marks and pictures, one lane below the other.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "engine/demonstration/demonstration.h"
#include "engine/plot/curve.h"
#include "engine/review/review.h"
#include "ui/panels/lane_data.h"
#include "ui/panels/timeline_lanes.h"
#include "ui/widgets/widgets.h"

namespace trocar::ui {

/// What a lane is called, and how high it is at 100 %.
struct LaneRow {
  std::string_view name;
  std::string_view help;
  float height = 0.0F;
};
const LaneRow& row_of(Lane lane);

/// Each lane is begun, filled and ended. Lanes that are scrolled away are noted where they would be, as far as they can
/// be seen.
class LanePainter {
 public:
  LanePainter(Ui& ui, const LaneLayout& layout) : ui_(ui), layout_(layout), y_(layout.lanes.y0 - layout.scroll) {}

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
  /// The whole height of the lane.
  Rect lane_rect() const { return {layout_.lanes.x0, y_, layout_.lanes.x1, y_ + height_}; }
  /// An area under a line, a column for each extent; nothing where `low` > `high`.
  void area(const std::vector<Extent>& extents, float low, float high, Rgba colour) const;
  /// A line; `dashed` tells it from another without colour.
  void line(const plot::Curve& curve, double low, double high, Rgba colour, bool dashed) const;
  /// Small words at the lane's right end.
  void words_at_end(std::string_view words) const;
  /// Notes what can be seen of `rect`, and gives the hint while the pointer is on it.
  void note_mark(std::string_view role, std::string_view label, std::string_view value, const Rect& rect,
                 const std::string& hint) const;
  void end();

 private:
  void dash(ImVec2 from, ImVec2 to, ImU32 colour, float thick) const;
  ImDrawList& list() const { return *ImGui::GetWindowDrawList(); }
  Ui& ui_;
  const LaneLayout& layout_;
  float y_;
  float height_ = 0.0F;
};

}  // namespace trocar::ui
