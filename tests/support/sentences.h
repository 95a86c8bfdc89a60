/// What tests ask of lists of sentences.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace trocar::testing {

/// True if one of them has these words in it.
inline bool mentions(const std::vector<std::string>& sentences, std::string_view words) {
  return std::any_of(sentences.begin(), sentences.end(),
                     [&](const std::string& sentence) { return sentence.find(words) != std::string::npos; });
}

}  // namespace trocar::testing
