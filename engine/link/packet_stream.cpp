#include "engine/link/packet_stream.h"

#include <asio/buffer.hpp>
#include <asio/write.hpp>
#include <utility>

namespace trocar::link {

void PacketStream::start(Handlers handlers) {
  handlers_ = std::move(handlers);
  asio::error_code ignored;
  socket_.set_option(asio::ip::tcp::no_delay(true), ignored);
  read();
}

void PacketStream::read() {
  socket_.async_read_some(asio::buffer(bytes_),
                          [self = shared_from_this()](const asio::error_code& error, std::size_t count) {
                            if (self->ended_) return;
                            if (error) return self->end(error == asio::error::eof ? std::string() : error.message());
                            // Who takes a packet may end the stream, and with it the handlers.
                            const auto take = self->handlers_.packet;
                            const Status fed = self->reader_.feed({self->bytes_.data(), count});
                            while (!self->ended_) {
                              auto packet = self->reader_.next();
                              if (!packet) break;
                              take(std::move(*packet));
                            }
                            if (self->ended_) return;
                            if (!fed) return self->end(fed.error().text());
                            self->read();
                          });
}

void PacketStream::send(std::string framed) {
  if (ended_ || finishing_) return;
  outbox_.push_back(std::move(framed));
  if (outbox_.size() == 1) write();
}

void PacketStream::write() {
  asio::async_write(socket_, asio::buffer(outbox_.front()),
                    [self = shared_from_this()](const asio::error_code& error, std::size_t) {
                      if (self->ended_) return;
                      if (error) return self->end(error.message());
                      self->outbox_.pop_front();
                      if (!self->outbox_.empty()) return self->write();
                      if (self->finishing_) self->close();
                    });
}

void PacketStream::finish() {
  finishing_ = true;
  if (outbox_.empty()) close();
}

void PacketStream::close() {
  ended_ = true;
  asio::error_code ignored;
  socket_.shutdown(asio::ip::tcp::socket::shutdown_both, ignored);
  socket_.close(ignored);
  // They may hold whoever holds this.
  handlers_ = {};
}

void PacketStream::end(const std::string& why) {
  if (ended_) return;
  const auto tell = std::move(handlers_.end);
  close();
  if (tell) tell(why);
}

}  // namespace trocar::link
