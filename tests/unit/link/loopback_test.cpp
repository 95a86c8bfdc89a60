// Server, relay and client over the machine's own network. Nothing here depends on how long anything takes, but that it
// comes to pass within a minute.
#include <arpa/inet.h>
#include <doctest/doctest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <chrono>
#include <functional>
#include <thread>

#include "engine/link/delay_relay.h"
#include "engine/link/frame_reader.h"
#include "engine/link/hand_client.h"
#include "engine/link/hand_server.h"

using namespace trocar;
using namespace trocar::link;

namespace {

bool comes_true(const std::function<bool()>& what) {
  const std::int64_t until_ns = monotonic_ns() + std::int64_t{60'000'000'000};
  while (monotonic_ns() < until_ns) {
    if (what()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return false;
}

HandFrame frame_at(double x) {
  HandFrame frame;
  frame.left.X_DH.p.x() = x;
  return frame;
}

Endpoint at(std::uint16_t port) {
  return {"127.0.0.1", port};
}

/// Whoever connects without being a console.
class Stranger {
 public:
  explicit Stranger(std::uint16_t port) : socket_(socket(AF_INET, SOCK_STREAM, 0)) {
    sockaddr_in place{};
    place.sin_family = AF_INET;
    place.sin_port = htons(port);
    place.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    REQUIRE(connect(socket_, reinterpret_cast<const sockaddr*>(&place), sizeof(place)) == 0);
  }
  ~Stranger() { close(socket_); }
  Stranger(const Stranger&) = delete;
  Stranger& operator=(const Stranger&) = delete;
  void say(const std::string& bytes) const {
    CHECK(::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL) == static_cast<ssize_t>(bytes.size()));
  }

 private:
  int socket_;
};

}  // namespace

TEST_CASE("hands come through server, relay and client over the loopback") {
  auto server = HandServer::listen({}).value();
  DelayRelayOptions relayed;
  relayed.to = at(server->port());
  relayed.delay.mean_s = 0.002;
  auto relay = DelayRelay::start(relayed).value();
  CHECK_FALSE(server->arrived());
  CHECK_FALSE(server->link(Tick{5}).connected);

  auto client = HandClient::connect(at(relay->port()), "test", true).value();
  constexpr int kFrames = 200;
  for (int i = 1; i <= kFrames; ++i) {
    HandFrame frame = frame_at(0.001 * i);
    frame.agent_pedal = i >= 100;
    frame.agent_presses = i >= 100 ? 1 : 0;
    REQUIRE(client.send(frame));
  }
  REQUIRE(client.settle(60.0));
  CHECK(client.answered() == kFrames);
  CHECK(client.round_trips().count() == kFrames);
  CHECK(client.round_trips().quantile_s(0.0) >= 0.002);
  CHECK(client.delays().count() == kFrames);
  CHECK(client.delays().quantile_s(0.0) >= 0.002);

  CHECK(server->arrived());
  // Up to the change of the pedal, and then on to the newest.
  simulation::WorldState seen;
  const trial::HandSample pressed = server->sample(seen);
  CHECK(pressed.agent_pedal);
  CHECK(pressed.X_DH.p.x() == 0.1);
  CHECK(server->sample(seen).X_DH.p.x() == 0.001 * kFrames);
  CHECK(server->sample(seen).X_DH.p.x() == 0.001 * kFrames);
  CHECK(server->link(Tick{1000}).connected);
  CHECK(server->link(Tick{1000}).present);
  CHECK(server->link(Tick{1000}).stamp <= Tick{1000});

  HandServerStatus status = server->status();
  CHECK(status.connected);
  CHECK(status.frames == kFrames);
  CHECK(status.dropped == 0);
  CHECK(status.lost == 0);
  CHECK(status.malformed == 0);
  CHECK(status.one_clock);
  CHECK(status.scripted);
  CHECK(status.delay_p95_s >= status.delay_p50_s);
  CHECK(status.delay_p50_s >= 0.002);
  CHECK(status.peer.starts_with("test at 127.0.0.1"));

  const auto log = relay->log();
  CHECK(log.size() == kFrames + 1);
  for (const RelayedPacket& each : log) CHECK(each.passed_ns - each.received_ns >= 2'000'000);
  CHECK(relay->status().applied.count() == kFrames + 1);
  CHECK(to_csv(log).starts_with("number,received_s,delay_ms,applied_ms\n0,0.000000,2.000,"));

  // The answers say who has the arm.
  server->tell(control::ControlState::kAgent);
  REQUIRE(client.send(frame_at(0.0)));
  REQUIRE(client.settle(60.0));
  CHECK(client.ack().authority == "agent");

  relay->cut();
  CHECK(comes_true([&] { return !server->link(Tick{0}).connected; }));
  CHECK(comes_true([&] { return !client.poll(); }));

  // Who comes back is there with the first frame.
  auto again = HandClient::connect(at(relay->port()), "test", true).value();
  CHECK(comes_true([&] { return server->status().connections == 2; }));
  CHECK_FALSE(server->arrived());
  REQUIRE(again.send(frame_at(0.5)));
  CHECK(comes_true([&] { return server->arrived(); }));
  CHECK(server->status().dropped == 0);
}

TEST_CASE("only one console is taken at a time, and a wrong one not at all") {
  auto server = HandServer::listen({}).value();
  auto first = HandClient::connect(at(server->port()), "first", true).value();
  // It keeps its place by what it sends.
  std::jthread beat([&first](const std::stop_token& stop) {
    while (!stop.stop_requested()) {
      if (!first.send(frame_at(0.1))) return;
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
  });
  CHECK(comes_true([&] { return server->arrived(); }));
  auto second = HandClient::connect(at(server->port()), "second", true).value();
  CHECK(comes_true([&] { return !second.poll(); }));
  CHECK(comes_true([&] { return server->status().refused == 1; }));
  CHECK(server->status().peer.starts_with("first"));
  beat = {};

  // A port that is taken is an error in a sentence.
  HandServerOptions taken;
  taken.port = server->port();
  const auto other = HandServer::listen(taken);
  REQUIRE_FALSE(other);
  CHECK(other.error().code() == ErrorCode::kIo);
  CHECK(HandServer::listen({"nowhere", 0}).error().code() == ErrorCode::kInvalidArgument);
}

TEST_CASE("what is malformed is dropped and counted, and a wrong length ends the connection") {
  auto server = HandServer::listen({}).value();
  {
    const Stranger stranger(server->port());
    HandFrame bent = frame_at(0.1);
    bent.left.X_DH.q.coeffs() *= 1.1;
    // Before it has greeted a hand is none; neither is a bent one, nor what is no message.
    stranger.say(encode(frame_at(0.1)) + encode(Hello{}) + encode(bent) + with_length("nonsense") +
                 encode(frame_at(0.25)));
    CHECK(comes_true([&] { return server->arrived(); }));
    CHECK(server->status().malformed == 3);
    CHECK(server->status().frames == 1);
    CHECK(server->sample({}).X_DH.p.x() == 0.25);
    stranger.say(std::string("\xFF\xFF\xFF\xFF", 4));
    CHECK(comes_true([&] { return !server->status().connected; }));
    CHECK(server->status().malformed == 4);
    CHECK_FALSE(server->link(Tick{0}).connected);
  }
  const Stranger newer(server->port());
  Hello hello;
  hello.version = kVersion + 1;
  newer.say(encode(hello));
  CHECK(comes_true([&] { return server->status().refused == 1; }));
  CHECK(server->status().last_trouble.find("version 2") != std::string::npos);
}

TEST_CASE("a console that is not there is an error in a sentence") {
  std::uint16_t port = 0;
  {
    const auto server = HandServer::listen({}).value();
    port = server->port();
  }
  const auto client = HandClient::connect(at(port), "test", true);
  REQUIRE_FALSE(client);
  CHECK(client.error().code() == ErrorCode::kIo);
  CHECK(client.error().text().find("could not connect") != std::string::npos);
}
