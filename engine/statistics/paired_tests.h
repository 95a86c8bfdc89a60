/// Tests of what was measured twice on the same: by one mode and by another (the paper's section V.B).
#pragma once

#include <span>

namespace trocar::statistics {

struct PairedT {
  double t = 0.0;
  int degrees_of_freedom = 0;
  double p = 1.0;       ///< Two-sided.
  double effect = 0.0;  ///< Cohen's d_z: mean of the differences by their standard deviation.
};
/// Student's t of the differences. NaN throughout for fewer than 2, or where all differences are the same.
PairedT paired_t(std::span<const double> differences);

struct SignedRank {
  double w = 0.0;  ///< The smaller of the two sums of ranks.
  int count = 0;   ///< Differences that are not 0.
  double p = 1.0;  ///< Two-sided; exact up to 50 differences without ties, by the normal distribution else.
  bool exact = true;
};
/// Wilcoxon's signed ranks; differences of 0 are left out, ties have the mean of their ranks.
SignedRank wilcoxon_signed_rank(std::span<const double> differences);

struct Normality {
  double w = 0.0;
  double p = 1.0;
};
/// Shapiro and Wilk's test of a normal distribution by Royston's approximation (AS R94). NaN for fewer than 3 or more
/// than 5,000 values, or where all are the same.
Normality shapiro_wilk(std::span<const double> values);

}  // namespace trocar::statistics
