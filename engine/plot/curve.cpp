#include "engine/plot/curve.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "engine/core/check.h"

namespace trocar::plot {
namespace {

constexpr std::size_t kBlock = 64;

std::size_t lower(const std::vector<double>& x, double at) {
  return static_cast<std::size_t>(std::lower_bound(x.begin(), x.end(), at) - x.begin());
}

std::size_t upper(const std::vector<double>& x, double at) {
  return static_cast<std::size_t>(std::upper_bound(x.begin(), x.end(), at) - x.begin());
}

}  // namespace

/// Draws from sample to sample, and lifts at a gap.
class Curve::Pen {
 public:
  void to(CurvePoint point) {
    if (up_) lines_.emplace_back();
    up_ = false;
    lines_.back().push_back(point);
  }
  void lift() { up_ = true; }
  std::vector<std::vector<CurvePoint>> take() { return std::move(lines_); }

 private:
  std::vector<std::vector<CurvePoint>> lines_;
  bool up_ = true;
};

Curve::Curve(std::vector<double> x, std::vector<double> y) : x_(std::move(x)), y_(std::move(y)) {
  TROCAR_CHECK(x_.size() == y_.size());
  blocks_.reserve(x_.size() / kBlock);
  for (std::size_t first = 0; first + kBlock <= x_.size(); first += kBlock) {
    Summary block{!std::isfinite(y_[first]), first, first};
    for (std::size_t i = first + 1; i < first + kBlock; ++i) widen(block, i);
    blocks_.push_back(block);
  }
}

// A sample that is not finite is the lowest and the highest of none.
void Curve::widen(Summary& summary, std::size_t index) const {
  if (!std::isfinite(y_[index])) {
    summary.gap = true;
    return;
  }
  if (!std::isfinite(y_[summary.low]) || y_[index] < y_[summary.low]) summary.low = index;
  if (!std::isfinite(y_[summary.high]) || y_[index] > y_[summary.high]) summary.high = index;
}

Curve::Summary Curve::summary(std::size_t first, std::size_t end) const {
  Summary all{!std::isfinite(y_[first]), first, first};
  for (std::size_t i = first + 1; i < end;) {
    if (i % kBlock != 0 || i + kBlock > end) {
      widen(all, i++);
      continue;
    }
    const Summary& block = blocks_[i / kBlock];
    widen(all, block.low);
    widen(all, block.high);
    all.gap = all.gap || block.gap;
    i += kBlock;
  }
  return all;
}

std::optional<Extent> Curve::extent(double begin, double end) const {
  const std::size_t first = lower(x_, begin);
  const std::size_t last = upper(x_, end);
  if (first >= last) return std::nullopt;
  const Summary all = summary(first, last);
  if (!std::isfinite(y_[all.low])) return std::nullopt;
  return Extent{y_[all.low], y_[all.high]};
}

std::optional<double> Curve::value_at(double x) const {
  if (x_.empty() || !(x >= x_.front()) || !(x <= x_.back())) return std::nullopt;
  const std::size_t after = lower(x_, x);
  if (x_[after] == x) return std::isfinite(y_[after]) ? std::optional(y_[after]) : std::nullopt;
  const std::size_t before = after - 1;
  if (!std::isfinite(y_[before]) || !std::isfinite(y_[after])) return std::nullopt;
  const double share = (x - x_[before]) / (x_[after] - x_[before]);
  return y_[before] + share * (y_[after] - y_[before]);
}

void Curve::draw(std::size_t first, std::size_t end, Pen& pen) const {
  if (end - first <= 4) {
    for (std::size_t i = first; i < end; ++i) {
      std::isfinite(y_[i]) ? pen.to({x_[i], y_[i]}) : pen.lift();
    }
    return;
  }
  const Summary all = summary(first, end);
  if (all.gap) {
    // Halves until the gap is among four: what lies around it keeps its extremes.
    const std::size_t middle = first + (end - first) / 2;
    draw(first, middle, pen);
    draw(middle, end, pen);
    return;
  }
  const std::array<std::size_t, 4> kept{first, std::min(all.low, all.high), std::max(all.low, all.high), end - 1};
  for (std::size_t i = 0; i < kept.size(); ++i) {
    if (i == 0 || kept[i] != kept[i - 1]) pen.to({x_[kept[i]], y_[kept[i]]});
  }
}

std::vector<std::vector<CurvePoint>> Curve::lines(double begin, double end, int columns) const {
  TROCAR_CHECK(begin < end && columns > 0);
  Pen pen;
  std::size_t at = lower(x_, begin);
  const std::size_t last = upper(x_, end);
  if (at > 0) draw(at - 1, at, pen);
  for (int column = 1; column <= columns && at < last; ++column) {
    const double edge = begin + (end - begin) * column / columns;
    const std::size_t next = column == columns ? last : std::min(lower(x_, edge), last);
    if (next > at) draw(at, next, pen);
    at = next;
  }
  if (last < x_.size()) draw(last, last + 1, pen);
  return pen.take();
}

}  // namespace trocar::plot
