// JIGSAWS kinematics and transcription from any bytes, parted by the first zero byte: what is accepted must make a
// demonstration that takes every note.
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string_view>

#include "engine/demonstration/edits.h"
#include "engine/exchange/jigsaws.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace trocar;
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const std::size_t zero = bytes.find('\0');
  const std::string_view transcription = zero == std::string_view::npos ? "" : bytes.substr(zero + 1);
  auto read = exchange::from_jigsaws(bytes.substr(0, zero), transcription);
  if (!read) return 0;
  const auto recording = std::make_shared<const demonstration::Recording>(std::move(read->recording));
  auto document = demonstration::make_demonstration({1}, "Imported", recording);
  if (!document) __builtin_trap();
  for (const demonstration::AddNote& note : read->notes) {
    document = demonstration::apply(*document, note, 1);
    if (!document) __builtin_trap();
  }
  return 0;
}
