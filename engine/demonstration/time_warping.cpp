#include "engine/demonstration/time_warping.h"

#include <algorithm>
#include <cstdint>
#include <limits>

namespace trocar::demonstration {
namespace {

constexpr std::size_t kExact = 4'000'000;
constexpr std::size_t kCorridor = 16;

/// The elements of the second sequence that one of the first may be matched with: [begin, end).
struct Window {
  std::size_t begin = 0;
  std::size_t end = 0;
};

enum class From : std::uint8_t { kBoth, kFirst, kSecond };

/// Costs and directions within windows that neither begin nor end before those of the row above.
class Table {
 public:
  Table(const std::vector<TipPair>& first, const std::vector<TipPair>& second, std::vector<Window> windows)
      : first_(first), second_(second), windows_(std::move(windows)) {
    starts_.reserve(windows_.size());
    std::size_t size = 0;
    for (const Window& window : windows_) {
      starts_.push_back(size);
      size += window.end - window.begin;
    }
    from_.resize(size);
  }

  std::vector<WarpStep> solve() {
    std::vector<double> above;
    for (std::size_t i = 0; i < windows_.size(); ++i) above = row(i, above);
    return back();
  }

 private:
  static constexpr double kNever = std::numeric_limits<double>::infinity();

  std::vector<double> row(std::size_t i, const std::vector<double>& above) {
    const Window window = windows_[i];
    std::vector<double> costs(window.end - window.begin, kNever);
    const auto over = [&](std::size_t j) {
      return i > 0 && j >= windows_[i - 1].begin && j < windows_[i - 1].end ? above[j - windows_[i - 1].begin] : kNever;
    };
    for (std::size_t j = window.begin; j < window.end; ++j) {
      const std::size_t at = j - window.begin;
      double best = i == 0 && j == 0 ? 0.0 : kNever;
      From from = From::kBoth;
      const auto offer = [&](double cost, From way) {
        if (cost >= best) return;
        best = cost;
        from = way;
      };
      if (j > 0) offer(over(j - 1), From::kBoth);
      offer(over(j), From::kFirst);
      if (at > 0) offer(costs[at - 1], From::kSecond);
      costs[at] = best + distance(first_[i], second_[j]);
      from_[starts_[i] + at] = from;
    }
    return costs;
  }

  std::vector<WarpStep> back() const {
    std::vector<WarpStep> steps;
    std::size_t i = first_.size() - 1;
    std::size_t j = second_.size() - 1;
    for (steps.push_back({i, j}); i > 0 || j > 0; steps.push_back({i, j})) {
      const From from = from_[starts_[i] + j - windows_[i].begin];
      if (from != From::kSecond) --i;
      if (from != From::kFirst) --j;
    }
    std::reverse(steps.begin(), steps.end());
    return steps;
  }

  const std::vector<TipPair>& first_;
  const std::vector<TipPair>& second_;
  std::vector<Window> windows_;
  std::vector<std::size_t> starts_;
  std::vector<From> from_;
};

std::vector<TipPair> halved(const std::vector<TipPair>& points) {
  std::vector<TipPair> half;
  half.reserve(points.size() / 2 + 1);
  for (std::size_t i = 0; i < points.size(); i += 2) half.push_back(points[i]);
  return half;
}

/// Around a matching of every second element.
std::vector<Window> corridor(const std::vector<WarpStep>& coarse, std::size_t rows, std::size_t columns) {
  std::vector<Window> windows(rows, {columns, 0});
  for (const WarpStep& step : coarse) {
    const std::size_t low = 2 * step.second > kCorridor ? 2 * step.second - kCorridor : 0;
    const std::size_t high = std::min(2 * step.second + 2 + kCorridor, columns);
    for (std::size_t i = 2 * step.first; i < std::min(2 * step.first + 2, rows); ++i) {
      windows[i].begin = std::min(windows[i].begin, low);
      windows[i].end = std::max(windows[i].end, high);
    }
  }
  windows.back().end = columns;
  return windows;
}

}  // namespace

double distance(const TipPair& a, const TipPair& b) {
  return (a[0] - b[0]).norm() + (a[1] - b[1]).norm();
}

std::vector<WarpStep> warp(const std::vector<TipPair>& first, const std::vector<TipPair>& second) {
  if (first.empty() || second.empty()) return {};
  const bool exact = first.size() <= kExact / second.size();
  // Two sequences of very different lengths are halved until the shorter one is short.
  const bool small = first.size() < 4 || second.size() < 4;
  std::vector<Window> windows(first.size(), {0, second.size()});
  if (!exact && !small) windows = corridor(warp(halved(first), halved(second)), first.size(), second.size());
  return Table(first, second, std::move(windows)).solve();
}

}  // namespace trocar::demonstration
