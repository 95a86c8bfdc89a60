// A trained model from any bytes: what is accepted must be written again as a model with the same hash.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "engine/learning/model_codec.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace trocar::learning;
  const auto model = decode_model({reinterpret_cast<const char*>(data), size});
  if (!model) return 0;
  const auto again = decode_model(encode_model(*model));
  if (!again || again->hash() != model->hash()) __builtin_trap();
  return 0;
}
