/// The sparse linear systems behind `exact`: partition function and expected visits on the safe set.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/learning/model.h"

namespace trocar::learning {

/// Z(s) = e^θ(s) Σ Z(s') over the moves inside of the safe set, Z(goal) = 1, and the expected visits D of the paths
/// that this Z gives. Nothing outside of the safe set matters to them, as no path that starts inside leaves it.
///
/// Cells have labels 0 … count − 1 in the order of their distance to the goal under −θ (Dijkstra), the goal being 0, so
/// one Gauss–Seidel sweep carries Z along whole paths. Z is stored as z · 2^scale with a fixed whole scale for each
/// cell: no lattice is too large for a double. Memory: 104 bytes for each cell of the safe set.
class MaxentRegion {
 public:
  /// `theta`, by CellIndex, decides the labels and scales, which suit any θ near it best. Precondition: a safe cell
  /// reaches the goal (`check_training` sees to that).
  MaxentRegion(const Model& model, const std::vector<double>& theta);

  std::size_t count() const { return cells_.size(); }
  /// The cell of each label.
  const std::vector<std::int32_t>& cells() const { return cells_; }

  /// Solves for Z to a relative change of `tolerance` a sweep. `theta` is by label; the goal's is not used.
  /// Returns the sweeps it took. Starts from the previous solution.
  int solve_partition(const std::vector<double>& theta, double tolerance);
  /// log Z by label, after `solve_partition`.
  double log_partition(std::size_t label) const;
  /// Solves for D under the latest Z: visits of paths whose start is drawn from `starts` (by label, sum 1), the goal's
  /// included. Returns the sweeps it took. Starts from the previous solution.
  int solve_visits(const std::vector<double>& starts, double tolerance);
  /// D by label, after `solve_visits`.
  const std::vector<double>& visits() const { return visits_; }

 private:
  void label_cells(const Model& model, const std::vector<double>& theta);
  void choose_scales(const std::vector<double>& log_partition);
  void rescale();

  std::vector<std::int32_t> cells_;
  std::vector<std::int32_t> neighbours_;  ///< 6 for each label; `count()` where there is none.
  std::vector<double> ratios_;            ///< 2^(scale of the neighbour − own scale), 6 for each label.
  std::vector<std::int32_t> scales_;
  std::vector<double> weights_;    ///< e^θ.
  std::vector<double> partition_;  ///< z; one more, 0, for the missing neighbour.
  std::vector<double> outflow_;    ///< D e^θ / z; one more, 0.
  std::vector<double> visits_;
};

}  // namespace trocar::learning
