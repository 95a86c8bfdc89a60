/// Counts of successes: an interval for their share, and the exact test for paired outcomes.
#pragma once

#include <cstdint>
#include <string>

namespace trocar::statistics {

struct Interval {
  double low = 0.0;
  double high = 1.0;
};

/// Wilson's score interval for `successes` of `count`; `z` is the normal quantile (1.96 for 95 %).
/// 0 … 1 if `count` is 0. Precondition: 0 ≤ successes ≤ count.
Interval wilson_interval(std::int64_t successes, std::int64_t count, double z = 1.959963984540054);

/// McNemar's exact two-sided p: that of a fair coin for the `only_a` against the `only_b` discordant pairs, 1 at most.
/// Precondition: neither is negative.
double mcnemar_exact_p(int only_a, int only_b);

/// Share of B less share of A over the same `pairs`, of which `only_a` and `only_b` succeeded with one alone: Wald's
/// interval with half a pair added to each of the four outcomes (Agresti and Min 2005). −1 … 1 where there are no
/// pairs.
Interval paired_difference_interval(int only_a, int only_b, int pairs, double z = 1.959963984540054);

/// A share of 0 … 1 as "37.5 %", with so many digits after the point. What is not all is never called 100 %, and what
/// is not nothing never 0 %: ">99.9 %", "<0.1 %". Precondition: 0 ≤ digits.
std::string share_text(double share, int digits);
/// A difference of shares, −1 … 1, in points of a per cent with its sign: "+12.5", "−0.3", "0.0"; likewise never
/// whole, nor nothing, where it is not: ">+99.9", ">−0.1". Precondition: 0 ≤ digits.
std::string points_text(double difference, int digits);
/// `part` of `whole`; "–" if there is no whole. Precondition: 0 ≤ part ≤ whole.
std::string percent_text(std::int64_t part, std::int64_t whole, int digits);

}  // namespace trocar::statistics
