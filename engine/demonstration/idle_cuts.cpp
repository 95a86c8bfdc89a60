#include "engine/demonstration/idle_cuts.h"

#include <algorithm>
#include <cmath>

#include "engine/demonstration/edits/stretch.h"
#include "engine/demonstration/quality.h"

namespace trocar::demonstration {
namespace {

/// What stays of each stretch, in seconds.
double margin_s(const Demonstration& document, const TrimIdle& edit) {
  if (edit.keep_samples == 0) return edit.keep_s;
  const auto steps = static_cast<double>(std::max<std::size_t>(document.gated().size(), 2) - 1);
  return edit.keep_samples * document.duration_s() / steps;
}

Status check_idle(const TrimIdle& edit) {
  TROCAR_RETURN_IF_ERROR(check_positive(edit.speed_m_s, "the speed"));
  TROCAR_RETURN_IF_ERROR(check_positive(edit.longer_s, "the length of a pause"));
  if (!(edit.keep_s >= 0.0) || edit.keep_s > 1e3 || edit.keep_samples < 0 || edit.keep_samples > 1'000'000) {
    return fail(ErrorCode::kInvalidArgument, "what stays of a pause must be a number from 0");
  }
  if (!(edit.window_s >= 0.0) || edit.window_s > 60.0) {
    return fail(ErrorCode::kInvalidArgument, "the time over which speeds are measured must be from 0 to 60 s");
  }
  if (std::all_of(edit.stay_s.begin(), edit.stay_s.end(), [](double t_s) { return std::isfinite(t_s); })) return {};
  return fail(ErrorCode::kInvalidArgument, "the times of what stays must be finite numbers");
}

}  // namespace

Result<std::vector<IdleCut>> idle_cuts(const Demonstration& document, const TrimIdle& edit) {
  TROCAR_RETURN_IF_ERROR(check_idle(edit));
  const double keep_s = margin_s(document, edit);
  // What moves first and last tells where the gates go, as for all that trims ends.
  const Trim gates = idle_ends(document, {edit.speed_m_s, edit.longer_s, keep_s, edit.window_s})
                         .value_or(Trim{document.begin_s, document.end_s});
  std::vector<IdleCut> cuts;
  for (const IdleSpan& idle : idle_spans(document, {edit.speed_m_s, edit.longer_s, keep_s, edit.window_s})) {
    const bool first = idle.begin_s <= document.begin_s;
    const bool last = idle.end_s >= document.end_s;
    if ((first && last) || !((first || last) ? edit.ends : edit.inside)) continue;
    IdleCut cut{idle.begin_s, idle.end_s, idle.begin_s + keep_s, idle.end_s - keep_s};
    if (first) cut = {idle.begin_s, idle.end_s, document.begin_s, gates.from_s};
    if (last) cut = {idle.begin_s, idle.end_s, gates.to_s, document.end_s};
    cut.at_end = first || last;
    cut.stays = std::any_of(edit.stay_s.begin(), edit.stay_s.end(),
                            [&](double t_s) { return t_s >= idle.begin_s && t_s <= idle.end_s; });
    if (cut.from_s < cut.to_s) cuts.push_back(cut);
  }
  return cuts;
}

}  // namespace trocar::demonstration
