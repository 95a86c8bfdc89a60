// Smooth: a filter over each coordinate of the tool's path, and how far it may go.
#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <deque>

#include "engine/demonstration/edits/contact_lock.h"
#include "engine/demonstration/edits/edit_functions.h"
#include "engine/demonstration/edits/stretch.h"
#include "engine/demonstration/motion.h"
#include "engine/demonstration/sampling_rate.h"

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

/// The value in the middle of the polynomial that fits the window best, whatever the times between samples; the window
/// weighs by `half_weights`. With even times and equal weights a cubic is Savitzky and Golay's.
Path fitted(const Path& path, const std::vector<double>& t_s, const std::vector<double>& half_weights,
            Eigen::Index degree) {
  const auto reach = static_cast<std::ptrdiff_t>(half_weights.size()) - 1;
  const std::ptrdiff_t count = std::ssize(path);
  Path result = path;
  for (std::ptrdiff_t i = 0; i < count; ++i) {
    const std::ptrdiff_t side = std::min({reach, i, count - 1 - i});
    if (2 * side < degree) continue;
    const auto at = [&](std::ptrdiff_t j) { return static_cast<std::size_t>(i + j); };
    const double width_s = t_s[at(side)] - t_s[at(-side)];
    Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(degree + 1, degree + 1);
    Eigen::MatrixX3d right = Eigen::MatrixX3d::Zero(degree + 1, 3);
    for (std::ptrdiff_t j = -side; j <= side; ++j) {
      Eigen::VectorXd powers = Eigen::VectorXd::Ones(degree + 1);
      for (Eigen::Index k = 1; k <= degree; ++k) powers[k] = powers[k - 1] * (t_s[at(j)] - t_s[at(0)]) / width_s;
      const double weight = half_weights[static_cast<std::size_t>(std::abs(j))];
      normal += weight * powers * powers.transpose();
      right += weight * powers * (path[at(j)] - path[at(0)]).transpose();
    }
    result[at(0)] += normal.ldlt().solve(right).row(0).transpose();
  }
  return result;
}

/// One pole forward and the same backward: no phase, the ends held.
Path low_passed(Path path, const std::vector<double>& t_s, double settled_s) {
  const auto share = [&](std::size_t i) { return 1.0 - std::exp(-(t_s[i + 1] - t_s[i]) / settled_s); };
  for (std::size_t i = 1; i < path.size(); ++i) path[i] = path[i - 1] + share(i - 1) * (path[i] - path[i - 1]);
  for (std::size_t i = path.size() - 1; i-- > 0;) path[i] = path[i + 1] + share(i) * (path[i] - path[i + 1]);
  return path;
}

bool evenly_timed(const std::vector<double>& t_s, double step_s) {
  constexpr double kRounding_s = 1e-6;
  for (std::size_t i = 1; i < t_s.size(); ++i) {
    if (std::abs(t_s[i] - t_s[i - 1] - step_s) > kRounding_s) return false;
  }
  return true;
}

/// Of samples without a gap.
Path filtered(const Path& path, const std::vector<double>& t_s, const Smooth& edit) {
  if (path.size() < 3) return path;
  const double step_s = (t_s.back() - t_s.front()) / static_cast<double>(t_s.size() - 1);
  const auto reach = static_cast<std::ptrdiff_t>(std::clamp(std::round(0.5 * edit.width_s / step_s), 1.0, 2000.0));
  const bool even = evenly_timed(t_s, step_s);
  switch (edit.filter) {
    case Filter::kSavitzkyGolay:
      if (even) return savitzky_golay(path, reach);
      return fitted(path, t_s, std::vector<double>(static_cast<std::size_t>(reach) + 1, 1.0), 3);
    case Filter::kGaussian: {
      // The window reaches to two standard deviations.
      std::vector<double> weights;
      for (std::ptrdiff_t j = 0; j <= reach; ++j) {
        const double x = 2.0 * static_cast<double>(j) / static_cast<double>(reach);
        weights.push_back(std::exp(-0.5 * x * x));
      }
      return even ? convolved(path, weights) : fitted(path, t_s, weights, 1);
    }
    case Filter::kLowPass:
      return low_passed(path, t_s, 0.25 * edit.width_s);
  }
  return path;
}

