/// The lattice on which the agent learns: `n` cells a side, each `cell_m` metres wide.
#pragma once

#include <Eigen/Core>
#include <array>
#include <compare>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "engine/core/result.h"

namespace trocar::spatial {

/// A cell by its flat number: (x · n + y) · n + z, so z runs fastest.
struct CellIndex {
  std::int32_t value = 0;
  // clang-tidy 14 takes the 0 inside of the defaulted operator for a null pointer.
  auto operator<=>(const CellIndex&) const = default;  // NOLINT(modernize-use-nullptr)
};

/// A cell by its three coordinates, each 0 … n − 1.
struct CellCoordinates {
  int x = 0;
  int y = 0;
  int z = 0;
  bool operator==(const CellCoordinates&) const = default;
};

/// The six actions of the paper (section III.B): one cell along an axis. The order is that of every Q-table and file.
enum class Action : std::uint8_t { kPlusX, kMinusX, kPlusY, kMinusY, kPlusZ, kMinusZ };
constexpr int kActionCount = 6;
/// "+x" … "-z".
std::string_view to_string(Action action);

/// A cube of cells, at rest in the board frame W with its axes along those of W.
///
/// Frames: W is the board (origin at its centre, z up). G is the lattice; its origin Go is the corner of the cube with
/// the smallest coordinates.
struct Grid {
  Eigen::Vector3d p_WGo{-0.0375, -0.0525, 0.0025};  ///< Go from Wo, in W, in metres.
  double cell_m = 0.0025;                           ///< Width of a cell in metres; also the agent's step (Table I).
  int n = 22;                                       ///< Cells a side; 22 gives the paper's 10,648 states (Table I).

  /// The same cube divided into `cells` a side.
  static Grid with_cells(int cells);

  int cell_count() const { return n * n * n; }
  bool contains(const CellCoordinates& c) const {
    return c.x >= 0 && c.y >= 0 && c.z >= 0 && c.x < n && c.y < n && c.z < n;
  }
  /// Precondition: `contains(c)`.
  CellIndex index(const CellCoordinates& c) const { return {(c.x * n + c.y) * n + c.z}; }
  CellCoordinates coordinates(CellIndex cell) const {
    return {cell.value / (n * n), cell.value / n % n, cell.value % n};
  }
  /// The cell that holds the point Q. A point on a face belongs to the cell with the larger index.
  /// Errors: kOutOfReach if Q is outside of the cube, kInvalidArgument if it is not finite.
  Result<CellIndex> cell_at(const Eigen::Vector3d& p_WQ) const;
  /// p_WQ of the middle of the cell.
  Eigen::Vector3d centre(CellIndex cell) const;
  /// Nothing where the step would leave the lattice.
  std::optional<CellIndex> neighbour(CellIndex cell, Action action) const;
  bool operator==(const Grid&) const = default;
};

/// A set of cells of one grid, as a flag for each; also the safe set (paper, section IV.A.1).
class CellSet {
 public:
  CellSet() = default;
  explicit CellSet(const Grid& grid, bool full = false) : flags_(static_cast<std::size_t>(grid.cell_count()), full) {}
  bool contains(CellIndex cell) const { return flags_[static_cast<std::size_t>(cell.value)] != 0; }
  void insert(CellIndex cell) { flags_[static_cast<std::size_t>(cell.value)] = 1; }
  void erase(CellIndex cell) { flags_[static_cast<std::size_t>(cell.value)] = 0; }
  bool empty() const { return flags_.empty(); }
  int count() const;
  /// One byte for each cell, in the order of CellIndex.
  const std::vector<std::uint8_t>& flags() const { return flags_; }
  bool operator==(const CellSet&) const = default;

 private:
  std::vector<std::uint8_t> flags_;
};

/// The cells within Chebyshev distance `radius` of any of `cells`: the safe set for radius 4 (learning, "Safe set").
CellSet cells_within(const Grid& grid, const std::vector<CellIndex>& cells, int radius);

}  // namespace trocar::spatial
