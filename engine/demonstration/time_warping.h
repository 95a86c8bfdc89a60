/// Dynamic time warping: the matching of two sequences that goes forward in both and has the least sum of distances.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <vector>

namespace trocar::demonstration {

/// Both tips at one instant, W, metres.
using TipPair = std::array<Eigen::Vector3d, 2>;
/// The sum of the distances of the left and of the right tips.
double distance(const TipPair& a, const TipPair& b);

/// An element of the first sequence and one of the second.
struct WarpStep {
  std::size_t first = 0;
  std::size_t second = 0;
  bool operator==(const WarpStep&) const = default;
};

/// From the first elements of both to the last of both; each step advances one or both by one. Exact where the product
/// of the lengths is at most four million. Beyond, every second element is matched first, and the whole within a
/// corridor of 16 elements around that: its sum is at least that of the best matching. Empty if a sequence is.
/// Time and memory: by the sum of the lengths.
std::vector<WarpStep> warp(const std::vector<TipPair>& first, const std::vector<TipPair>& second);

}  // namespace trocar::demonstration
