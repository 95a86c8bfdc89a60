// Gates and name: Trim, TrimIdle, Rename.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "engine/demonstration/edits.h"
#include "engine/demonstration/edits/edit_functions.h"
#include "engine/demonstration/edits/stretch.h"
#include "engine/demonstration/idle_cuts.h"
#include "engine/demonstration/name.h"

namespace trocar::demonstration {

Result<Trim> kept_trim(const Demonstration& document, const Trim& asked) {
  TROCAR_RETURN_IF_ERROR(check_range(asked.from_s, asked.to_s));
  const Trim kept{std::max(asked.from_s, 0.0), std::min(asked.to_s, document.full_duration_s())};
  const bool new_begin = std::abs(kept.from_s - document.begin_s) > kTimeTolerance_s;
  const bool new_end = std::abs(kept.to_s - document.end_s) > kTimeTolerance_s;
  if (new_begin || new_end) return kept;
  return fail(ErrorCode::kInvalidArgument,
              fmt::format("{} is trimmed to {:.2f}–{:.2f} s already", document.name, kept.from_s, kept.to_s));
}

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
  TROCAR_ASSIGN_OR_RETURN(const std::vector<IdleCut> cuts, idle_cuts(document, edit));
  Demonstration edited = document;
  std::optional<double> begin_s;
  std::optional<double> end_s;
  for (auto cut = cuts.rbegin(); cut != cuts.rend(); ++cut) {
    if (cut->stays) continue;
    if (!cut->at_end) {
      TROCAR_ASSIGN_OR_RETURN(edited, made_by(edited, DeleteSpan{cut->from_s, cut->to_s, true}));
    } else if (cut->from_s <= document.begin_s) {
      begin_s = cut->to_s;
    } else {
      end_s = cut->from_s;
    }
  }
  const double gone_s = document.full_duration_s() - edited.full_duration_s();
  if (begin_s || end_s) {
    return made_by(edited, Trim{begin_s.value_or(edited.begin_s), end_s ? *end_s - gone_s : edited.end_s});
  }
  if (gone_s > 0.0) return edited;
  return fail(ErrorCode::kInvalidArgument,
              cuts.empty() ? "nothing is idle for long enough" : "all that is idle is to stay");
}

Result<Demonstration> made_by(const Demonstration& document, const Rename& edit) {
  TROCAR_RETURN_IF_ERROR(check_name(edit.name));
  Demonstration edited = document;
  edited.name = edit.name;
  return edited;
}

}  // namespace trocar::demonstration
