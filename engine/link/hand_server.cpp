#include "engine/link/hand_server.h"

#include <fmt/format.h>

#include <asio/io_context.hpp>
#include <asio/ip/tcp.hpp>
#include <asio/post.hpp>
#include <atomic>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#include "engine/core/spsc_queue.h"
#include "engine/link/delay_figures.h"
#include "engine/link/hand_inbox.h"
#include "engine/link/messages.h"
#include "engine/link/packet_stream.h"

namespace trocar::link {
namespace {

using asio::ip::tcp;

constexpr std::int64_t kSilence_ns = 2'000'000'000;
constexpr std::size_t kMostUnsent = 256;
constexpr std::size_t kQueue = 1024;

}  // namespace

struct HandServer::Impl {
  /// What of the frames is the right hand's.
  class RightHand final : public trial::OperatorInput {
   public:
    explicit RightHand(Impl& impl) : impl_(impl) {}
    trial::HandSample sample(const simulation::WorldState& seen) override {
      static_cast<void>(seen);
      impl_.drain();
      return impl_.inbox.assistant();
    }
    trial::LinkState link(Tick now) override { return impl_.watchdog.state(now, monotonic_ns(), impl_.there()); }
    std::string_view name() const override { return "TCP hand controller, right hand"; }

   private:
    Impl& impl_;
  };

  Impl() : acceptor(context), waiting_socket(context), queue(kQueue) {}

  // --- Network thread ---------------------------------------------------------------------------------------------

  void accept() {
    acceptor.async_accept(waiting_socket, [this](const asio::error_code& error) {
      if (error == asio::error::operation_aborted) return;
      if (!error) take(std::move(waiting_socket));
      waiting_socket = tcp::socket(context);
      accept();
    });
  }

  void take(tcp::socket socket) {
    if (stream && monotonic_ns() - last_packet_ns < kSilence_ns) {
      const std::lock_guard lock(mutex);
      ++told.refused;
      return;
    }
    if (stream) part("silent");
    asio::error_code unknown;
    const tcp::endpoint peer = socket.remote_endpoint(unknown);
    const std::string address = unknown ? "?" : fmt::format("{}:{}", peer.address().to_string(), peer.port());
    stream = std::make_shared<PacketStream>(std::move(socket));
    greeted = false;
    last_packet_ns = monotonic_ns();
    ++connection;
    {
      const std::lock_guard lock(mutex);
      ++told.connections;
      told.connected = true;
      told.peer = address;
      told.last_trouble.clear();
    }
    stream->start(
        {[this](const std::string& packet) { receive(packet); }, [this](const std::string& why) { part(why); }});
    stream->send(encode(Hello{kVersion, "trocar", clock}));
  }

  void part(const std::string& why) {
    live.store(0);
    if (stream) stream->close();
    stream.reset();
    const std::lock_guard lock(mutex);
    told.connected = false;
    told.last_trouble = why;
    // A wrong length ends the connection.
    if (why.starts_with("a packet of")) ++told.malformed;
  }

  void receive(const std::string& packet) {
    last_packet_ns = monotonic_ns();
    const Result<Message> message = decode(packet);
    if (!message) {
      const std::lock_guard lock(mutex);
      ++told.malformed;
      return;
    }
    if (const auto* hello = std::get_if<Hello>(&*message)) return greet(*hello);
    const auto* frame = std::get_if<HandFrame>(&*message);
    if (frame == nullptr || !greeted) {
      const std::lock_guard lock(mutex);
      ++told.malformed;
      return;
    }
    take_in(*frame);
  }

  void greet(const Hello& hello) {
    if (hello.version != kVersion) {
      {
        const std::lock_guard lock(mutex);
        ++told.refused;
      }
      return part(fmt::format("the console speaks version {} of the link, not {}", hello.version, kVersion));
    }
    greeted = true;
    one_clock = !clock.empty() && hello.clock_id == clock;
    live.store(connection);
    const std::lock_guard lock(mutex);
    told.peer = fmt::format("{} at {}", hello.name, told.peer);
    told.one_clock = one_clock;
    told.scripted = told.scripted || hello.scripted;
  }

  void take_in(const HandFrame& frame) {
    const std::int64_t now_ns = last_packet_ns;
    const std::int64_t delay_ns = one_clock ? std::max<std::int64_t>(now_ns - frame.sent_ns, 0) : -1;
    const bool pushed = queue.push(ArrivedFrame{frame, now_ns, connection});
    {
      const std::lock_guard lock(mutex);
      ++told.frames;
      if (!pushed) ++told.dropped;
      if (delay_ns >= 0) delays.add(1e-9 * static_cast<double>(delay_ns));
      if (frame.rtt_ns > 0) round_trips.add(1e-9 * static_cast<double>(frame.rtt_ns));
    }
    // Who does not read the answers gets none.
    if (stream->unsent() > kMostUnsent) return;
    const auto state = static_cast<control::ControlState>(authority.load());
    stream->send(encode(Ack{frame.sequence, frame.sent_ns, now_ns, std::string(control::to_string(state)), delay_ns}));
  }

  // --- Control thread ---------------------------------------------------------------------------------------------

