// Simplify: the knots of Douglas and Peucker (1973), the path straight in between, each sample at its own time.
#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/demonstration/edits/edit_functions.h"
#include "engine/demonstration/edits/stretch.h"
#include "engine/demonstration/motion.h"

namespace trocar::demonstration {
namespace {

/// Where the tool would be at sample `i` if it moved straight, at constant speed, from sample `a` to sample `b`.
Eigen::Vector3d straight(const std::vector<Sample>& samples, std::size_t arm, std::size_t a, std::size_t b,
                         std::size_t i) {
  const double share = static_cast<double>(samples[i].tick - samples[a].tick) /
                       static_cast<double>(std::max<std::int64_t>(samples[b].tick - samples[a].tick, 1));
  const Eigen::Vector3d from = measured_tip(samples[a], arm);
  return from + share * (measured_tip(samples[b], arm) - from);
}

/// The indices that must stay, the first and the last among them.
std::vector<std::size_t> knots_of(const std::vector<Sample>& samples, std::size_t arm, double tolerance_m) {
  std::vector<std::size_t> knots{0, samples.size() - 1};
  std::vector<std::pair<std::size_t, std::size_t>> open{{0, samples.size() - 1}};
  while (!open.empty()) {
    const auto [a, b] = open.back();
    open.pop_back();
    std::size_t worst = a;
    double worst_m = tolerance_m;
    for (std::size_t i = a + 1; i < b; ++i) {
      const double off_m = (measured_tip(samples[i], arm) - straight(samples, arm, a, b, i)).norm();
      if (off_m > worst_m) std::tie(worst, worst_m) = std::pair(i, off_m);
    }
    if (worst == a) continue;
    knots.push_back(worst);
    open.insert(open.end(), {{a, worst}, {worst, b}});
  }
  std::sort(knots.begin(), knots.end());
  return knots;
}

}  // namespace

Result<Demonstration> made_by(const Demonstration& document, const Simplify& edit) {
  TROCAR_RETURN_IF_ERROR(check_positive(edit.tolerance_m, "the tolerance"));
  TROCAR_ASSIGN_OR_RETURN(Stretch stretch, stretch_of(document, edit.from_s, edit.to_s, 3));
  const std::vector<Sample> before = stretch.samples;
  for (const std::size_t arm : indices_of(edit.arms)) {
    const std::vector<std::size_t> knots = knots_of(before, arm, edit.tolerance_m);
    for (std::size_t k = 0; k + 1 < knots.size(); ++k) {
      for (std::size_t i = knots[k] + 1; i < knots[k + 1]; ++i) {
        const Eigen::Vector3d by_m = straight(before, arm, knots[k], knots[k + 1], i) - measured_tip(before[i], arm);
        displace(stretch.samples[i], arm, by_m, Eigen::Quaterniond::Identity(), document.block);
      }
    }
  }
  return with_stretch(document, std::move(stretch));
}

}  // namespace trocar::demonstration
