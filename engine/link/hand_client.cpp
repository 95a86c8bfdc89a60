#include "engine/link/hand_client.h"

#include <fmt/format.h>

#include <array>
#include <asio/buffer.hpp>
#include <asio/connect.hpp>
#include <asio/io_context.hpp>
#include <asio/ip/tcp.hpp>
#include <charconv>
#include <chrono>
#include <exception>
#include <thread>
#include <utility>

#include "engine/link/frame_reader.h"

namespace trocar::link {
namespace {

constexpr std::size_t kMostWaitingBytes = 1U << 20;

Error lost(const std::string& why) {
  return Error(ErrorCode::kIo, "the connection to the workbench is lost: " + why);
}

}  // namespace

Result<Endpoint> endpoint_from(std::string_view text) {
  const std::size_t colon = text.rfind(':');
  Endpoint endpoint;
  if (colon != std::string_view::npos) {
    std::string_view host = text.substr(0, colon);
    const std::string_view digits = text.substr(colon + 1);
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), endpoint.port);
    const bool number = error == std::errc{} && end == digits.data() + digits.size();
    if (host.size() > 2 && host.front() == '[' && host.back() == ']') host = host.substr(1, host.size() - 2);
    endpoint.host = host;
    if (number && endpoint.port > 0 && !host.empty()) return endpoint;
  }
  return fail(ErrorCode::kInvalidArgument,
              fmt::format("\"{}\" is no place like 127.0.0.1:5005: a host, a colon, a port from 1 to 65535", text));
}

struct HandClient::Impl {
  asio::io_context context;
  asio::ip::tcp::socket socket{context};
  FrameReader reader;
  std::string outbox;
  std::uint64_t sent = 0;
  std::uint64_t answered = 0;
  DelayFigures round_trips;
  DelayFigures delays;
  std::int64_t last_rtt_ns = 0;
  Ack ack;

  Status write() {
    while (!outbox.empty()) {
      asio::error_code error;
      const std::size_t count = socket.write_some(asio::buffer(outbox), error);
      if (error == asio::error::would_block) break;
      if (error) return tl::unexpected(lost(error.message()));
      outbox.erase(0, count);
    }
    if (outbox.size() > kMostWaitingBytes) return tl::unexpected(lost("it takes nothing in"));
    return {};
  }

  Status read() {
    std::array<char, 8192> bytes{};
    while (true) {
      asio::error_code error;
      const std::size_t count = socket.read_some(asio::buffer(bytes), error);
      if (error == asio::error::would_block) return {};
      if (error == asio::error::eof) return tl::unexpected(lost("it was closed"));
      if (error) return tl::unexpected(lost(error.message()));
      TROCAR_RETURN_IF_ERROR(reader.feed({bytes.data(), count}));
      while (const auto packet = reader.next()) {
        TROCAR_ASSIGN_OR_RETURN(const Message message, decode(*packet));
        TROCAR_RETURN_IF_ERROR(take(message));
      }
    }
  }

  Status take(const Message& message) {
    if (const auto* hello = std::get_if<Hello>(&message); hello != nullptr && hello->version != kVersion) {
      return fail(ErrorCode::kUnsupported,
                  fmt::format("the workbench speaks version {} of the link, not {}", hello->version, kVersion));
    }
    const auto* answer = std::get_if<Ack>(&message);
    if (answer == nullptr) return {};
    ack = *answer;
    answered = answer->sequence;
    last_rtt_ns = monotonic_ns() - answer->sent_ns;
    round_trips.add(1e-9 * static_cast<double>(last_rtt_ns));
    if (answer->delay_ns >= 0) delays.add(1e-9 * static_cast<double>(answer->delay_ns));
    return {};
  }
};

Result<HandClient> HandClient::connect(const Endpoint& to, const std::string& name, bool scripted) {
  try {
    auto impl = std::make_unique<Impl>();
    asio::ip::tcp::resolver resolver(impl->context);
    asio::connect(impl->socket, resolver.resolve(to.host, std::to_string(to.port)));
    impl->socket.set_option(asio::ip::tcp::no_delay(true));
    impl->socket.non_blocking(true);
    impl->outbox = encode(Hello{kVersion, name.substr(0, 100), clock_id(), scripted});
    TROCAR_RETURN_IF_ERROR(impl->write());
    return HandClient(std::move(impl));
  } catch (const std::exception& exception) {
    return fail(ErrorCode::kIo, fmt::format("could not connect to {}:{}: {}", to.host, to.port, exception.what()));
  }
}

HandClient::HandClient(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
HandClient::~HandClient() = default;
HandClient::HandClient(HandClient&&) noexcept = default;
HandClient& HandClient::operator=(HandClient&&) noexcept = default;

Status HandClient::send(HandFrame frame) {
  frame.sequence = ++impl_->sent;
  frame.sent_ns = monotonic_ns();
  frame.rtt_ns = impl_->last_rtt_ns;
  impl_->outbox += encode(frame);
  TROCAR_RETURN_IF_ERROR(impl_->write());
  return impl_->read();
}

Status HandClient::poll() {
  TROCAR_RETURN_IF_ERROR(impl_->write());
  return impl_->read();
}

bool HandClient::settle(double patience_s) {
  const std::int64_t until_ns = monotonic_ns() + static_cast<std::int64_t>(patience_s * 1e9);
  while (impl_->answered < impl_->sent && monotonic_ns() < until_ns) {
    if (!poll()) return impl_->answered == impl_->sent;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return impl_->answered == impl_->sent;
}

std::uint64_t HandClient::sent() const {
  return impl_->sent;
}
std::uint64_t HandClient::answered() const {
  return impl_->answered;
}
const DelayFigures& HandClient::round_trips() const {
  return impl_->round_trips;
}
const DelayFigures& HandClient::delays() const {
  return impl_->delays;
}
const Ack& HandClient::ack() const {
  return impl_->ack;
}

}  // namespace trocar::link
