/// Edits as a person types them: "smooth --from 1.2 --to 3.4 --max-deviation-mm 0.5".
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "engine/demonstration/edit.h"

namespace trocar::demonstration {

/// How a parameter is typed: seconds bare, lengths in millimetres, angles in degrees.
struct TypedField {
  std::string option;   ///< "max-deviation-mm", without dashes.
  double factor = 1.0;  ///< What is typed is the SI value times this.
  std::string unit;     ///< "mm", to show behind the number.
};
/// From a key with its SI unit: "max_deviation_m".
TypedField typed(std::string_view key);

/// As it is typed: nine decimals, or fifteen digits of what is large. What is read back is written the same again.
std::string typed_number(double value);

/// The words after `trocar demo edit PROJECT DEMO`; every parameter is there. Read back, they give `as_typed` of it.
std::vector<std::string> to_words(const Edit& edit);

/// Options may stand in any order; what is left out keeps its default. Values that are lists are separated by commas.
/// Errors: kInvalidArgument naming an unknown edit or option, a doubled option, or a value of the wrong kind.
Result<Edit> edit_from_words(const std::vector<std::string>& words);
/// The same where what is left out is as in `present`, positional words too. Errors also: kInvalidArgument if the words
/// name another kind of edit.
Result<Edit> edit_from_words(const std::vector<std::string>& words, const Edit& present);

/// The edit with its numbers as its words say them (nine decimals of a millimetre, a degree or a second), so that what
/// is done with the mouse is to the bit what the command does that says it.
Edit as_typed(const Edit& edit);

/// One parameter as a form shows it.
struct EditOption {
  std::string option;  ///< "max-deviation-mm"
  std::string label;   ///< "Max deviation"
  std::string unit;    ///< "mm", or "".
  std::string help;
  bool positional = false;
  bool flag = false;                 ///< The text is "yes" or "no".
  std::vector<std::string> choices;  ///< The text is one of them; empty: anything.
  std::string text;
  bool number = false;  ///< The text is one number.
};
std::vector<EditOption> options_of(const Edit& edit);
/// Errors: as `edit_from_words`.
Result<Edit> edit_from_options(std::string_view name, const std::vector<EditOption>& options);
/// An edit of every kind, its parameters as they are before anybody says otherwise; in the order of the variant.
std::vector<Edit> default_edits();
/// "Propose labels" of "propose-labels".
std::string title_of(std::string_view word);

/// Words separated by blanks; a word in single quotes may hold blanks. Errors: kInvalidArgument for an open quote.
Result<std::vector<std::string>> split_words(std::string_view line);

}  // namespace trocar::demonstration
