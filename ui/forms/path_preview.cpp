#include "ui/forms/path_preview.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/peg_board/peg_board.h"
#include "ui/widgets/plot.h"
#include "ui/widgets/stroke.h"

namespace trocar::ui {
namespace {

constexpr std::size_t kShownPoints = 1500;  // of each tool; more cannot be told apart

/// Of the board's metres in a rectangle of pixels, equal along both axes.
struct Projection {
  int across = 1;  ///< Axis of W that goes to the right.
  int up = 0;      ///< Axis of W that goes up; 0 goes down, towards who looks.
  float scale = 1.0F;
  ImVec2 middle;
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();

  ImVec2 at(const Eigen::Vector3d& p) const {
    const auto dx = static_cast<float>(p[across] - centre[across]);
    const auto dy = static_cast<float>(p[up] - centre[up]);
    return {middle.x + scale * dx, up == 0 ? middle.y + scale * dy : middle.y - scale * dy};
  }
};

void draw_board(ImDrawList& list, const Projection& to, const Theme& theme) {
  const double x_m = 0.5 * peg_board::kBoardX_m;
  const double y_m = 0.5 * peg_board::kBoardY_m;
  const double low_m = to.up == 2 ? -peg_board::kBoardZ_m : 0.0;
  const ImVec2 a = to.at({-x_m, -y_m, to.up == 2 ? 0.0 : low_m});
  const ImVec2 b = to.at({x_m, y_m, low_m});
  list.AddRectFilled({std::min(a.x, b.x), std::min(a.y, b.y)}, {std::max(a.x, b.x), std::max(a.y, b.y)},
                     to_u32(theme.raised));
  for (int peg = 0; peg < peg_board::kPegCount; ++peg) {
    const Eigen::Vector3d foot =
        peg < peg_board::kBlockCount ? peg_board::start_peg(peg) : peg_board::goal_peg(peg - peg_board::kBlockCount);
    const Eigen::Vector3d top = foot + Eigen::Vector3d(0.0, 0.0, peg_board::kPegHeight_m);
    const float radius = std::max(to.scale * static_cast<float>(peg_board::kPegRadius_m), 1.0F);
    list.AddLine(to.at(foot), to.at(top), to_u32(theme.text_disabled), 2.0F * radius);
    list.AddCircleFilled(to.at(top), radius, to_u32(theme.text_disabled));
  }
}

}  // namespace

void PathPreview::take(const std::shared_ptr<const demonstration::Demonstration>& shown) {
  if (shown == shown_) return;
  shown_ = shown;
  low_ = {-0.5 * peg_board::kBoardX_m, -0.5 * peg_board::kBoardY_m, -peg_board::kBoardZ_m};
  high_ = {0.5 * peg_board::kBoardX_m, 0.5 * peg_board::kBoardY_m, 2.0 * peg_board::kPegHeight_m};
  for (auto& path : paths_) path.clear();
  if (!shown) return;
  const std::size_t count = shown->samples.size();
  const std::size_t step = std::max<std::size_t>(count / kShownPoints, 1);
  for (std::size_t i = 0; i < count; i += step) {
    const demonstration::Sample sample = shown->samples[i];
    for (std::size_t arm = 0; arm < paths_.size(); ++arm) {
      const Eigen::Vector3d p_WT = sample.arms[arm].setpoint().p;
      paths_[arm].push_back(p_WT);
      low_ = low_.cwiseMin(p_WT);
      high_ = high_.cwiseMax(p_WT);
    }
  }
}

void PathPreview::draw_view(Ui& ui, std::string_view label, int across, int up, const Rect& rect) const {
  const Theme& theme = ui.theme();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled({rect.x0, rect.y0}, {rect.x1, rect.y1}, to_u32(theme.ground), ui.px(3));
  ImGui::PushClipRect({rect.x0, rect.y0}, {rect.x1, rect.y1}, true);
  const Eigen::Vector3d extent = (high_ - low_).cwiseMax(1e-6);
  const float margin = ui.px(10);
  const float scale = std::min((rect.width() - 2.0F * margin) / static_cast<float>(extent[across]),
                               (rect.height() - 2.0F * margin) / static_cast<float>(extent[up]));
  const Projection to{across, up, scale, {rect.centre_x(), rect.centre_y()}, 0.5 * (low_ + high_)};
  draw_board(list, to, theme);
  for (std::size_t arm = 0; arm < paths_.size(); ++arm) {
    const ImU32 colour = to_u32(arm_colour(theme, static_cast<int>(arm)));
    std::vector<ImVec2> points;
    points.reserve(paths_[arm].size());
    for (const Eigen::Vector3d& p_WT : paths_[arm]) points.push_back(to.at(p_WT));
    if (points.empty()) continue;
    stroke(list, points, colour, ui.px(1.5F));
    list.AddCircleFilled(points.front(), ui.px(3), colour);
    list.AddText({points.front().x + ui.px(5), points.front().y - ui.px(8)}, to_u32(theme.text), arm == 0 ? "L" : "R");
  }
  const std::string value = fmt::format("{:.0f} × {:.0f} mm", 1e3 * extent[across], 1e3 * extent[up]);
  {
    const FontScope font(ui.fonts().small);
    const std::string words = fmt::format("{}, {}", label, value);
    list.AddText({rect.x0 + ui.px(8), rect.y0 + ui.px(5)}, to_u32(theme.text_dim), words.c_str());
  }
  ImGui::PopClipRect();
  note_rect(ui, "picture", label, value, rect);
}

void PathPreview::draw(Ui& ui, const std::shared_ptr<const demonstration::Demonstration>& shown, ImVec2 size) {
  take(shown);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float half = std::floor(0.5F * (size.x - ui.px(6)));
  draw_view(ui, "From above", 1, 0, {at.x, at.y, at.x + half, at.y + size.y});
  draw_view(ui, "From the front", 1, 2, {at.x + size.x - half, at.y, at.x + size.x, at.y + size.y});
  ImGui::Dummy(size);
}

}  // namespace trocar::ui
