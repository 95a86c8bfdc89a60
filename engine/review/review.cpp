#include "engine/review/review.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "engine/review/fixes.h"
#include "engine/review/problem_parts.h"

namespace trocar::review {
namespace {

using demonstration::ProblemKind;

void add_geometry(const Reviewed& of, std::vector<Problem>& problems) {
  const bool finite = std::none_of(problems.begin(), problems.end(),
                                   [](const Problem& problem) { return problem.kind == ProblemKind::kNotFinite; });
  if (!finite || of.times_s.empty()) return;
  add_collisions(of, problems);
  add_reach_problems(of, problems);
  add_goal_problems(of, problems);
}

/// "speed-1", "speed-2", by time.
void number(std::vector<Problem>& problems) {
  std::map<ProblemKind, int> seen;
  for (Problem& problem : problems) {
    problem.id = fmt::format("{}-{}", to_string(problem.kind), ++seen[problem.kind]);
  }
}

}  // namespace

Review Reviewer::make(const demonstration::Demonstration& document, const ReviewOptions& options) {
  Review review;
  review.problems = demonstration::problems(document, options.grid, options.bounds);
  review.clearance = clearance_.make(document);
  Reviewed of{document, document.gated(), {}, review.clearance, options};
  of.times_s.reserve(of.samples.size());
  for (std::size_t i = 0; i < of.samples.size(); ++i) {
    of.times_s.push_back(Tick{of.samples.tick(i) - document.first_tick()}.seconds());
  }
  add_geometry(of, review.problems);
  std::stable_sort(review.problems.begin(), review.problems.end(),
                   [](const Problem& a, const Problem& b) { return a.begin_s < b.begin_s; });
  add_fixes(document, options, review.problems);
  number(review.problems);
  return review;
}

std::size_t count_of(const std::vector<Problem>& problems, demonstration::Severity severity) {
  return static_cast<std::size_t>(std::count_if(
      problems.begin(), problems.end(), [severity](const Problem& problem) { return problem.severity == severity; }));
}

}  // namespace trocar::review
