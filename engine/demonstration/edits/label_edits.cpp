// Segments A to E: LabelSegment, ProposeLabels.
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "engine/demonstration/edits/edit_functions.h"
#include "engine/demonstration/edits/stretch.h"
#include "engine/demonstration/motion.h"

namespace trocar::demonstration {
namespace {

/// The agent has arrived (end of A) when the tool is this near to the block's middle, seen from above.
constexpr double kNear_m = 0.012;
/// A lifted block stands this much higher than it lay.
constexpr double kLifted_m = 0.004;
/// The hand-over begins (end of C) when the other tool is this near to the block.
constexpr double kOffered_m = 0.020;

/// Touching spans of one label are one span.
std::vector<SegmentSpan> merged(std::vector<SegmentSpan> spans) {
  std::sort(spans.begin(), spans.end(),
            [](const SegmentSpan& a, const SegmentSpan& b) { return a.begin_s < b.begin_s; });
  std::vector<SegmentSpan> result;
  for (const SegmentSpan& span : spans) {
    if (!result.empty() && result.back().label == span.label && result.back().end_s >= span.begin_s) {
      result.back().end_s = std::max(result.back().end_s, span.end_s);
    } else {
      result.push_back(span);
    }
  }
  return result;
}

/// When each segment ends, as far as it can be told; A … D.
class BoundaryFinder {
 public:
  explicit BoundaryFinder(const Demonstration& document) : block_(static_cast<std::size_t>(document.block)) {}

  void take(const Sample& sample, double t_s) {
    const spatial::Pose X_WK = sample.blocks[block_].pose();
    if (!rest_z_m_) rest_z_m_ = X_WK.p.z();
    const bool left = (sample.flags & kLeftHolds) != 0;
    const bool right = (sample.flags & kRightHolds) != 0;
    const Eigen::Vector3d from_left = measured_tip(sample, 0) - X_WK.p;
    switch (ends_s_.size()) {
      case 0:
        if (left || from_left.head<2>().norm() < kNear_m) ends_s_.push_back(t_s);
        break;
      case 1:
        if (left && X_WK.p.z() > *rest_z_m_ + kLifted_m) ends_s_.push_back(t_s);
        break;
      case 2:
        if (right || (measured_tip(sample, 1) - X_WK.p).norm() < kOffered_m) ends_s_.push_back(t_s);
        break;
      case 3:
        if (right && !left) ends_s_.push_back(t_s);
        break;
      default:
        break;
    }
  }
  const std::vector<double>& ends_s() const { return ends_s_; }

 private:
  std::size_t block_;
  std::optional<double> rest_z_m_;
  std::vector<double> ends_s_;
};

}  // namespace

Result<Demonstration> made_by(const Demonstration& document, const LabelSegment& edit) {
  TROCAR_RETURN_IF_ERROR(check_range(edit.from_s, edit.to_s));
  const SegmentSpan added{edit.label, std::max(edit.from_s, 0.0), std::min(edit.to_s, document.full_duration_s())};
  if (added.begin_s >= added.end_s) {
    return fail(ErrorCode::kInvalidArgument,
                fmt::format("the label at {}–{} s lies outside of the demonstration", edit.from_s, edit.to_s));
  }
  std::vector<SegmentSpan> spans{added};
  for (const SegmentSpan& span : document.segments) {
    const SegmentSpan left{span.label, span.begin_s, std::min(span.end_s, added.begin_s)};
    const SegmentSpan right{span.label, std::max(span.begin_s, added.end_s), span.end_s};
    if (left.begin_s < left.end_s) spans.push_back(left);
    if (right.begin_s < right.end_s) spans.push_back(right);
  }
  Demonstration edited = document;
  edited.segments = merged(std::move(spans));
  return edited;
}

Result<Demonstration> made_by(const Demonstration& document, const ProposeLabels& /*edit*/) {
  if (document.block < 0 || document.block >= peg_board::kBlockCount) {
    return fail(ErrorCode::kInvalidArgument, "it is not known which block was to be carried");
  }
  BoundaryFinder finder(document);
  for (const Sample& sample : document.gated()) finder.take(sample, document.time_of(sample));
  if (finder.ends_s().size() < 2) {
    return fail(ErrorCode::kInvalidArgument, "no grasp was recorded from which the segments could be told");
  }
  Demonstration edited = document;
  edited.segments.clear();
  double begin_s = document.begin_s;
  for (std::size_t i = 0; i <= finder.ends_s().size(); ++i) {
    const double end_s = i < finder.ends_s().size() ? finder.ends_s()[i] : document.end_s;
    if (end_s > begin_s) edited.segments.push_back({static_cast<Segment>(i), begin_s, end_s});
    begin_s = end_s;
  }
  return edited;
}

Demonstration with_recorded_labels(const Demonstration& document, double from_s, double to_s) {
  std::vector<SegmentSpan> spans;
  const auto add = [&](const SegmentSpan& span, double low_s, double high_s) {
    const SegmentSpan part{span.label, std::max(span.begin_s, low_s), std::min(span.end_s, high_s)};
    if (part.begin_s < part.end_s) spans.push_back(part);
  };
  constexpr double kFar_s = std::numeric_limits<double>::infinity();
  for (const SegmentSpan& span : document.segments) {
    add(span, -kFar_s, from_s);
    add(span, to_s, kFar_s);
  }
  for (const SegmentSpan& span : original_of(document).segments) add(span, from_s, to_s);
  Demonstration edited = document;
  edited.segments = merged(std::move(spans));
  return edited;
}

}  // namespace trocar::demonstration
