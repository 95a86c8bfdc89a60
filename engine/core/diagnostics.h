/// Warnings that a function adds to while it goes on: what is odd, in a list that the user sees.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace trocar {

/// A list of sentences. Threads: one at a time.
class Diagnostics {
 public:
  void warn(std::string sentence) { warnings_.push_back(std::move(sentence)); }
  const std::vector<std::string>& warnings() const { return warnings_; }

 private:
  std::vector<std::string> warnings_;
};

}  // namespace trocar
