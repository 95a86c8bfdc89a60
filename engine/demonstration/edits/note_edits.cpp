// Words about the demonstration: AddNote, RemoveNote.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/demonstration/edits/edit_functions.h"
#include "engine/demonstration/name.h"

namespace trocar::demonstration {

Result<Demonstration> made_by(const Demonstration& document, const AddNote& edit, std::int64_t entry) {
  TROCAR_RETURN_IF_ERROR(check_name(edit.text));
  if (!edit.tag.empty()) TROCAR_RETURN_IF_ERROR(check_name(edit.tag));
  if (!std::isfinite(edit.from_s) || !std::isfinite(edit.to_s) || edit.to_s < edit.from_s) {
    return fail(ErrorCode::kInvalidArgument, "a note's end must not be before its begin");
  }
  if (edit.rating < 0 || edit.rating > 5) return fail(ErrorCode::kInvalidArgument, "a rating goes from 0 to 5");
  Demonstration edited = document;
  const Note note{entry, edit.from_s, edit.to_s, edit.text, edit.tag, edit.rating, edit.colour, edit.glyph};
  const auto place = std::upper_bound(edited.notes.begin(), edited.notes.end(), note,
                                      [](const Note& a, const Note& b) { return a.begin_s < b.begin_s; });
  edited.notes.insert(place, note);
  return edited;
}

Result<Demonstration> made_by(const Demonstration& document, const RemoveNote& edit) {
  Demonstration edited = document;
  if (std::erase_if(edited.notes, [&](const Note& note) { return note.id == edit.note; }) > 0) return edited;
  return fail(ErrorCode::kNotFound, fmt::format("there is no note {}", edit.note));
}

}  // namespace trocar::demonstration
