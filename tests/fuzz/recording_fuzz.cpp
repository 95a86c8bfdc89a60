// The parts of a stored recording from any bytes; the first byte chooses header, footer or chunk.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "engine/workbench/recording_codec.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace trocar;
  if (size == 0) return 0;
  const std::string_view bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
  if (data[0] == 'h') {
    const auto header = workbench::header_from_json(bytes);
    if (header && !workbench::header_from_json(workbench::header_to_json(*header))) __builtin_trap();
  } else if (data[0] == 'f') {
    const auto footer = workbench::footer_from_json(bytes);
    if (footer && !workbench::footer_from_json(workbench::footer_to_json(*footer))) __builtin_trap();
  } else {
    demonstration::Recording recording;
    const Status decoded = workbench::decode_chunk(bytes, recording);
    if (decoded && workbench::encode_chunk(recording.samples, recording.hashes) != bytes) __builtin_trap();
    (void)demonstration::check_samples(recording.samples);
  }
  return 0;
}
