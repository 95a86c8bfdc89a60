/// What a person would stumble over in the list of widgets: no name, two of one name, cut off, one on another, too
/// small.
#pragma once

#include <string>
#include <vector>

#include "ui/widgets/item_log.h"

namespace trocar::ui {

struct LintFinding {
  std::string path;
  std::string what;  ///< "has no name", "is cut off" …
};

/// `scale`: 1 is 100 %. Empty if all is well.
std::vector<LintFinding> lint(const std::vector<Item>& items, float scale);

}  // namespace trocar::ui
