/// One TCP connection that carries packets both ways. Of this module alone: it shows asio.
#pragma once

#include <array>
#include <asio/ip/tcp.hpp>
#include <deque>
#include <functional>
#include <memory>
#include <string>

#include "engine/link/frame_reader.h"

namespace trocar::link {

/// Threads: that of its socket's context. Held by whoever uses it, and by what it waits for.
class PacketStream : public std::enable_shared_from_this<PacketStream> {
 public:
  /// `packet`: one has come, without its length. `end`: it is over, once, with "" where the other end closed it.
  struct Handlers {
    std::function<void(std::string)> packet;
    std::function<void(const std::string&)> end;
  };

  explicit PacketStream(asio::ip::tcp::socket socket) : socket_(std::move(socket)) {}

  void start(Handlers handlers);
  /// With its length in front of it. Queued; what is sent after the end is lost.
  void send(std::string framed);
  std::size_t unsent() const { return outbox_.size(); }
  /// Ends once all is written.
  void finish();
  /// Ends now, without a word to `end`.
  void close();

 private:
  void read();
  void write();
  void end(const std::string& why);

  asio::ip::tcp::socket socket_;
  Handlers handlers_;
  FrameReader reader_;
  std::array<char, 8192> bytes_{};
  std::deque<std::string> outbox_;
  bool finishing_ = false;
  bool ended_ = false;
};

}  // namespace trocar::link
