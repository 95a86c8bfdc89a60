/// Where the tools of a recording have been, sparsely: for trails, cameras that follow, and measures.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "engine/demonstration/demonstration.h"
#include "engine/stage/stage.h"

namespace trocar::workbench {

/// Immutable. Threads: any.
class FilmTips {
 public:
  /// Between the instants, about 50 a second.
  FilmTips(const demonstration::Demonstration& shown, double in_s, double out_s);

  /// p_WT of the left tool, over 0.8 s evenly: a camera does not tremble with the hand.
  Eigen::Vector3d followed(double at_s) const;
  /// Of the left tool, over 0.2 s.
  double speed_m_s(double at_s) const;
  /// Of the left tool, since the begin.
  double path_m(double at_s) const;
  /// Of both tools, of the time before.
  std::vector<stage::PathLayer> trails(double at_s, double length_s) const;

 private:
  /// The first point at or after an instant, at most the last.
  std::size_t index_at(double at_s) const;

  std::vector<double> t_s_;
  std::array<std::vector<Eigen::Vector3d>, 2> p_WT_;
  std::vector<double> path_m_;
};

}  // namespace trocar::workbench
