/// A stream of bytes cut into packets: each has its length in front of it, four bytes, big end first.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "engine/core/result.h"

namespace trocar::link {

constexpr std::size_t kLongestPacket = 4096;
constexpr std::size_t kLengthBytes = 4;

/// Precondition: 1 … `kLongestPacket` bytes.
std::string with_length(std::string_view packet);

/// Takes bytes in pieces of any size. Never holds more than it was given and looks at no byte beyond that; a length
/// that cannot be is refused as soon as it is seen. Threads: one at a time.
class FrameReader {
 public:
  /// Errors: kCorrupt for a length of 0 or more than `kLongestPacket`, at once where it comes and for ever after: what
  /// follows a wrong length has no meaning. Packets before it can still be taken.
  Status feed(std::string_view bytes);
  /// The next whole packet without its length; nothing if there is none yet.
  std::optional<std::string> next();
  /// Bytes that no packet is made of yet.
  std::size_t waiting() const { return bytes_.size() - begin_; }
  bool broken() const { return broken_; }

 private:
  std::optional<std::size_t> length_at(std::size_t place) const;

  std::string bytes_;
  std::size_t begin_ = 0;    ///< Of what was not taken.
  std::size_t checked_ = 0;  ///< Up to here the lengths are good, and packets whole.
  bool broken_ = false;
};

}  // namespace trocar::link
