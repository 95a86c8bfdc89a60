#include "engine/workbench/path_sketch.h"

#include <algorithm>
#include <cmath>

#include "engine/demonstration/motion.h"
#include "engine/peg_board/peg_board.h"

namespace trocar::workbench {
namespace {

constexpr std::size_t kMostPoints = 48;
/// What the picture shows of the board: all pegs, and a margin.
constexpr double kWidth_m = 0.105;
constexpr double kHeight_m = kWidth_m / static_cast<double>(kSketchAspect);

SketchPoint placed(const Eigen::Vector3d& p_W) {
  return {static_cast<float>(std::clamp(p_W.y() / kWidth_m + 0.5, 0.0, 1.0)),
          static_cast<float>(std::clamp(p_W.x() / kHeight_m + 0.5, 0.0, 1.0)),
          {}};
}

std::optional<demonstration::Segment> segment_at(const demonstration::Demonstration& document, double t_s) {
  for (const demonstration::SegmentSpan& span : document.segments) {
    if (t_s >= span.begin_s && t_s < span.end_s) return span.label;
  }
  return std::nullopt;
}

}  // namespace

PathSketch path_sketch(const demonstration::Demonstration& document) {
  const demonstration::SampleTrack samples = document.gated();
  PathSketch sketch;
  const std::size_t count = std::min(samples.size(), kMostPoints);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t index = count == 1 ? 0 : i * (samples.size() - 1) / (count - 1);
    const demonstration::Sample sample = samples[index];
    const auto segment = segment_at(document, document.time_of(sample));
    for (std::size_t arm = 0; arm < 2; ++arm) {
      const Eigen::Vector3d p_WT = demonstration::measured_tip(sample, arm);
      if (!p_WT.allFinite()) continue;
      SketchPoint point = placed(p_WT);
      point.segment = segment;
      sketch.arms[arm].push_back(point);
    }
  }
  return sketch;
}

std::span<const SketchPoint> sketch_pegs() {
  static const std::array<SketchPoint, peg_board::kPegCount> kPegs = [] {
    std::array<SketchPoint, peg_board::kPegCount> pegs;
    for (std::size_t i = 0; i < pegs.size(); ++i) {
      const int peg = static_cast<int>(i) % peg_board::kBlockCount;
      pegs[i] = placed(i < pegs.size() / 2 ? peg_board::start_peg(peg) : peg_board::goal_peg(peg));
    }
    return pegs;
  }();
  return kPegs;
}

}  // namespace trocar::workbench
