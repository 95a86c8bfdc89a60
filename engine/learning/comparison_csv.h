/// What two models measure, as rows of a file.
#pragma once

#include <string>

#include "engine/learning/model.h"
#include "engine/learning/model_comparison.h"

namespace trocar::learning {

/// A header "measure,a,b" and one row for each measure of `comparison`; the shortest text that reads back as the same
/// number, nothing where there is none (what an exact model draws at random).
std::string comparison_csv(const Model& a, const Model& b, const ModelComparison& comparison);

}  // namespace trocar::learning
