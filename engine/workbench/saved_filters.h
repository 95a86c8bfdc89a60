/// The library worked out at once, and what a project's saved filters choose of it.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "engine/core/diagnostics.h"
#include "engine/core/progress.h"
#include "engine/workbench/library.h"

namespace trocar::workbench {

/// All rows, with their measures if `measured`. Precondition: `request` has a project. Errors: kCancelled.
Result<std::shared_ptr<const LibraryView>> whole_library(const LibraryRequest& request, bool measured,
                                                         Progress& progress);

/// By the name of each saved filter, with "/" as "_" so that it can be a filter key of robomimic, the places in
/// `chosen` of those that answer it; none of a filter that chooses nothing. A filter that cannot be read is left out
/// with a warning. Errors: kCancelled.
Result<std::map<std::string, std::vector<std::size_t>>> filter_keys(
    const LibraryRequest& request, const std::vector<std::shared_ptr<const demonstration::Demonstration>>& chosen,
    Progress& progress, Diagnostics& diagnostics);

}  // namespace trocar::workbench
