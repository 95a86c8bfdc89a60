#include "engine/exchange/tree_stream.h"

#include <sys/socket.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

namespace trocar::exchange {
namespace {

/// Longer than any node that the HDF5 process may send.
constexpr std::uint64_t kLongest = std::uint64_t{3} << 30;
/// What is allocated ahead of what has come: a length alone costs nothing.
constexpr std::size_t kStep = std::size_t{16} << 20;

Status send_all(int socket, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t n = ::send(socket, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return fail(ErrorCode::kIo, "the HDF5 process is gone");
    bytes.remove_prefix(static_cast<std::size_t>(n));
  }
  return {};
}

/// How many of `size` bytes have come before the end.
std::size_t receive_all(int socket, char* into, std::size_t size) {
  std::size_t got = 0;
  while (got < size) {
    const ssize_t n = ::recv(socket, into + got, size - got, 0);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) break;
    got += static_cast<std::size_t>(n);
  }
  return got;
}

}  // namespace

Status send_node(int socket, const TreeNode& node) {
  const std::string bytes = encode(node);
  const std::uint64_t size = bytes.size();
  TROCAR_RETURN_IF_ERROR(send_all(socket, {reinterpret_cast<const char*>(&size), sizeof size}));
  return send_all(socket, bytes);
}

void end_of_sending(int socket) {
  ::shutdown(socket, SHUT_WR);
}

Result<std::optional<TreeNode>> receive_node(int socket) {
  std::uint64_t size = 0;
  const std::size_t got = receive_all(socket, reinterpret_cast<char*>(&size), sizeof size);
  if (got == 0) return std::optional<TreeNode>();
  if (got < sizeof size || size > kLongest) return fail(ErrorCode::kCorrupt, "the HDF5 process broke off");
  std::string bytes;
  while (bytes.size() < size) {
    const std::size_t before = bytes.size();
    const std::size_t step = std::min(kStep, static_cast<std::size_t>(size) - before);
    bytes.resize(before + step);
    if (receive_all(socket, bytes.data() + before, step) < step) {
      return fail(ErrorCode::kCorrupt, "the HDF5 process broke off");
    }
  }
  std::optional<TreeNode> node = decode(bytes);
  if (!node) return fail(ErrorCode::kCorrupt, "the HDF5 process sent what is no part of a file");
  return node;
}

}  // namespace trocar::exchange
