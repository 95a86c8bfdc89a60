#include "engine/demonstration/join.h"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "engine/demonstration/motion.h"

namespace trocar::demonstration {
namespace {

void add_join(const Demonstration& after, std::size_t index, std::vector<Join>& joins) {
  if (index > 0 && index < after.samples.size()) joins.push_back(join_at(after, index));
}

std::vector<Join> joins_around(const Splice& splice, const Demonstration& before, const Demonstration& after) {
  const std::size_t first = before.samples.lower_bound(before.tick_from(std::max(splice.at_s, 0.0)));
  const std::size_t last = splice.until_s > splice.at_s
                               ? std::max(before.samples.lower_bound(before.tick_from(splice.until_s)), first)
                               : first;
  const std::size_t follow = before.samples.size() - last;
  std::vector<Join> joins;
  add_join(after, first, joins);
  if (follow < after.samples.size()) add_join(after, after.samples.size() - follow, joins);
  return joins;
}

}  // namespace

Join join_at(const Demonstration& document, std::size_t index) {
  const Sample from = document.samples[index - 1];
  const Sample to = document.samples[index];
  Join join{document.time_of(to), Tick{to.tick - from.tick - kTicksPerSample}.seconds(), 0.0, 0.0};
  for (std::size_t arm = 0; arm < 2; ++arm) {
    const spatial::Pose a = from.arms[arm].measured.pose();
    const spatial::Pose b = to.arms[arm].measured.pose();
    join.moved_m = std::max(join.moved_m, (b.p - a.p).norm());
    join.turned_rad = std::max(join.turned_rad, a.q.angularDistance(b.q));
  }
  return join;
}

std::vector<Join> joins_of(const Edit& edit, const Demonstration& before, const Demonstration& after) {
  if (const auto* splice = std::get_if<Splice>(&edit)) return joins_around(*splice, before, after);
  std::vector<Join> joins;
  if (const auto* deleted = std::get_if<DeleteSpan>(&edit)) {
    add_join(after, before.samples.lower_bound(before.tick_from(deleted->from_s)), joins);
  }
  return joins;
}

std::string sentence_of(const std::vector<Join>& joins) {
  std::string words;
  for (const Join& join : joins) {
    words += fmt::format("{}{:.2f} mm and {:.1f}° at {:.2f} s", words.empty() ? "the tools jump " : ", ",
                         1e3 * join.moved_m, 180.0 / std::numbers::pi * join.turned_rad, join.at_s);
    if (join.gap_s > 0.0) words += fmt::format(" over a gap of {:.2f} s", join.gap_s);
  }
  return words;
}

}  // namespace trocar::demonstration
