#include "engine/link/delay_relay.h"

#include <fmt/format.h>

#include <asio/connect.hpp>
#include <asio/io_context.hpp>
#include <asio/ip/tcp.hpp>
#include <asio/post.hpp>
#include <asio/steady_timer.hpp>
#include <chrono>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>

#include "engine/link/frame_reader.h"
#include "engine/link/messages.h"
#include "engine/link/packet_stream.h"

namespace trocar::link {

struct DelayRelay::Impl {
  using tcp = asio::ip::tcp;

  explicit Impl(const DelayRelayOptions& options)
      : to(options.to),
        acceptor(context),
        resolver(context),
        timer(context),
        waiting_socket(context),
        out_socket(context),
        queue(options.delay) {}

  // One connection after the other: the next is taken when the last is over.
  void accept() {
    acceptor.async_accept(waiting_socket, [this](const asio::error_code& error) {
      if (error == asio::error::operation_aborted) return;
      if (error) return accept();
      resolve();
    });
  }

  void resolve() {
    resolver.async_resolve(to.host, std::to_string(to.port),
                           [this](const asio::error_code& error, const tcp::resolver::results_type& places) {
                             if (error) return part("could not find the workbench: " + error.message());
                             out_socket = tcp::socket(context);
                             asio::async_connect(out_socket, places,
                                                 [this](const asio::error_code& failed, const tcp::endpoint&) {
                                                   if (failed)
                                                     return part("could not reach the workbench: " + failed.message());
                                                   begin();
                                                 });
                           });
  }

  void begin() {
    console = std::make_shared<PacketStream>(std::move(waiting_socket));
    workbench = std::make_shared<PacketStream>(std::move(out_socket));
    {
      const std::lock_guard lock(mutex);
      ++told.connections;
      queue.clear();
    }
    closing = false;
    console->start({[this](std::string packet) { receive(std::move(packet)); },
                    [this](const std::string& why) { console_gone(why); }});
    workbench->start({[this](const std::string& packet) {
                        if (console) console->send(with_length(packet));
                      },
                      [this](const std::string& why) { part(why.empty() ? "the workbench closed it" : why); }});
  }

  void receive(std::string packet) {
    {
      const std::lock_guard lock(mutex);
      queue.push(std::move(packet), monotonic_ns());
    }
    pass();
  }

  /// Lets go what is due, and comes back when the next is.
  void pass() {
    timer.cancel();
    std::optional<std::int64_t> due;
    while (workbench) {
      std::optional<std::string> packet;
      {
        const std::lock_guard lock(mutex);
        packet = queue.pop(monotonic_ns());
        if (packet) ++told.relayed;
        due = queue.due_ns();
      }
      if (!packet) break;
      workbench->send(with_length(*packet));
    }
    if (!workbench) return;
    if (!due) {
      if (closing) part("");
      return;
    }
    timer.expires_at(std::chrono::steady_clock::time_point(std::chrono::nanoseconds(*due)));
    timer.async_wait([this](const asio::error_code& error) {
      if (!error) pass();
    });
  }

  /// What the console sent before it left arrives yet.
  void console_gone(const std::string& why) {
    if (why.starts_with("a packet of")) {
      const std::lock_guard lock(mutex);
      ++told.malformed;
    }
    closing = true;
    pass();
  }

  void part(const std::string& why) {
    timer.cancel();
    if (console) console->close();
    if (workbench) workbench->finish();
    console.reset();
    workbench.reset();
    {
      const std::lock_guard lock(mutex);
      queue.clear();
      told.last_trouble = why;
    }
    waiting_socket = tcp::socket(context);
    accept();
  }

  Endpoint to;
  asio::io_context context;
  tcp::acceptor acceptor;
  tcp::resolver resolver;
  asio::steady_timer timer;
  tcp::socket waiting_socket;
  tcp::socket out_socket;
  std::shared_ptr<PacketStream> console;
  std::shared_ptr<PacketStream> workbench;
  bool closing = false;
  std::uint16_t port = 0;

  mutable std::mutex mutex;
  RelayQueue queue;
  DelayRelayStatus told;

  std::jthread thread;
};

Result<std::unique_ptr<DelayRelay>> DelayRelay::start(const DelayRelayOptions& options) {
  asio::error_code error;
  const auto address = asio::ip::make_address(options.address, error);
  if (error) {
    return fail(ErrorCode::kInvalidArgument, fmt::format("\"{}\" is no address of this machine", options.address));
  }
  try {
    auto impl = std::make_unique<Impl>(options);
    const Impl::tcp::endpoint place(address, options.port);
    impl->acceptor.open(place.protocol());
    impl->acceptor.set_option(Impl::tcp::acceptor::reuse_address(true));
    impl->acceptor.bind(place);
    impl->acceptor.listen();
    impl->port = impl->acceptor.local_endpoint().port();
    impl->accept();
    impl->thread = std::jthread([relay = impl.get()] {
      try {
        relay->context.run();
      } catch (const std::exception& exception) {
        const std::lock_guard lock(relay->mutex);
        relay->told.last_trouble = exception.what();
      }
    });
    return std::unique_ptr<DelayRelay>(new DelayRelay(std::move(impl)));
  } catch (const std::exception& exception) {
    return fail(ErrorCode::kIo,
                fmt::format("could not relay at {}:{}: {}", options.address, options.port, exception.what()));
  }
}

DelayRelay::DelayRelay(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}

DelayRelay::~DelayRelay() {
  impl_->context.stop();
  impl_->thread = {};
  if (impl_->console) impl_->console->close();
  if (impl_->workbench) impl_->workbench->close();
}

std::uint16_t DelayRelay::port() const {
  return impl_->port;
}

DelayRelayStatus DelayRelay::status() const {
  const std::lock_guard lock(impl_->mutex);
  DelayRelayStatus status = impl_->told;
  status.applied = impl_->queue.applied();
  return status;
}

std::vector<RelayedPacket> DelayRelay::log() const {
  const std::lock_guard lock(impl_->mutex);
  return impl_->queue.log();
}

void DelayRelay::cut() {
  asio::post(impl_->context, [relay = impl_.get()] {
    if (relay->console) relay->part("cut");
  });
}

std::string to_csv(const std::vector<RelayedPacket>& log) {
  std::string text = "number,received_s,delay_ms,applied_ms\n";
  for (const RelayedPacket& each : log) {
    const double received_s = 1e-9 * static_cast<double>(each.received_ns - log.front().received_ns);
    const double delay_ms = 1e-6 * static_cast<double>(each.due_ns - each.received_ns);
    const double applied_ms = 1e-6 * static_cast<double>(each.passed_ns - each.received_ns);
    text += fmt::format("{},{:.6f},{:.3f},{:.3f}\n", each.number, received_s, delay_ms, applied_ms);
  }
  return text;
}

}  // namespace trocar::link
