#include "engine/workbench/saved_filters.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/workbench/library_query.h"

namespace trocar::workbench {

Result<std::shared_ptr<const LibraryView>> whole_library(const LibraryRequest& request, bool measured,
                                                         Progress& progress) {
  LibraryMaker maker;
  auto view = maker.make(request, 0);
  while (measured && view->unmeasured > 0) {
    if (progress.cancelled()) return fail(ErrorCode::kCancelled, "stopped by the user");
    view = maker.make(request, kLibraryPiece_samples);
    progress.set(1.0 - static_cast<double>(view->unmeasured) / static_cast<double>(view->rows.size()));
  }
  return view;
}

Result<std::map<std::string, std::vector<std::size_t>>> filter_keys(
    const LibraryRequest& request, const std::vector<std::shared_ptr<const demonstration::Demonstration>>& chosen,
    Progress& progress, Diagnostics& diagnostics) {
  std::map<std::string, LibraryQuery> queries;
  bool measured = false;
  for (const auto& [name, text] : request.project->filters) {
    Result<LibraryQuery> query = LibraryQuery::parse(text);
    if (!query) {
      diagnostics.warn(fmt::format("the filter {} is left out: {}", name, query.error().text()));
      continue;
    }
    std::string key = name;
    std::replace(key.begin(), key.end(), '/', '_');
    measured = measured || query->measured();
    queries[key] = std::move(*query);
  }
  std::map<std::string, std::vector<std::size_t>> keys;
  if (queries.empty()) return keys;
  TROCAR_ASSIGN_OR_RETURN(const auto view, whole_library(request, measured, progress));
  for (const auto& [key, query] : queries) {
    std::size_t undecided = 0;
    for (const LibraryRow* row : matching(*view, query, undecided)) {
      const auto place =
          std::find_if(chosen.begin(), chosen.end(), [&](const auto& each) { return each->id == row->id; });
      if (place != chosen.end()) keys[key].push_back(static_cast<std::size_t>(place - chosen.begin()));
    }
  }
  return keys;
}

}  // namespace trocar::workbench
