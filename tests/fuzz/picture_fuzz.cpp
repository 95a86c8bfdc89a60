// PNG's outer structure from any bytes: the check must not read past the end or accept what it cannot follow.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "engine/media/png_check.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const trocar::Status status = trocar::media::check_png(bytes);
  if (status && size < 8 + 25 + 12 + 12) __builtin_trap();
  return 0;
}
