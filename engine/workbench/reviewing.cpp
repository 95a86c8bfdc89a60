#include "engine/workbench/reviewing.h"

#include <algorithm>

#include "engine/workbench/review_goals.h"

namespace trocar::workbench {

std::shared_ptr<const ReviewView> ReviewMaker::make(const ReviewRequest& request) {
  if (!request.document) return nullptr;
  auto view = std::make_shared<ReviewView>();
  view->of = request;
  review::ReviewOptions options;
  options.goals = goals_of(request.model.get());
  view->review = reviewer_.make(*request.document, options);
  const auto& problems = view->review.problems;
  const bool broken = std::any_of(problems.begin(), problems.end(), [](const review::Problem& problem) {
    return problem.kind == demonstration::ProblemKind::kNotFinite;
  });
  if (broken) view->incomplete = "Motion and distances were not checked: some numbers are not finite";
  return view;
}

}  // namespace trocar::workbench
