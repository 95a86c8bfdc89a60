#include "engine/demonstration/name.h"

#include <algorithm>
#include <cstdint>

namespace trocar::demonstration {
namespace {

constexpr std::size_t kLongest = 200;

/// Bytes of the character at the front, 0 if it is not well formed (Unicode 15, table 3-7).
std::size_t utf8_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<std::uint8_t>(text[i]) : 0U; };
  const auto continues = [&](std::size_t i) { return (byte(i) & 0xC0U) == 0x80U; };
  const unsigned first = byte(0);
  if (first < 0x80U) return 1;
  if (first >= 0xC2U && first <= 0xDFU) return continues(1) ? 2 : 0;
  if (first >= 0xE0U && first <= 0xEFU) {
    const bool overlong = first == 0xE0U && byte(1) < 0xA0U;
    const bool surrogate = first == 0xEDU && byte(1) > 0x9FU;
    return continues(1) && continues(2) && !overlong && !surrogate ? 3 : 0;
  }
  if (first >= 0xF0U && first <= 0xF4U) {
    const bool overlong = first == 0xF0U && byte(1) < 0x90U;
    const bool beyond = first == 0xF4U && byte(1) > 0x8FU;
    return continues(1) && continues(2) && continues(3) && !overlong && !beyond ? 4 : 0;
  }
  return 0;
}

}  // namespace

Status check_name(std::string_view name) {
  if (std::all_of(name.begin(), name.end(), [](char c) { return c == ' '; })) {
    return fail(ErrorCode::kInvalidArgument, "a name must not be empty");
  }
  if (name.size() > kLongest) return fail(ErrorCode::kInvalidArgument, "a name must not be longer than 200 bytes");
  for (std::string_view rest = name; !rest.empty();) {
    const std::size_t length = utf8_length(rest);
    const auto first = static_cast<std::uint8_t>(rest.front());
    if (length == 0) return fail(ErrorCode::kInvalidArgument, "a name must be UTF-8 text");
    if (first < 0x20U || first == 0x7FU) {
      return fail(ErrorCode::kInvalidArgument, "a name must not have control characters");
    }
    rest.remove_prefix(length);
  }
  return {};
}

}  // namespace trocar::demonstration
