// The stream of the TCP link: the same packets come out however it is cut, no more bytes than went in, nothing after a
// wrong length; and a message that is taken is the same when it is written and read again, with poses that are some.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "engine/link/frame_reader.h"
#include "engine/link/hand_inbox.h"
#include "engine/link/messages.h"

namespace {

using namespace trocar;

std::vector<std::string> packets(std::string_view bytes, std::size_t piece) {
  link::FrameReader reader;
  std::vector<std::string> found;
  bool broken = false;
  for (std::size_t begin = 0; begin < bytes.size(); begin += piece) {
    const bool fed = reader.feed(bytes.substr(begin, piece)).has_value();
    if (broken && fed) __builtin_trap();
    broken = broken || !fed;
    while (auto packet = reader.next()) {
      if (packet->empty() || packet->size() > link::kLongestPacket) __builtin_trap();
      found.push_back(std::move(*packet));
    }
    if (reader.waiting() > bytes.size()) __builtin_trap();
    if (!broken && reader.waiting() >= link::kLongestPacket + link::kLengthBytes) __builtin_trap();
  }
  return found;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const std::vector<std::string> whole = packets(bytes, std::max<std::size_t>(size, 1));
  if (packets(bytes, 1) != whole || packets(bytes, 5) != whole) __builtin_trap();
  std::size_t total = 0;
  link::HandInbox inbox;
  std::uint32_t connection = 1;
  for (const std::string& packet : whole) {
    total += link::kLengthBytes + packet.size();
    const auto message = link::decode(packet);
    if (!message) continue;
    if (const auto* frame = std::get_if<link::HandFrame>(&*message)) {
      if (!frame->left.X_DH.finite() || !frame->right.X_DH.finite()) __builtin_trap();
      const auto again = link::decode(std::string_view(link::encode(*frame)).substr(link::kLengthBytes));
      if (!again || !(std::get<link::HandFrame>(*again) == *frame)) __builtin_trap();
      inbox.put({*frame, 0, connection});
      static_cast<void>(inbox.take_pedal());
    } else {
      ++connection;
    }
  }
  while (inbox.take()) {
  }
  if (total > size) __builtin_trap();
  return 0;
}
