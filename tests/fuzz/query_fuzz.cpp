// Queries of the library from any bytes: what is accepted answers any row, and its terms, joined again, ask the same.
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "engine/workbench/library_query.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace trocar::workbench;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const auto query = LibraryQuery::parse(text);
  if (!query) return 0;
  LibraryRow row;
  row.name = "Expert 1";
  row.segments = "AC";
  row.marks.tags = {"slow"};
  const auto answer = (*query)(row);
  std::string joined;
  for (const std::string& term : query->terms()) joined += (joined.empty() ? "" : " and ") + term;
  const auto again = LibraryQuery::parse(joined);
  // Joined, they may have become longer than a query may be.
  if (!again && joined.size() <= 2000) __builtin_trap();
  if (again && (*again)(row) != answer) __builtin_trap();
  return 0;
}
