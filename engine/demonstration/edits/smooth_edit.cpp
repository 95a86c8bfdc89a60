// Smooth: a filter over each coordinate of the tool's path, and how far it may go.
#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>

#include "engine/demonstration/edits/contact_lock.h"
#include "engine/demonstration/edits/edit_functions.h"
#include "engine/demonstration/edits/stretch.h"
#include "engine/demonstration/motion.h"

namespace trocar::demonstration {
namespace {

using Path = std::vector<Eigen::Vector3d>;

/// A weighted mean of the neighbours of each point; at the ends the window is cut to what there is, evenly on both
/// sides, so that a straight path stays straight.
Path convolved(const Path& path, const std::vector<double>& half_weights) {
  const auto reach = static_cast<std::ptrdiff_t>(half_weights.size()) - 1;
  const std::ptrdiff_t count = std::ssize(path);
  Path result(path.size());
  for (std::ptrdiff_t i = 0; i < count; ++i) {
    const std::ptrdiff_t side = std::min({reach, i, count - 1 - i});
    Eigen::Vector3d sum = half_weights[0] * path[static_cast<std::size_t>(i)];
    double total = half_weights[0];
    for (std::ptrdiff_t j = 1; j <= side; ++j) {
      const double weight = half_weights[static_cast<std::size_t>(j)];
      sum += weight * (path[static_cast<std::size_t>(i - j)] + path[static_cast<std::size_t>(i + j)]);
      total += 2.0 * weight;
    }
    result[static_cast<std::size_t>(i)] = sum / total;
  }
  return result;
}

/// Savitzky–Golay: the value in the middle of the cubic that fits the window best (Savitzky and Golay, 1964).
Path savitzky_golay(const Path& path, std::ptrdiff_t reach) {
  const std::ptrdiff_t count = std::ssize(path);
  Path result(path.size());
  std::vector<std::vector<double>> weights(static_cast<std::size_t>(reach) + 1);
  for (std::ptrdiff_t i = 0; i < count; ++i) {
    const std::ptrdiff_t side = std::min({reach, i, count - 1 - i});
    std::vector<double>& w = weights[static_cast<std::size_t>(side)];
    if (w.empty()) {
      // Closed form for degree 2 and 3: the weight of the neighbour j is proportional to 3m² + 3m − 1 − 5j².
      const auto m = static_cast<double>(side);
      for (std::ptrdiff_t j = 0; j <= side; ++j) {
        w.push_back(side == 0 ? 1.0
                              : 3.0 * (3.0 * m * m + 3.0 * m - 1.0 - 5.0 * static_cast<double>(j * j)) /
                                    ((2.0 * m - 1.0) * (2.0 * m + 1.0) * (2.0 * m + 3.0)));
      }
    }
    Eigen::Vector3d sum = w[0] * path[static_cast<std::size_t>(i)];
    for (std::ptrdiff_t j = 1; j <= side; ++j) {
      sum += w[static_cast<std::size_t>(j)] *
             (path[static_cast<std::size_t>(i - j)] + path[static_cast<std::size_t>(i + j)]);
    }
    result[static_cast<std::size_t>(i)] = sum;
  }
  return result;
}

/// One pole forward and the same backward: no phase, the ends held.
Path low_passed(Path path, double share) {
  for (std::size_t i = 1; i < path.size(); ++i) path[i] = path[i - 1] + share * (path[i] - path[i - 1]);
  for (std::size_t i = path.size() - 1; i-- > 0;) path[i] = path[i + 1] + share * (path[i] - path[i + 1]);
  return path;
}

Path filtered(const Path& path, const Smooth& edit, double step_s) {
  const auto reach = static_cast<std::ptrdiff_t>(std::clamp(std::round(0.5 * edit.width_s / step_s), 1.0, 2000.0));
  switch (edit.filter) {
    case Filter::kSavitzkyGolay:
      return savitzky_golay(path, reach);
    case Filter::kGaussian: {
      // The window reaches to two standard deviations.
      std::vector<double> weights;
      for (std::ptrdiff_t j = 0; j <= reach; ++j) {
        const double x = 2.0 * static_cast<double>(j) / static_cast<double>(reach);
        weights.push_back(std::exp(-0.5 * x * x));
      }
      return convolved(path, weights);
    }
    case Filter::kLowPass:
      return low_passed(path, 1.0 - std::exp(-step_s / (0.25 * edit.width_s)));
  }
  return path;
}

}  // namespace

Result<Demonstration> made_by(const Demonstration& document, const Smooth& edit) {
  TROCAR_RETURN_IF_ERROR(check_positive(edit.width_s, "the width of the window"));
  TROCAR_RETURN_IF_ERROR(check_positive(edit.max_deviation_m, "the greatest deviation"));
  TROCAR_ASSIGN_OR_RETURN(const TrackPart part, part_of(document, edit.from_s, edit.to_s, 3));
  const double covered_s = part.samples.back().t_s() - part.samples.front().t_s();
  const double step_s = covered_s / static_cast<double>(part.samples.size() - 1);
  const ContactLock lock(part.samples, {edit.lock_contacts, edit.lock_ends, edit.lock_jaws});
  std::array<Path, 2> by_m;
  for (const std::size_t arm : indices_of(edit.arms)) {
    Path path;
    path.reserve(part.samples.size());
    for (const Sample& sample : part.samples) path.push_back(measured_tip(sample, arm));
    by_m[arm] = filtered(path, edit, step_s);
    for (std::size_t i = 0; i < path.size(); ++i) {
      Eigen::Vector3d& by = by_m[arm][i];
      by = lock.freedom(i) * (by - path[i]);
      if (by.norm() > edit.max_deviation_m) by *= edit.max_deviation_m / by.norm();
    }
  }
  return with_changed(document, part, [&](Sample& sample, std::size_t i) {
    for (const std::size_t arm : indices_of(edit.arms)) {
      displace(sample, arm, by_m[arm][i], Eigen::Quaterniond::Identity(), document.block);
    }
  });
}

}  // namespace trocar::demonstration
