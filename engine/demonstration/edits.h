/// Edits of one demonstration as data, and the pure function that applies them.
#pragma once

#include <string>
#include <string_view>
#include <variant>

#include "engine/demonstration/demonstration.h"

namespace trocar::demonstration {

/// Moves the gates; the recording keeps everything.
struct Trim {
  static constexpr std::string_view kName = "trim";
  double from_s = 0.0;
  double to_s = 0.0;
};

struct Rename {
  static constexpr std::string_view kName = "rename";
  std::string name;
};

/// Labels a span; what it covers of other spans is cut away, a span it splits becomes two.
struct LabelSegment {
  static constexpr std::string_view kName = "label";
  Segment label = Segment::kA;
  double from_s = 0.0;
  double to_s = 0.0;
};

using Edit = std::variant<Trim, Rename, LabelSegment>;

/// Returns the edited demonstration; `document` is untouched and what did not change is shared.
/// Errors: kInvalidArgument with what is wrong: an empty result, an end before its begin, a number that is not finite.
Result<Demonstration> apply(const Demonstration& document, const Edit& edit);

/// The edit's name and its parameters as a JSON object; the row of the journal.
std::string_view name_of(const Edit& edit);
std::string to_json(const Edit& edit);
/// Errors: kCorrupt for an unknown name, a missing or a foreign key, or a value of the wrong type.
Result<Edit> edit_from_json(std::string_view name, std::string_view json);

}  // namespace trocar::demonstration
