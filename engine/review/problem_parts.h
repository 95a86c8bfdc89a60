/// The parts of a review; each appends its problems to a list. Private to the module.
#pragma once

#include <optional>
#include <vector>

#include "engine/review/review.h"

namespace trocar::review {

/// What the parts look at. Precondition of all: every sample is finite.
struct Reviewed {
  const demonstration::Demonstration& document;
  demonstration::SampleTrack samples;  ///< Gated.
  std::vector<double> times_s;         ///< Of each.
  const ClearanceCurve& clearance;
  const ReviewOptions& options;
};

/// Neighbouring samples with the same problem.
struct ProblemRun {
  std::size_t first = 0;
  std::size_t last = 0;
  std::size_t worst = 0;
  double value = 0.0;     ///< At the worst.
  std::size_t count = 0;  ///< Of samples that have it.
};
/// `value(i)`: how bad it is at sample i, above 0; nothing where it is fine. What is at most `together_s` apart is one.
/// Only `candidates` are asked, which come in order.
template <typename Candidates, typename Value>
std::vector<ProblemRun> runs_of(const Reviewed& of, const Candidates& candidates, const Value& value,
                                double together_s = 0.1) {
  std::vector<ProblemRun> runs;
  for (const std::size_t i : candidates) {
    const std::optional<double> bad = value(i);
    if (!bad) continue;
    if (runs.empty() || of.times_s[i] - of.times_s[runs.back().last] > together_s) runs.push_back({i, i, i, *bad, 0});
    ProblemRun& run = runs.back();
    run.last = i;
    ++run.count;
    if (*bad > run.value) {
      run.worst = i;
      run.value = *bad;
    }
  }
  return runs;
}

void add_collisions(const Reviewed& of, std::vector<Problem>& found);
void add_reach_problems(const Reviewed& of, std::vector<Problem>& found);
void add_goal_problems(const Reviewed& of, std::vector<Problem>& found);

constexpr const char* tool_name(std::size_t arm) {
  return arm == 0 ? "left" : "right";
}

}  // namespace trocar::review
