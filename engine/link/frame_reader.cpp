#include "engine/link/frame_reader.h"

#include <fmt/format.h>

#include <cstdint>

#include "engine/core/check.h"

namespace trocar::link {

std::string with_length(std::string_view packet) {
  TROCAR_CHECK(!packet.empty() && packet.size() <= kLongestPacket);
  const auto length = static_cast<std::uint32_t>(packet.size());
  std::string framed;
  framed.reserve(kLengthBytes + packet.size());
  for (int shift = 24; shift >= 0; shift -= 8) framed.push_back(static_cast<char>((length >> shift) & 0xFFU));
  framed.append(packet);
  return framed;
}

std::optional<std::size_t> FrameReader::length_at(std::size_t place) const {
  if (bytes_.size() - place < kLengthBytes) return std::nullopt;
  std::size_t length = 0;
  for (std::size_t i = 0; i < kLengthBytes; ++i) {
    length = (length << 8) | static_cast<unsigned char>(bytes_[place + i]);
  }
  return length;
}

Status FrameReader::feed(std::string_view bytes) {
  if (broken_) return fail(ErrorCode::kCorrupt, "the stream is broken");
  bytes_.append(bytes);
  while (const auto length = length_at(checked_)) {
    if (*length == 0 || *length > kLongestPacket) {
      broken_ = true;
      bytes_.resize(checked_);
      return fail(ErrorCode::kCorrupt,
                  fmt::format("a packet of {} bytes; 1 to {} are possible", *length, kLongestPacket));
    }
    if (bytes_.size() - checked_ - kLengthBytes < *length) break;
    checked_ += kLengthBytes + *length;
  }
  return {};
}

std::optional<std::string> FrameReader::next() {
  if (begin_ == checked_) return std::nullopt;
  const std::size_t length = *length_at(begin_);
  std::string packet = bytes_.substr(begin_ + kLengthBytes, length);
  begin_ += kLengthBytes + length;
  // All whole packets are taken: what is left moves to the front, a packet's length at most.
  if (begin_ == checked_) {
    bytes_.erase(0, begin_);
    begin_ = checked_ = 0;
  }
  return packet;
}

}  // namespace trocar::link
