#include "engine/spatial/cell_text.h"

#include <fmt/format.h>

#include <array>
#include <charconv>

namespace trocar::spatial {

Result<CellCoordinates> coordinates_from(std::string_view text) {
  std::array<int, 3> numbers{};
  const char* at = text.data();
  const char* const end = text.data() + text.size();
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const auto [after, error] = std::from_chars(at, end, numbers[i]);
    const bool last = i + 1 == numbers.size();
    if (error != std::errc{} || (last ? after != end : after == end || *after != ',')) {
      return fail(ErrorCode::kInvalidArgument, fmt::format("\"{}\" is no cell; write I,J,K", text));
    }
    at = after + 1;
  }
  return CellCoordinates{numbers[0], numbers[1], numbers[2]};
}

}  // namespace trocar::spatial
