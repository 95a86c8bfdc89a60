// Edits of project and demonstration from any bytes, the name before the first line end: what is accepted must be
// written as something that reads back the same.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "engine/workbench/edit.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace trocar;
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const std::size_t end = bytes.find('\n');
  if (end == std::string_view::npos) return 0;
  const std::string_view name = bytes.substr(0, end);
  const std::string_view json = bytes.substr(end + 1);
  if (const auto edit = workbench::edit_from_json(name, json)) {
    const std::string text = workbench::to_json(*edit);
    const auto again = workbench::edit_from_json(name, text);
    if (!again || workbench::to_json(*again) != text) __builtin_trap();
  }
  if (const auto edit = demonstration::edit_from_json(name, json)) {
    const std::string text = demonstration::to_json(*edit);
    const auto again = demonstration::edit_from_json(name, text);
    if (!again || demonstration::to_json(*again) != text) __builtin_trap();
  }
  return 0;
}
