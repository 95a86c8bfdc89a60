/// Quick fixes: for a problem the ordinary edit that mends it, where there is one.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/demonstration/edit.h"
#include "engine/review/review.h"

namespace trocar::review {

/// The edit as a person types it after `trocar demo edit PROJECT DEMO`, without the parameters that are as usual.
std::string words_of_fix(const demonstration::Edit& edit);
/// Errors: those of `demonstration::edit_from_words`; kNotFound if the problem has no fix.
Result<demonstration::Edit> edit_of_fix(const Problem& problem);

/// How much of its displacement a smoothly fading edit gives at an instant, 0 … 1.
double fade(const demonstration::MoveTool& edit, double t_s);

/// How far a tool must go at an instant.
struct Need {
  double t_s = 0.0;
  double by_m = 0.0;
};
/// Moves a tool around `at_s` along `direction` (W, unit), fading, by so much that every need is met. Nothing where
/// that would be more than 20 mm.
std::optional<demonstration::MoveTool> moved_away(std::size_t arm, double at_s, const Eigen::Vector3d& direction,
                                                  const std::vector<Need>& needs);

/// The fixes of all problems that have one, worst first, each made for the demonstration as those before it left it.
/// One that would leave no fewer errors, or as many errors and no fewer warnings (then notes), is left out.
std::vector<demonstration::Edit> fixes_of_all(const demonstration::Demonstration& document,
                                              const ReviewOptions& options = {});

/// Gives a fix to those that have none: speed cap, smoothing, bridge, labels, jaw.
void add_fixes(const demonstration::Demonstration& document, const ReviewOptions& options,
               std::vector<Problem>& problems);

}  // namespace trocar::review
