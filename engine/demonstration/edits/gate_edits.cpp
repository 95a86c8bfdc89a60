// Gates and name: Trim, TrimIdle, Rename.
#include <fmt/format.h>

#include <algorithm>

#include "engine/demonstration/edits/edit_functions.h"
#include "engine/demonstration/edits/stretch.h"
#include "engine/demonstration/name.h"
#include "engine/demonstration/quality.h"

namespace trocar::demonstration {
namespace {

/// Idle spans that are to be cut out between the gates, margins left, the last one first.
std::vector<SegmentSpan> pauses(const Demonstration& document, const TrimIdle& edit) {
  std::vector<SegmentSpan> cuts;
  for (const IdleSpan& idle : idle_spans(document, {edit.speed_m_s, edit.longer_s, edit.keep_s, edit.window_s})) {
    const bool at_end = idle.begin_s <= document.begin_s || idle.end_s >= document.end_s;
    const SegmentSpan cut{Segment::kA, idle.begin_s + edit.keep_s, idle.end_s - edit.keep_s};
    if (!at_end && cut.begin_s < cut.end_s) cuts.insert(cuts.begin(), cut);
  }
  return cuts;
}

}  // namespace

Result<Demonstration> made_by(const Demonstration& document, const Trim& edit) {
  TROCAR_RETURN_IF_ERROR(check_range(edit.from_s, edit.to_s));
  Demonstration edited = document;
  edited.begin_s = std::max(edit.from_s, 0.0);
  edited.end_s = std::min(edit.to_s, document.full_duration_s());
  if (edited.begin_s >= edited.end_s || edited.gated().size() < 2) {
    return fail(ErrorCode::kInvalidArgument,
                fmt::format("the trim to {}–{} s leaves fewer than 2 samples", edit.from_s, edit.to_s));
  }
  return edited;
}

Result<Demonstration> made_by(const Demonstration& document, const TrimIdle& edit) {
  TROCAR_RETURN_IF_ERROR(check_positive(edit.speed_m_s, "the speed"));
  TROCAR_RETURN_IF_ERROR(check_positive(edit.longer_s, "the length of a pause"));
  if (!(edit.keep_s >= 0.0) || edit.keep_s > 1e3) {
    return fail(ErrorCode::kInvalidArgument, "what stays of a pause must be a number from 0");
  }
  if (!(edit.window_s >= 0.0) || edit.window_s > 60.0) {
    return fail(ErrorCode::kInvalidArgument, "the time over which speeds are measured must be from 0 to 60 s");
  }
  Demonstration edited = document;
  if (edit.inside) {
    for (const SegmentSpan& cut : pauses(document, edit)) {
      TROCAR_ASSIGN_OR_RETURN(edited, made_by(edited, DeleteSpan{cut.begin_s, cut.end_s, true}));
    }
  }
  bool trimmed = edited.samples.size() != document.samples.size();
  if (edit.ends) {
    const auto gates = idle_ends(edited, {edit.speed_m_s, edit.longer_s, edit.keep_s, edit.window_s});
    if (gates) {
      TROCAR_ASSIGN_OR_RETURN(edited, made_by(edited, *gates));
      trimmed = true;
    }
  }
  if (trimmed) return edited;
  return fail(ErrorCode::kInvalidArgument, "nothing is idle for long enough");
}

Result<Demonstration> made_by(const Demonstration& document, const Rename& edit) {
  TROCAR_RETURN_IF_ERROR(check_name(edit.name));
  Demonstration edited = document;
  edited.name = edit.name;
  return edited;
}

}  // namespace trocar::demonstration
