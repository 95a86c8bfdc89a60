#include "engine/learning/outside_partition.h"

#include <cmath>
#include <limits>

#include "engine/core/check.h"
#include "engine/learning/portable_math.h"

namespace trocar::learning {
namespace {

constexpr int kBlock = 256;  ///< Exponents go in steps of 2^256, so most sums need no shift.
constexpr double kUp = 0x1p256;
constexpr double kDown = 0x1p-256;
constexpr double kTolerance = 1e-12;
constexpr int kMaxRounds = 100'000;

/// A positive number mantissa · 2^(256 · block), or 0: a double with room for e^±(10^11).
struct WideNumber {
  double mantissa = 0.0;
  std::int32_t block = 0;
};

WideNumber wide_exp(double logarithm) {
  const double block = std::floor(logarithm / (kBlock * kLn2) + 0.5);
  return {portable_exp(logarithm - block * kBlock * kLn2), static_cast<std::int32_t>(block)};
}

double wide_log(const WideNumber& number) {
  return portable_log(number.mantissa) + number.block * (kBlock * kLn2);
}

void add(WideNumber& sum, const WideNumber& term) {
  if (term.mantissa == 0.0) return;
  if (sum.mantissa == 0.0 || term.block > sum.block + 1) {
    sum = term;
  } else if (term.block == sum.block) {
    sum.mantissa += term.mantissa;
  } else if (term.block == sum.block - 1) {
    sum.mantissa += term.mantissa * kDown;
  } else if (term.block == sum.block + 1) {
    sum = {sum.mantissa * kDown + term.mantissa, term.block};
  }
}

void normalise(WideNumber& number) {
  if (number.mantissa == 0.0) return;
  while (number.mantissa > 0x1p128) {
    number.mantissa *= kDown;
    ++number.block;
  }
  while (number.mantissa < 0x1p-128) {
    number.mantissa *= kUp;
    --number.block;
  }
}

class OutsideSolver {
 public:
  OutsideSolver(const Model& model, const std::vector<double>& log_partition)
      : model_(model), n_(model.grid.n), values_(log_partition.size()) {
    for (std::size_t s = 0; s < values_.size(); ++s) {
      if (model.safe.flags()[s] != 0 && std::isfinite(log_partition[s])) values_[s] = wide_exp(log_partition[s]);
    }
  }

  void solve() {
    // Eight directions of travel: whichever way a cell's best paths run, one of the sweeps follows them.
    for (int round = 0; round < kMaxRounds; ++round) {
      bool settled = true;
      for (int direction = 0; direction < 8; ++direction) settled = sweep(direction) && settled;
      if (settled) return;
    }
    TROCAR_CHECK(false);  // θ below the limit makes the sweep a contraction
  }

  void write(std::vector<double>& log_partition) const {
    for (std::size_t s = 0; s < values_.size(); ++s) {
      if (model_.safe.flags()[s] == 0) log_partition[s] = wide_log(values_[s]);
    }
  }

 private:
  bool sweep(int direction) {
    bool settled = true;
    for (int i = 0; i < n_; ++i) {
      const int x = (direction & 1) != 0 ? n_ - 1 - i : i;
      for (int j = 0; j < n_; ++j) {
        const int y = (direction & 2) != 0 ? n_ - 1 - j : j;
        for (int k = 0; k < n_; ++k) {
          const int z = (direction & 4) != 0 ? n_ - 1 - k : k;
          settled = update(x, y, z) && settled;
        }
      }
    }
    return settled;
  }

  bool update(int x, int y, int z) {
    const auto s = static_cast<std::size_t>((x * n_ + y) * n_ + z);
    if (model_.safe.flags()[s] != 0) return true;
    const auto n = static_cast<std::size_t>(n_);
    WideNumber sum;
    if (x + 1 < n_) add(sum, values_[s + n * n]);
    if (x > 0) add(sum, values_[s - n * n]);
    if (y + 1 < n_) add(sum, values_[s + n]);
    if (y > 0) add(sum, values_[s - n]);
    if (z + 1 < n_) add(sum, values_[s + 1]);
    if (z > 0) add(sum, values_[s - 1]);
    sum.mantissa *= weight(s);
    normalise(sum);
    const WideNumber old = values_[s];
    values_[s] = sum;
    return sum.mantissa != 0.0 && old.block == sum.block &&
           std::abs(sum.mantissa - old.mantissa) <= kTolerance * sum.mantissa;
  }

  /// e^θ; θ outside of the safe set is mostly the prior, so the last value is worth keeping.
  double weight(std::size_t s) {
    if (model_.theta[s] != last_theta_) {
      last_theta_ = model_.theta[s];
      last_weight_ = portable_exp(last_theta_);
    }
    return last_weight_;
  }

  const Model& model_;
  int n_;
  std::vector<WideNumber> values_;
  double last_theta_ = std::numeric_limits<double>::quiet_NaN();
  double last_weight_ = 0.0;
};

}  // namespace

void complete_partition(const Model& model, std::vector<double>& log_partition) {
  OutsideSolver solver(model, log_partition);
  solver.solve();
  solver.write(log_partition);
}

}  // namespace trocar::learning
