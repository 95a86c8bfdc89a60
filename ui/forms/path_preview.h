/// Two small views of the paths of a demonstration over the board, from above and from the front.
#pragma once

#include <Eigen/Core>
#include <array>
#include <memory>
#include <vector>

#include "ui/panel.h"

namespace trocar::ui {

/// Keeps the thinned path of the demonstration last drawn.
class PathPreview {
 public:
  /// `size` in pixels. Both tools have a colour and, where they begin, a letter; the board and the pegs are drawn where
  /// they are, so that a wrong unit or hand is seen.
  void draw(Ui& ui, const std::shared_ptr<const demonstration::Demonstration>& shown, ImVec2 size);

 private:
  void take(const std::shared_ptr<const demonstration::Demonstration>& shown);
  void draw_view(Ui& ui, std::string_view label, int across, int up, const Rect& rect) const;

  std::shared_ptr<const demonstration::Demonstration> shown_;
  std::array<std::vector<Eigen::Vector3d>, 2> paths_;  ///< p_WT in metres.
  Eigen::Vector3d low_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d high_ = Eigen::Vector3d::Zero();
};

}  // namespace trocar::ui
