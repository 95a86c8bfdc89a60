#include "engine/demonstration/edits.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/demonstration/name.h"

namespace trocar::demonstration {
namespace {

Status check_range(double from_s, double to_s) {
  if (!std::isfinite(from_s) || !std::isfinite(to_s)) {
    return fail(ErrorCode::kInvalidArgument, "the begin and the end must be finite numbers");
  }
  if (to_s <= from_s) {
    return fail(ErrorCode::kInvalidArgument,
                fmt::format("the end ({} s) must be after the begin ({} s)", to_s, from_s));
  }
  return {};
}

Result<Demonstration> apply_one(const Demonstration& document, const Trim& trim) {
  TROCAR_RETURN_IF_ERROR(check_range(trim.from_s, trim.to_s));
  Demonstration edited = document;
  edited.begin_s = std::max(trim.from_s, 0.0);
  edited.end_s = std::min(trim.to_s, document.full_duration_s());
  if (edited.begin_s >= edited.end_s || edited.gated().size() < 2) {
    return fail(ErrorCode::kInvalidArgument,
                fmt::format("the trim to {}–{} s leaves fewer than 2 samples", trim.from_s, trim.to_s));
  }
  return edited;
}

Result<Demonstration> apply_one(const Demonstration& document, const Rename& rename) {
  TROCAR_RETURN_IF_ERROR(check_name(rename.name));
  Demonstration edited = document;
  edited.name = rename.name;
  return edited;
}

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

Result<Demonstration> apply_one(const Demonstration& document, const LabelSegment& label) {
  TROCAR_RETURN_IF_ERROR(check_range(label.from_s, label.to_s));
  const SegmentSpan added{label.label, std::max(label.from_s, 0.0), std::min(label.to_s, document.full_duration_s())};
  if (added.begin_s >= added.end_s) {
    return fail(ErrorCode::kInvalidArgument,
                fmt::format("the label at {}–{} s lies outside of the demonstration", label.from_s, label.to_s));
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

}  // namespace

Result<Demonstration> apply(const Demonstration& document, const Edit& edit) {
  return std::visit([&](const auto& one) { return apply_one(document, one); }, edit);
}

std::string_view name_of(const Edit& edit) {
  return std::visit([](const auto& one) { return one.kName; }, edit);
}

}  // namespace trocar::demonstration