/// What a window would reach over a gap has nothing to do with each other: each run between gaps for itself.
Path filtered(const Path& path, const SampleTrack& samples, const Smooth& edit) {
  std::vector<std::size_t> ends;
  for (const SampleGap& gap : sample_gaps(samples)) ends.push_back(gap.after);
  ends.push_back(samples.size());
  Path result;
  result.reserve(path.size());
  for (const std::size_t end : ends) {
    const std::size_t begin = result.size();
    std::vector<double> t_s;
    for (std::size_t i = begin; i < end; ++i) t_s.push_back(Tick{samples.tick(i) - samples.tick(0)}.seconds());
    const auto at = [&](std::size_t i) { return path.begin() + static_cast<std::ptrdiff_t>(i); };
    const Path run = filtered(Path(at(begin), at(end)), t_s, edit);
    result.insert(result.end(), run.begin(), run.end());
  }
  return result;
}

/// The least of each value and those up to `reach` away.
std::vector<double> least_around(const std::vector<double>& values, std::size_t reach) {
  std::vector<double> result(values.size());
  std::deque<std::size_t> rising;  // Indices of values that may still be the least, by value.
  std::size_t next = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    for (; next < values.size() && next <= i + reach; ++next) {
      while (!rising.empty() && values[rising.back()] >= values[next]) rising.pop_back();
      rising.push_back(next);
    }
    while (rising.front() + reach < i) rising.pop_front();
    result[i] = values[rising.front()];
  }
  return result;
}

/// Shortens displacements so that none is longer than `most_m`, with their neighbours, so that no kink is left where
/// the limit sets in: a mean over ±`reach` of the least share over ±`reach` is never above the share that is allowed.
void limit(Path& by_m, double most_m, std::size_t reach) {
  std::vector<double> share(by_m.size(), 1.0);
  bool all = true;
  for (std::size_t i = 0; i < by_m.size(); ++i) {
    const double length_m = by_m[i].norm();
    if (length_m <= most_m) continue;
    share[i] = most_m / length_m;
    all = false;
  }
  if (all) return;
  const std::vector<double> least = least_around(share, reach);
  std::vector<double> sums{0.0};
  for (const double value : least) sums.push_back(sums.back() + value);
  for (std::size_t i = 0; i < by_m.size(); ++i) {
    const std::size_t begin = i < reach ? 0 : i - reach;
    const std::size_t end = std::min(i + reach + 1, by_m.size());
    const double mean = (sums[end] - sums[begin]) / static_cast<double>(end - begin);
    by_m[i] *= std::min(mean, share[i]);
  }
}

}  // namespace

Result<Demonstration> made_by(const Demonstration& document, const Smooth& edit) {
  TROCAR_RETURN_IF_ERROR(check_positive(edit.width_s, "the width of the window"));
  TROCAR_RETURN_IF_ERROR(check_positive(edit.max_deviation_m, "the greatest deviation"));
  TROCAR_ASSIGN_OR_RETURN(const TrackPart part, part_of(document, edit.from_s, edit.to_s, 3));
  const double covered_s = part.samples.back().t_s() - part.samples.front().t_s();
  const double step_s = covered_s / static_cast<double>(part.samples.size() - 1);
  const auto reach = static_cast<std::size_t>(std::clamp(std::round(edit.width_s / step_s), 2.0, 4000.0));
  const ContactLock lock(part.samples, {edit.lock_contacts, edit.lock_ends, edit.lock_jaws});
  std::array<Path, 2> by_m;
  for (const std::size_t arm : indices_of(edit.arms)) {
    Path path;
    path.reserve(part.samples.size());
    for (const Sample& sample : part.samples) path.push_back(measured_tip(sample, arm));
    by_m[arm] = filtered(path, part.samples, edit);
    for (std::size_t i = 0; i < path.size(); ++i) by_m[arm][i] = lock.freedom(i) * (by_m[arm][i] - path[i]);
    limit(by_m[arm], edit.max_deviation_m, reach);
  }
  return with_changed(document, part, [&](Sample& sample, std::size_t i) {
    for (const std::size_t arm : indices_of(edit.arms)) {
      displace(sample, arm, by_m[arm][i], Eigen::Quaterniond::Identity(), document.block);
    }
  });
}

}  // namespace trocar::demonstration
