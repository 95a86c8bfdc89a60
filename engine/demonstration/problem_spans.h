/// Gathers neighbouring samples with the same problem into one span, with the worst value in it.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

namespace trocar::demonstration {

/// As sentences name the tools.
constexpr std::array<const char*, 2> kTools{"left", "right"};

struct ProblemSpan {
  double begin_s = 0.0;
  double end_s = 0.0;
  double worst = 0.0;
  int count = 0;
};

class SpanCollector {
 public:
  /// Times do not decrease; what is at most 0.1 s apart belongs together.
  void add(double t_s, double value) {
    if (spans_.empty() || t_s - spans_.back().end_s > kTogether_s) spans_.push_back({t_s, t_s, value, 0});
    ProblemSpan& span = spans_.back();
    span.end_s = t_s;
    span.worst = std::max(span.worst, value);
    ++span.count;
  }
  const std::vector<ProblemSpan>& spans() const { return spans_; }

 private:
  static constexpr double kTogether_s = 0.1;
  std::vector<ProblemSpan> spans_;
};

}  // namespace trocar::demonstration
