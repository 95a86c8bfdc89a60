#include "engine/workbench/reviewing.h"

#include <algorithm>

#include "engine/core/same_object.h"
#include "engine/workbench/review_goals.h"

namespace trocar::workbench {

std::shared_ptr<const ReviewView> ReviewMaker::make(const ReviewRequest& request) {
  if (!request.document) return nullptr;
  for (auto kept = kept_.begin(); kept != kept_.end(); ++kept) {
    if (!same_object(kept->document, request.document) || !same_object(kept->model, request.model)) continue;
    std::rotate(kept_.begin(), kept, kept + 1);
    auto again = std::make_shared<ReviewView>(kept_.front().view);
    again->of = request;
    return again;
  }
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
  kept_.push_front({request.document, request.model, *view});
  kept_.front().view.of = {};
  if (kept_.size() > kKeptReviews) kept_.pop_back();
  return view;
}

}  // namespace trocar::workbench