  void drain() {
    while (auto arrived = queue.pop()) {
      watchdog.heard(arrived->arrived_ns, arrived->frame.present);
      heard_connection = arrived->connection;
      inbox.put(*arrived);
      dropped.store(inbox.dropped(), std::memory_order_relaxed);
      lost.store(inbox.lost(), std::memory_order_relaxed);
      unseen_presses.store(inbox.unseen_presses(), std::memory_order_relaxed);
    }
  }

  /// Who came back is there with its first frame.
  bool there() const { return heard_connection != 0 && live.load() == heard_connection; }

  asio::io_context context;
  tcp::acceptor acceptor;
  tcp::socket waiting_socket;
  std::shared_ptr<PacketStream> stream;
  std::string clock = clock_id();
  bool greeted = false;
  bool one_clock = false;
  std::int64_t last_packet_ns = 0;
  std::uint32_t connection = 0;
  std::uint16_t port = 0;

  SpscQueue<ArrivedFrame> queue;
  std::atomic<std::uint32_t> live{0};  ///< The connection that is there; 0: none.
  std::atomic<int> authority{0};
  std::atomic<std::int64_t> dropped{0};
  std::atomic<std::int64_t> lost{0};
  std::atomic<std::int64_t> unseen_presses{0};

  HandInbox inbox;
  LinkWatchdog watchdog;
  RightHand right{*this};
  trial::HandSample last;
  std::uint32_t heard_connection = 0;

  /// Between the network's thread and who asks for the status; the control loop never takes it.
  mutable std::mutex mutex;
  HandServerStatus told;
  DelayFigures delays;
  DelayFigures round_trips;

  std::jthread thread;
};

Result<std::unique_ptr<HandServer>> HandServer::listen(const HandServerOptions& options) {
  asio::error_code error;
  const auto address = asio::ip::make_address(options.address, error);
  if (error) {
    return fail(ErrorCode::kInvalidArgument, fmt::format("\"{}\" is no address of this machine", options.address));
  }
  try {
    auto impl = std::make_unique<Impl>();
    const tcp::endpoint place(address, options.port);
    impl->acceptor.open(place.protocol());
    impl->acceptor.set_option(tcp::acceptor::reuse_address(true));
    impl->acceptor.bind(place);
    impl->acceptor.listen();
    impl->port = impl->acceptor.local_endpoint().port();
    impl->accept();
    impl->thread = std::jthread([network = impl.get()] {
      try {
        network->context.run();
      } catch (const std::exception& exception) {
        network->live.store(0);
        const std::lock_guard lock(network->mutex);
        network->told.connected = false;
        network->told.last_trouble = exception.what();
      }
    });
    return std::unique_ptr<HandServer>(new HandServer(std::move(impl)));
  } catch (const std::exception& exception) {
    return fail(ErrorCode::kIo,
                fmt::format("could not listen at {}:{}: {}", options.address, options.port, exception.what()));
  }
}

HandServer::HandServer(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}

HandServer::~HandServer() {
  impl_->context.stop();
  impl_->thread = {};
  if (impl_->stream) impl_->stream->close();
}

std::uint16_t HandServer::port() const {
  return impl_->port;
}

HandServerStatus HandServer::status() const {
  const std::lock_guard lock(impl_->mutex);
  HandServerStatus status = impl_->told;
  status.dropped += impl_->dropped.load(std::memory_order_relaxed);
  status.lost = impl_->lost.load(std::memory_order_relaxed);
  status.unseen_presses = impl_->unseen_presses.load(std::memory_order_relaxed);
  status.delay_p50_s = impl_->delays.quantile_s(0.50);
  status.delay_p95_s = impl_->delays.quantile_s(0.95);
  status.delay_mean_s = impl_->delays.mean_s();
  status.delay_worst_s = impl_->delays.worst_s();
  status.rtt_p50_s = impl_->round_trips.quantile_s(0.50);
  status.rtt_p95_s = impl_->round_trips.quantile_s(0.95);
  return status;
}

bool HandServer::arrived() {
  impl_->drain();
  return impl_->there();
}

double HandServer::silent_s() {
  impl_->drain();
  return 1e-9 * static_cast<double>(impl_->watchdog.age_ns(monotonic_ns()));
}

void HandServer::pass_over() {
  impl_->drain();
  impl_->inbox.pass_over();
  if (const auto taken = impl_->inbox.taken()) impl_->last = *taken;
}

void HandServer::begin_anew() {
  pass_over();
  const std::lock_guard lock(impl_->mutex);
  impl_->delays = {};
  impl_->round_trips = {};
}

void HandServer::tell(control::ControlState state) {
  impl_->authority.store(static_cast<int>(state));
}

trial::HandSample HandServer::sample(const simulation::WorldState& seen) {
  static_cast<void>(seen);
  impl_->drain();
  if (const auto next = impl_->inbox.take()) impl_->last = *next;
  return impl_->last;
}

std::optional<trial::HandSample> HandServer::news(Tick now) {
  static_cast<void>(now);
  impl_->drain();
  const auto next = impl_->inbox.take_pedal();
  if (next) impl_->last = *next;
  return next;
}

trial::LinkState HandServer::link(Tick now) {
  return impl_->watchdog.state(now, monotonic_ns(), impl_->there());
}

trial::OperatorInput& HandServer::assistant() {
  return impl_->right;
}

}  // namespace trocar::link
