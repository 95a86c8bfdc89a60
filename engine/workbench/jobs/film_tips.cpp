#include "engine/workbench/jobs/film_tips.h"

#include <algorithm>

#include "engine/demonstration/motion.h"
#include "engine/plot/colour_map.h"

namespace trocar::workbench {
namespace {

constexpr double kApart_s = 0.0199;

}  // namespace

FilmTips::FilmTips(const demonstration::Demonstration& shown, double in_s, double out_s) {
  for (const demonstration::Sample sample : shown.samples_within(in_s, out_s)) {
    const double t_s = shown.time_of(sample);
    if (!t_s_.empty() && t_s - t_s_.back() < kApart_s) continue;
    t_s_.push_back(t_s);
    for (std::size_t arm = 0; arm < 2; ++arm) p_WT_[arm].push_back(demonstration::measured_tip(sample, arm));
    const std::vector<Eigen::Vector3d>& left = p_WT_[0];
    path_m_.push_back(path_m_.empty() ? 0.0 : path_m_.back() + (left.back() - left[left.size() - 2]).norm());
  }
}

std::size_t FilmTips::index_at(double at_s) const {
  const auto found = std::lower_bound(t_s_.begin(), t_s_.end(), at_s - 1e-9);
  return std::min(static_cast<std::size_t>(found - t_s_.begin()), t_s_.empty() ? 0 : t_s_.size() - 1);
}

Eigen::Vector3d FilmTips::followed(double at_s) const {
  if (t_s_.empty()) return Eigen::Vector3d::Zero();
  const std::size_t first = index_at(at_s - 0.4);
  const std::size_t last = index_at(at_s + 0.4);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t i = first; i <= last; ++i) sum += p_WT_[0][i];
  return sum / static_cast<double>(last - first + 1);
}

double FilmTips::speed_m_s(double at_s) const {
  if (t_s_.size() < 2) return 0.0;
  const std::size_t first = index_at(at_s - 0.1);
  const std::size_t last = std::max(index_at(at_s + 0.1), first + 1);
  if (last >= t_s_.size()) return 0.0;
  return (path_m_[last] - path_m_[first]) / (t_s_[last] - t_s_[first]);
}

double FilmTips::path_m(double at_s) const {
  return path_m_.empty() ? 0.0 : path_m_[index_at(at_s)];
}

std::vector<stage::PathLayer> FilmTips::trails(double at_s, double length_s) const {
  std::vector<stage::PathLayer> layers;
  if (t_s_.empty()) return layers;
  const auto first = static_cast<std::ptrdiff_t>(index_at(at_s - length_s));
  const auto end = static_cast<std::ptrdiff_t>(index_at(at_s)) + 1;
  for (std::size_t arm = 0; arm < 2; ++arm) {
    stage::PathLayer layer;
    layer.points.assign(p_WT_[arm].begin() + first, p_WT_[arm].begin() + end);
    layer.colours = {plot::category(arm == 0 ? 0 : 1)};
    if (layer.points.size() > 1) layers.push_back(std::move(layer));
  }
  return layers;
}

}  // namespace trocar::workbench
