/// Mean, standard deviation and median of a list of numbers.
#pragma once

#include <span>

namespace trocar::statistics {

/// NaN for an empty list.
double mean(std::span<const double> values);
/// With n − 1 in the denominator; NaN for fewer than two values.
double standard_deviation(std::span<const double> values);
/// The mean of the two middle values for an even count; NaN for an empty list.
double median(std::span<const double> values);

}  // namespace trocar::statistics
