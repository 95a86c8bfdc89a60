/// What a person may have meant by a word that nothing is called by.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace trocar::app {

/// Something that there is: what would have been understood, and how to show it.
struct Known {
  std::string name;
  std::string shown;  ///< Empty: the name.
};

/// The end of an error's sentence: "; did you mean X or Y?" where something is alike but for case, spaces, signs, a
/// missing end or a slip of the fingers; else "; there are X, Y and Z"; else "; there is none".
std::string suggestion(std::string_view wrong, const std::vector<Known>& known);

/// Only the first of these; empty if nothing is alike.
std::string did_you_mean(std::string_view wrong, const std::vector<Known>& known);

/// "; there are X, Y and Z", the first of them where they are many.
std::string there_are(const std::vector<Known>& known);

}  // namespace trocar::app
